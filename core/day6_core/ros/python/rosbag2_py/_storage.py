"""The data that describe a bag: options, topics, files, metadata. Names and arguments are those of rosbag2_py."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import timedelta
from enum import IntEnum
from functools import partial
from typing import Any, NamedTuple

from day6_core.ros.differences import value
from rosbag2_py import also
from rosbag2_py._qos import QoS, from_yaml

__getattr__ = also("_storage")

NANOSECONDS = 1_000_000_000
EVENT_SUFFIX = "/_service_event"
"""The end of the name of a service's event topic (rcl/service_introspection.h)."""
MCAP_MAGIC = b"\x89MCAP0\r\n"
"""The first and the last bytes of an MCAP file (https://mcap.dev/spec)."""


class Duration:
    """A time span in nanoseconds, like rclcpp::Duration."""

    def __init__(self, seconds: int = 0, nanoseconds: int = 0) -> None:
        self.nanoseconds = seconds * NANOSECONDS + nanoseconds

    @property
    def seconds(self) -> float:
        return self.nanoseconds / NANOSECONDS

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Duration) and other.nanoseconds == self.nanoseconds

    def __hash__(self) -> int:
        return hash(self.nanoseconds)

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self.nanoseconds})"


def nanoseconds_of(value: Any) -> int:
    """Return a number, a timedelta or anything with `nanoseconds` (Duration, Time) as whole nanoseconds."""
    if isinstance(value, timedelta):
        return (value.days * 86400 + value.seconds) * NANOSECONDS + value.microseconds * 1000
    found = getattr(value, "nanoseconds", value)
    return int(found() if callable(found) else found)


NEWER = {"if": "bag.newer_options"}
ACTIONS = {"if": "bag.records_actions"}
"""The metadata of fields that the options have only where that is so (differences.py)."""


class Bound:
    """Has only the fields of its class, as what pybind11 binds: a name that is misspelt is no silent success."""

    _made = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "_made", True)

    def __setattr__(self, name: str, value: object) -> None:
        known = type(self).__dataclass_fields__.get(name)  # type: ignore[attr-defined]
        if known is not None and self._made and "if" in known.metadata and not _is_so(known.metadata["if"]):
            known = None
        if known is None and not isinstance(getattr(type(self), name, None), property):
            place = f"{type(self).__module__}.{type(self).__name__}".replace("_options", "_transport")
            raise AttributeError(f"'{place}' object has no attribute '{name}'")
        super().__setattr__(name, value)


def _is_so(condition: str) -> bool:
    found: bool = value(condition)
    return found


@dataclass
class StorageOptions(Bound):
    """Where a bag is and how it is written. Sizes are bytes, `max_bagfile_duration` seconds; 0 means no limit."""

    uri: str
    storage_id: str = ""
    max_bagfile_size: int = 0
    max_bagfile_duration: int = 0
    max_cache_size: int = 0
    storage_preset_profile: str = ""
    storage_config_uri: str = ""
    snapshot_mode: bool = False
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)
    max_bag_files: int = field(default=0, metadata=NEWER)
    """After a split only so many files stay; 0: all."""
    max_cache_duration: int = field(default=0, metadata=NEWER)
    """Seconds that a snapshot has at most; 0: no limit."""


@dataclass
class ConverterOptions:
    """Serialization formats of the messages and of the storage; there is only 'cdr', which '' means too."""

    input_serialization_format: str = ""
    output_serialization_format: str = ""


@dataclass
class TopicMetadata:
    """One topic of a bag; `type` like 'std_msgs/msg/String'."""

    id: int
    name: str
    type: str
    serialization_format: str
    offered_qos_profiles: list[QoS] = field(default_factory=list)
    type_description_hash: str = ""

    def equals(self, other: TopicMetadata) -> bool:
        """Return whether both describe the same topic (`id` does not count)."""
        return (self.name, self.type, self.serialization_format) == (other.name, other.type, other.serialization_format)


if not value("bag.topics_have_ids"):

    class _TopicMetadata(TopicMetadata):
        """Its arguments have another order, and profiles may be the YAML text that they are in the bag."""

        def __init__(
            self,
            name: str,
            type: str,  # noqa: A002 - the real one's
            serialization_format: str,
            offered_qos_profiles: str | list[QoS] = "",
            *,
            id: int = 0,  # noqa: A002
            type_description_hash: str = "",
        ) -> None:
            profiles = (
                from_yaml(offered_qos_profiles) if isinstance(offered_qos_profiles, str) else offered_qos_profiles
            )
            super().__init__(id, name, type, serialization_format, profiles, type_description_hash)

    _TopicMetadata.__name__ = _TopicMetadata.__qualname__ = "TopicMetadata"
    TopicMetadata = _TopicMetadata  # type: ignore[misc, assignment]


@dataclass
class TopicInformation:
    """A topic with the number of its messages."""

    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class MessageDefinition:
    """The text of a message type and of the types it contains; `encoding` is 'ros2msg', 'ros2idl' or 'unknown'."""

    topic_type: str
    encoding: str
    encoded_message_definition: str
    type_hash: str


@dataclass
class FileInformation:
    """One file of a bag; times are as in `BagMetadata`."""

    path: str
    starting_time: Any
    duration: Any
    message_count: int


@dataclass
class BagMetadata:
    """The contents of metadata.yaml. `starting_time` is a BagTime, `duration` a Duration, `bag_size` bytes on the disk."""

    version: int = field(default_factory=partial(value, "bag.metadata_version"))
    bag_size: int = 0
    storage_identifier: str = ""
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileInformation] = field(default_factory=list)
    duration: Any = field(default_factory=Duration)
    starting_time: Any = 0
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ""
    compression_mode: str = ""
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ""

    def __post_init__(self) -> None:
        if isinstance(self.starting_time, int):
            self.starting_time = BagTime(self.starting_time)


class BagTime:
    """A time in nanoseconds since 1970: the used part of rclpy's Time, which the real one has here, without its import."""

    def __init__(self, nanoseconds: int = 0) -> None:
        self.nanoseconds = nanoseconds

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return the whole seconds and the remaining nanoseconds."""
        return divmod(self.nanoseconds, NANOSECONDS)

    def __eq__(self, other: object) -> bool:
        return getattr(other, "nanoseconds", None) == self.nanoseconds

    def __hash__(self) -> int:
        return hash(self.nanoseconds)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self.nanoseconds})"


@dataclass
class StorageFilter:
    """The topics to read: those listed, or whose whole names match `regex`; all if neither is given. Exclusion wins."""

    topics: list[str] = field(default_factory=list)
    services_events: list[str] = field(default_factory=list)
    regex: str = ""
    exclude_topics: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    regex_to_exclude: str = ""

    def allows(self, topic: str) -> bool:
        """Return whether messages of `topic` pass."""
        from day6_core.user_pattern import user_pattern

        event = topic.endswith(EVENT_SUFFIX)
        if topic in (self.exclude_service_events if event else self.exclude_topics):
            return False
        if self.regex_to_exclude and user_pattern(self.regex_to_exclude).fullmatch(topic):
            return False
        wanted = self.services_events if event else self.topics
        if not wanted and not self.regex:
            return True
        return topic in wanted or bool(self.regex and user_pattern(self.regex).fullmatch(topic))


class ReadOrderSortBy(IntEnum):
    """The keys by which messages can be sorted when they are read."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    """The order in which messages are read."""

    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False


def get_default_storage_id() -> str:
    """Return the default storage: 'mcap', in Humble 'sqlite3'."""
    default: str = value("bag.storage")
    return default


class BadBag(RuntimeError):
    """The file is not what its name suggests, or a part of it is damaged."""


class Message(NamedTuple):
    """A message of a bag: CDR bytes, and when it was received and sent (nanoseconds since 1970; 0: unknown)."""

    received_ns: int
    sent_ns: int
    topic: str
    data: bytes


Wanted = Callable[[str], bool]
"""Returns whether messages of the topic with this name are wanted."""
