"""Rebuilds metadata.yaml from the files of a bag; the files themselves stay as they are, even those that were cut off."""

from __future__ import annotations

import re
from pathlib import Path

from rosbag2_py._console import Log, to_console
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._reader import SequentialReader
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    Duration,
    StorageOptions,
    TopicInformation,
    nanoseconds_of,
)

_FILE = re.compile(r"(\d+)_.+_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d\.[a-zA-Z0-9]+|.+_(\d+)\.[a-zA-Z0-9]+")
"""A file of a bag as it is called since Lyrical, and before."""


class Reindexer:
    """Rebuilds the metadata of bags."""

    def __init__(self, log: Log = to_console) -> None:
        self._log = log

    def reindex(self, storage_options: StorageOptions) -> None:
        """Write metadata.yaml for the folder `uri`. Raises RuntimeError if files are missing or unreadable."""
        folder = Path(storage_options.uri)
        self._log("INFO", "rosbag2_cpp", f"Beginning reindexing bag in directory: {storage_options.uri}")
        if not any(folder.iterdir()):
            raise RuntimeError("Empty directory.")
        found = [(match, path) for path in folder.iterdir() if (match := _FILE.fullmatch(path.name))]
        files = [path for _, path in sorted(found, key=lambda each: int(each[0][1] or each[0][2]))]
        if not files:
            raise RuntimeError("No storage files found for reindexing. Abort")
        parts = [self._metadata_of(path, storage_options.storage_id) for path in files]
        MetadataIo().write_metadata(str(folder), _merged(parts))
        self._log("INFO", "rosbag2_cpp", "Reindexing complete.")

    def _metadata_of(self, path: Path, storage_id: str) -> BagMetadata:
        reader = SequentialReader(self._log)
        reader.open(StorageOptions(str(path), storage_id))
        metadata = reader.get_metadata()
        reader.close()
        return metadata


def _merged(parts: list[BagMetadata]) -> BagMetadata:
    """The metadata of all files; as in rosbag2_cpp the durations are added up, and `files` stays empty."""
    topics: dict[str, TopicInformation] = {}
    for part in parts:
        for each in part.topics_with_message_count:
            known = topics.get(each.topic_metadata.name)
            if known is None:
                topics[each.topic_metadata.name] = each
            else:
                known.message_count += each.message_count
    return BagMetadata(
        storage_identifier=parts[-1].storage_identifier,
        relative_file_paths=[path for part in parts for path in part.relative_file_paths],
        duration=Duration(0, sum(nanoseconds_of(part.duration) for part in parts)),
        starting_time=BagTime(min(nanoseconds_of(part.starting_time) for part in parts)),
        message_count=sum(part.message_count for part in parts),
        topics_with_message_count=sorted(topics.values(), key=lambda each: each.topic_metadata.name),
        custom_data=next((part.custom_data for part in reversed(parts) if part.custom_data), {}),
        ros_distro=next((part.ros_distro for part in reversed(parts) if part.ros_distro), ""),
    )
