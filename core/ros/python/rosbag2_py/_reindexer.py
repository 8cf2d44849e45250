"""Makes metadata.yaml anew from the files of a bag, and gives files that were cut off an end."""

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

_FILE = re.compile(r".+_(\d+)\.([a-zA-Z0-9])+")


class Reindexer:
    """`reindex(storage_options)`; `say(text)` gets what the real one logs."""

    def __init__(self, say: Callable[[str], None] | None = None) -> None:
        self._say = say or (lambda text: None)

    def reindex(self, storage_options: StorageOptions) -> None:
        """Write metadata.yaml for the folder `uri`. RuntimeError if there are no files in it, or none that can be read."""
        folder = Path(storage_options.uri)
        self._say(f"Beginning reindexing bag in directory: {storage_options.uri}")
        if not any(folder.iterdir()):
            raise RuntimeError("Empty directory.")
        found = [(match, path) for path in folder.iterdir() if (match := _FILE.fullmatch(path.name))]
        files = [path for _, path in sorted(found, key=lambda each: int(each[0].group(1)))]
        if not files:
            raise RuntimeError("No storage files found for reindexing. Abort")
        whole = [self._look_into(path, storage_options.storage_id) for path in files]
        MetadataIo().write_metadata(str(folder), _together(whole))
        self._say("Reindexing complete.")

    def _look_into(self, path: Path, storage_id: str) -> BagMetadata:
        file = open_file(path, storage_id)
        try:
            metadata = file.metadata()
            if file.whole:
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
        self._say(f"{path.name} had no end; it has one now, with the {metadata.message_count} messages that are in it.")
        return metadata


def _together(parts: list[BagMetadata]) -> BagMetadata:
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
