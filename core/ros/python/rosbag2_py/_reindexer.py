"""Rebuilds metadata.yaml from the files of a bag, and completes files that were cut off."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from rosbag2_py._files import create_file, open_file
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    Duration,
    MessageDefinition,
    StorageOptions,
    TopicInformation,
    nanoseconds_of,
)

_FILE = re.compile(r"(\d+)_.+_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d\.[a-zA-Z0-9]+|.+_(\d+)\.[a-zA-Z0-9]+")
"""A file of a bag as it is called since Lyrical, and before."""


class Reindexer:
    """Rebuilds the metadata of bags; `log(text)` gets the real one's log lines."""

    def __init__(self, log: Callable[[str], None] | None = None) -> None:
        self._log = log or (lambda text: None)

    def reindex(self, storage_options: StorageOptions) -> None:
        """Write metadata.yaml for the folder `uri`. Raises RuntimeError if files are missing or unreadable."""
        folder = Path(storage_options.uri)
        self._log(f"Beginning reindexing bag in directory: {storage_options.uri}")
        if not any(folder.iterdir()):
            raise RuntimeError("Empty directory.")
        found = [(match, path) for path in folder.iterdir() if (match := _FILE.fullmatch(path.name))]
        files = [path for _, path in sorted(found, key=lambda each: int(each[0][1] or each[0][2]))]
        if not files:
            raise RuntimeError("No storage files found for reindexing. Abort")
        parts = [self._metadata_of(path, storage_options.storage_id) for path in files]
        MetadataIo().write_metadata(str(folder), _merged(parts))
        self._log("Reindexing complete.")

    def _metadata_of(self, path: Path, storage_id: str) -> BagMetadata:
        file = open_file(path, storage_id)
        try:
            metadata = file.metadata()
            if file.is_complete:
                return metadata
            definitions = {each.topic_type: each for each in file.definitions()}
            repaired = path.with_name(f".{path.name}.repaired")
            repaired.unlink(missing_ok=True)
            writer = create_file(repaired, file.storage_id, "", metadata.ros_distro)
            for each in metadata.topics_with_message_count:
                topic = each.topic_metadata
                empty = MessageDefinition(topic.type, "unknown", "", "")
                writer.create_topic(topic, definitions.get(topic.type, empty))
            for message in file.messages(0, lambda topic: True, by_file=True):
                writer.write(message.topic, message.data, message.received_ns, message.sent_ns)
            writer.metadata = metadata
            writer.close()
        finally:
            file.close()
        repaired.replace(path)
        self._log(
            f"{path.name} was cut off; it is complete now, with the {metadata.message_count} messages that are in it."
        )
        return metadata


def _merged(parts: list[BagMetadata]) -> BagMetadata:
    topics: dict[str, TopicInformation] = {}
    for part in parts:
        for each in part.topics_with_message_count:
            known = topics.get(each.topic_metadata.name)
            if known is None:
                topics[each.topic_metadata.name] = each
            else:
                known.message_count += each.message_count
    written = [part for part in parts if part.message_count]
    start = min((nanoseconds_of(part.starting_time) for part in written), default=0)
    end = max((nanoseconds_of(part.starting_time) + nanoseconds_of(part.duration) for part in written), default=start)
    return BagMetadata(
        storage_identifier=parts[0].storage_identifier,
        relative_file_paths=[path for part in parts for path in part.relative_file_paths],
        files=[file for part in parts for file in part.files],
        duration=Duration(0, end - start),
        starting_time=BagTime(start),
        message_count=sum(part.message_count for part in parts),
        topics_with_message_count=sorted(topics.values(), key=lambda each: each.topic_metadata.name),
        custom_data=parts[-1].custom_data,
        ros_distro=parts[-1].ros_distro,
    )
