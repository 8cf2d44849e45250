"""metadata.yaml: version 9 is written (5 in Humble), formatted as by yaml-cpp; every version since 1 is read."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from day6_core.whole_file import replace_file
from rosbag2_py import _qos
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    Duration,
    FileInformation,
    TopicInformation,
    TopicMetadata,
    nanoseconds_of,
)

FILE_NAME = "metadata.yaml"
ROOT = "rosbag2_bagfile_information"
VERSION = 9


class MetadataIo:
    """Reads and writes the metadata.yaml of a bag's folder."""

    def metadata_file_exists(self, uri: str) -> bool:
        """Return whether the folder `uri` has one."""
        return (Path(uri) / FILE_NAME).is_file()

    def read_metadata(self, uri: str) -> BagMetadata:
        """Read the folder's metadata.yaml. Raises RuntimeError with the reason."""
        import yaml

        try:
            text = (Path(uri) / FILE_NAME).read_text(encoding="utf-8")
            content = yaml.safe_load(text)
            metadata = _from_dict(content[ROOT])
        except OSError as error:
            raise RuntimeError(f"Exception on parsing info file: {error.strerror}: {FILE_NAME}") from None
        except (yaml.YAMLError, LookupError, TypeError, ValueError, AttributeError) as error:
            raise RuntimeError(f"Exception on parsing info file: {_first_line(error)}") from None
        metadata.bag_size = folder_size(Path(uri))
        return metadata

    def write_metadata(self, uri: str, metadata: BagMetadata) -> None:
        """Replace the folder's metadata.yaml atomically, so that a killed process leaves a complete one."""
        text = "\n".join([f"{ROOT}:", *_lines(metadata, "  "), ""])
        replace_file(Path(uri) / FILE_NAME, text.encode("utf-8"), mode=0o666, sync=False)

    def serialize_metadata(self, metadata: BagMetadata) -> str:
        """Return the metadata as YAML, without the name at the top of the file."""
        return "\n".join(_lines(metadata, ""))

    def deserialize_metadata(self, text: str) -> BagMetadata:
        """Read the result of `serialize_metadata`. Raises RuntimeError for anything else."""
        import yaml

        try:
            return _from_dict(yaml.safe_load(text))
        except (yaml.YAMLError, LookupError, TypeError, ValueError, AttributeError) as error:
            raise RuntimeError(f"Exception on parsing info file: {_first_line(error)}") from None


def _first_line(error: Exception) -> str:
    if isinstance(error, KeyError):
        return f"{error.args[0]} is missing"
    return str(error).split("\n")[0]


def folder_size(folder: Path) -> int:
    """Return the size of the files in a folder, in bytes."""
    return sum(entry.stat().st_size for entry in folder.iterdir() if entry.is_file())


# -- writing: without yaml, which takes 10 ms, and a recording writes this every second --------------------------------


def _lines(metadata: BagMetadata, indent: str) -> list[str]:
    lines = [
        f"version: {metadata.version}",
        f"storage_identifier: {metadata.storage_identifier}",
        "duration:",
        f"  nanoseconds: {nanoseconds_of(metadata.duration)}",
        "starting_time:",
        f"  nanoseconds_since_epoch: {nanoseconds_of(metadata.starting_time)}",
        f"message_count: {metadata.message_count}",
        *_list(
            "topics_with_message_count",
            [_topic_lines(each, metadata.version) for each in metadata.topics_with_message_count],
        ),
        f"compression_format: {_scalar(metadata.compression_format)}",
        f"compression_mode: {_scalar(metadata.compression_mode)}",
        *_list("relative_file_paths", [[_scalar(path)] for path in metadata.relative_file_paths]),
        *_list("files", [_file_lines(each) for each in metadata.files]),
        *(_custom(metadata.custom_data) if metadata.version >= 6 else []),
        *([f"ros_distro: {_scalar(metadata.ros_distro)}"] if metadata.version >= 8 else []),
    ]
    return [indent + line for line in lines]


def _list(name: str, entries: list[list[str]]) -> list[str]:
    if not entries:
        return [f"{name}:", "  []"]
    lines = [f"{name}:"]
    for entry in entries:
        lines += [f"  {'- ' if number == 0 else '  '}{line}" for number, line in enumerate(entry)]
    return lines


def _topic_lines(information: TopicInformation, version: int) -> list[str]:
    topic = information.topic_metadata
    if version >= 9:
        profiles = ["  offered_qos_profiles:", *(_qos.yaml_lines(topic.offered_qos_profiles, "    ") or ["    []"])]
    else:
        text = "\n".join(_qos.yaml_lines(topic.offered_qos_profiles, word=lambda policy: str(policy.value)))
        profiles = [f"  offered_qos_profiles: {_scalar(text)}"]
    hashed = [f"  type_description_hash: {_scalar(topic.type_description_hash)}"] if version >= 7 else []
    return [
        "topic_metadata:",
        f"  name: {_scalar(topic.name)}",
        f"  type: {_scalar(topic.type)}",
        f"  serialization_format: {_scalar(topic.serialization_format)}",
        *profiles,
        *hashed,
        f"message_count: {information.message_count}",
    ]


def _file_lines(file: FileInformation) -> list[str]:
    return [
        f"path: {_scalar(file.path)}",
        "starting_time:",
        f"  nanoseconds_since_epoch: {nanoseconds_of(file.starting_time)}",
        "duration:",
        f"  nanoseconds: {nanoseconds_of(file.duration)}",
        f"message_count: {file.message_count}",
    ]


def _custom(data: dict[str, str]) -> list[str]:
    if not data:
        return ["custom_data: ~"]
    return ["custom_data:", *(f"  {_scalar(key)}: {_scalar(value)}" for key, value in data.items())]


def _scalar(text: str) -> str:
    """Return a text as a plain word if YAML reads it back unchanged, else in double quotes."""
    import re

    if re.fullmatch(r"[A-Za-z/_][A-Za-z0-9_./-]*", text) and text.lower() not in _WORDS:
        return text
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'


_WORDS = frozenset(["true", "false", "yes", "no", "on", "off", "null", "y", "n"])


# -- reading -----------------------------------------------------------------------------------------------------------


def _from_dict(content: dict[str, Any]) -> BagMetadata:
    return BagMetadata(
        version=int(content["version"]),
        storage_identifier=str(content["storage_identifier"]),
        relative_file_paths=[str(path) for path in content.get("relative_file_paths") or ()],
        files=[_file(each) for each in content.get("files") or ()],
        duration=Duration(0, int(content["duration"]["nanoseconds"])),
        starting_time=BagTime(int(content["starting_time"]["nanoseconds_since_epoch"])),
        message_count=int(content["message_count"]),
        topics_with_message_count=[_topic(each) for each in content.get("topics_with_message_count") or ()],
        compression_format=str(content.get("compression_format") or ""),
        compression_mode=str(content.get("compression_mode") or ""),
        custom_data={str(key): str(value) for key, value in (content.get("custom_data") or {}).items()},
        ros_distro=str(content.get("ros_distro") or ""),
    )


def _file(entry: dict[str, Any]) -> FileInformation:
    return FileInformation(
        path=str(entry["path"]),
        starting_time=BagTime(int(entry["starting_time"]["nanoseconds_since_epoch"])),
        duration=Duration(0, int(entry["duration"]["nanoseconds"])),
        message_count=int(entry["message_count"]),
    )


def _topic(entry: dict[str, Any]) -> TopicInformation:
    topic = entry["topic_metadata"]
    metadata = TopicMetadata(
        id=0,
        name=str(topic["name"]),
        type=str(topic["type"]),
        serialization_format=str(topic.get("serialization_format") or ""),
        offered_qos_profiles=_qos.from_yaml(topic.get("offered_qos_profiles")),
        type_description_hash=str(topic.get("type_description_hash") or ""),
    )
    return TopicInformation(metadata, int(entry["message_count"]))
