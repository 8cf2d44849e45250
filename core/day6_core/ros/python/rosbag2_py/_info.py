"""The output of `ros2 bag info`, with the texts and columns of rosbag2_py/format_bag_metadata.cpp."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from day6_core.ros.differences import value
from rosbag2_py._console import Log, to_console
from rosbag2_py._files import open_file, reading
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._storage import EVENT_SUFFIX, BagMetadata, StorageOptions, TopicInformation, nanoseconds_of
from rosbag2_py._topic_filter import action_of, is_service_event, type_of_action

SECOND = 1_000_000_000
SORTING: dict[str, Callable[[TopicInformation], Any]] = {
    "name": lambda each: each.topic_metadata.name,
    "type": lambda each: each.topic_metadata.type,
    "count": lambda each: each.message_count,
}
_TOPICS = "Topic information: "


class Info:
    """Reads and prints a bag's metadata; `text`, `verbose_text` and `topic_names` return it instead."""

    def __init__(self, log: Log = to_console) -> None:
        self._log = log

    def read_metadata(self, uri: str, storage_id: str = "") -> BagMetadata:
        """Return the metadata of a bag's folder or of one of its files. Raises RuntimeError if there is none."""
        path = Path(uri)
        if not path.exists():
            raise RuntimeError(f"Bag path {uri} does not exist.")
        if MetadataIo().metadata_file_exists(uri):
            return MetadataIo().read_metadata(uri)
        if path.is_dir():
            raise RuntimeError(f"Could not find metadata in bag directory {uri}")
        file = open_file(path, storage_id, self._log)
        if file is None:
            raise RuntimeError(f"No plugin detected that could open file {uri}")
        try:
            with reading(path):
                return file.metadata()
        finally:
            file.close()

    def get_sorting_methods(self) -> set[str]:
        """Return the keys that topics can be sorted by."""
        return set(SORTING)

    def print_output(self, metadata: BagMetadata, sorting_method: str = "name") -> None:
        """Print everything."""
        print(self.text(metadata, sorting_method))

    def print_output_topic_name_only(self, metadata: BagMetadata, sorting_method: str = "name") -> None:
        """Print the names of the topics."""
        print("".join(f"{line}\n" for line in self.topic_names(metadata, sorting_method)), end="")

    def print_output_verbose(self, uri: str, metadata: BagMetadata, sorting_method: str = "name") -> None:
        """Print everything, with sizes and the numbers of requests and responses."""
        print(self.verbose_text(uri, metadata, sorting_method))

    def topic_names(self, metadata: BagMetadata, sorting_method: str = "name") -> list[str]:
        """Return the names of the topics, except service events."""
        return [each.topic_metadata.name for each in _topics(metadata, sorting_method)]

    def read_metadata_and_output_service_verbose(self, uri: str, storage_id: str = "") -> None:
        """Print everything, as `ros2 bag info -v` does."""
        print(self.verbose_text(uri, self.read_metadata(uri, storage_id)))

    def text(self, metadata: BagMetadata, sorting_method: str = "name") -> str:
        """Return the output of `ros2 bag info BAG`."""
        if not value("bag.info_names_distribution_and_services"):
            about = [_topic_line(each, None) for each in metadata.topics_with_message_count]
            return "\n".join([*_head(metadata, metadata.message_count), *_column(_TOPICS, about)]) + "\n"
        about = [
            f"Service: {service.name} | Type: {service.type} | Event Count: {service.events} | "
            f"Serialization Format: {service.serialization}"
            for service in _services(metadata, sorting_method)
        ]
        lines = _head_and_topics(metadata, sorting_method, None)
        return _all_of(lines, about, _actions(metadata, sorting_method), lambda topic, count: f"Event Count: {count}")

    def verbose_text(self, uri: str, metadata: BagMetadata, sorting_method: str = "name") -> str:
        """Return the output of `ros2 bag info -v BAG`."""
        sizes = message_sizes(uri, metadata, self._log)
        services = _services(metadata, sorting_method)
        actions = _actions(metadata, sorting_method)
        calls = _calls(uri, metadata, self._log) if services or actions else {}
        about = [
            f"Service: {service.name} | Type: {service.type} | Request Count: {calls.get(service.name, (0, 0))[0]} | "
            f"Response Count: {calls.get(service.name, (0, 0))[1]} | "
            f"Size Contribution: {file_size(sizes.get(service.name + EVENT_SUFFIX, 0))} | "
            f"Serialization Format: {service.serialization}"
            for service in services
        ]

        def counts(service: str, _: int) -> str:
            requests, responses = calls.get(service, (0, 0))
            return f"Request Count: {requests} | Response Count: {responses}"

        return _all_of(_head_and_topics(metadata, sorting_method, sizes), about, actions, counts)


class _Service(NamedTuple):
    name: str
    type: str
    events: int
    serialization: str


class _Action(NamedTuple):
    name: str
    type: str
    counts: dict[str, int]
    """The number of messages by the ends of topics' names."""
    serialization: str


_TOPICS_OF_ACTION = ("feedback", "status")
_SERVICES_OF_ACTION = ("send_goal", "cancel_goal", "get_result")


def _topics(metadata: BagMetadata, sorting_method: str) -> list[TopicInformation]:
    found = [
        each
        for each in metadata.topics_with_message_count
        if not is_service_event(each.topic_metadata.name, each.topic_metadata.type)
        and not action_of(each.topic_metadata.name, each.topic_metadata.type)
    ]
    return sorted(found, key=SORTING[sorting_method])


def _actions(metadata: BagMetadata, sorting_method: str) -> list[_Action]:
    found: dict[str, list[TopicInformation]] = {}
    for each in metadata.topics_with_message_count:
        if action := action_of(each.topic_metadata.name, each.topic_metadata.type):
            found.setdefault(action, []).append(each)
    actions = [
        _Action(
            name,
            next(
                (type_of_action(each.topic_metadata.type) for each in topics if "/action/" in each.topic_metadata.type),
                "",
            ),
            {each.topic_metadata.name.removeprefix(f"{name}/_action/"): each.message_count for each in topics},
            topics[0].topic_metadata.serialization_format,
        )
        for name, topics in found.items()
    ]
    keys = {
        "name": lambda each: each.name,
        "type": lambda each: each.type,
        "count": lambda each: sum(each.counts.values()),
    }
    return sorted(actions, key=keys[sorting_method])


def _all_of(lines: list[str], services: list[str], actions: list[_Action], counts: Callable[[str, int], str]) -> str:
    """Return the output. `counts(service, events)` tells of the messages of a service of an action."""
    lines = [*lines, *_column("Service information: ", services)]
    if not value("bag.records_actions"):
        return "\n".join(lines) + ("\n" if services else "")
    lines += [f"Actions:           {len(actions)}", "Action information: "]
    for each in actions:
        topics = sum(name in each.counts for name in _TOPICS_OF_ACTION)
        events = {name: each.counts.get(name + EVENT_SUFFIX) for name in _SERVICES_OF_ACTION}
        lines.append(
            f"  Action: {each.name} | Type: {each.type} | Topics: {topics} | "
            f"Service: {sum(count is not None for count in events.values())} | Serialization Format: {each.serialization}"
        )
        lines += [f"    Topic: {name} | Count: {each.counts.get(name, 0)}" for name in _TOPICS_OF_ACTION]
        for name, count in events.items():
            lines.append(f"    Service: {name} | {counts(f'{each.name}/_action/{name}', count or 0)}")
    return "\n".join(lines) + ("\n" if services or actions else "")


def _services(metadata: BagMetadata, sorting_method: str) -> list[_Service]:
    found = [
        each
        for each in sorted(metadata.topics_with_message_count, key=SORTING[sorting_method])
        if is_service_event(each.topic_metadata.name, each.topic_metadata.type)
    ]
    return [
        _Service(
            each.topic_metadata.name.removesuffix(EVENT_SUFFIX),
            each.topic_metadata.type.removesuffix("_Event"),
            each.message_count,
            each.topic_metadata.serialization_format,
        )
        for each in found
    ]


def _head_and_topics(metadata: BagMetadata, sorting_method: str, sizes: Mapping[str, int] | None) -> list[str]:
    services = _services(metadata, "name")
    topics = [_topic_line(each, sizes) for each in _topics(metadata, sorting_method)]
    of_actions = sum(sum(action.counts.values()) for action in _actions(metadata, "name"))
    label = "Services:          " if value("bag.records_actions") else "Service:           "
    return [
        *_head(metadata, metadata.message_count - sum(service.events for service in services) - of_actions),
        *_column(_TOPICS, topics),
        f"{label}{len(services)}",
    ]


def _head(metadata: BagMetadata, messages: int) -> list[str]:
    start = nanoseconds_of(metadata.starting_time)
    duration = nanoseconds_of(metadata.duration)
    distribution = value("bag.info_names_distribution_and_services")
    return [
        "",
        *_column("Files:             ", metadata.relative_file_paths),
        f"Bag size:          {file_size(metadata.bag_size)}",
        f"Storage id:        {metadata.storage_identifier}",
        *([f"ROS Distro:        {metadata.ros_distro or 'unknown'}"] if distribution else []),
        f"Duration:          {_seconds(duration)}s",
        f"Start:             {_moment(start)}",
        f"End:               {_moment(start + duration)}",
        f"Messages:          {messages}",
    ]


def _topic_line(information: TopicInformation, sizes: Mapping[str, int] | None) -> str:
    topic = information.topic_metadata
    size = "" if sizes is None else f"Size Contribution: {file_size(sizes.get(topic.name, 0))} | "
    return (
        f"Topic: {topic.name} | Type: {topic.type} | Count: {information.message_count} | {size}"
        f"Serialization Format: {topic.serialization_format}"
    )


def _column(title: str, entries: Sequence[str]) -> list[str]:
    if not entries:
        return [title]
    return [title + entries[0], *(" " * len(title) + entry for entry in entries[1:])]


def file_size(size: int) -> str:
    """Return a size in the largest binary unit that fits: '512 B', '1.5 KiB'."""
    value, unit = float(size), 0
    while value >= 1024 and unit < 4:
        value /= 1024
        unit += 1
    return f"{value:.{0 if unit == 0 else 1}f} {('B', 'KiB', 'MiB', 'GiB', 'TiB')[unit]}"


def _seconds(nanoseconds: int) -> str:
    return f"{nanoseconds // SECOND}.{nanoseconds % SECOND:09d}"


def _moment(nanoseconds: int) -> str:
    local = time.localtime(nanoseconds // SECOND)
    # The month is in English, whatever the locale: C++ streams start with the locale "C".
    month = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"][local.tm_mon - 1]
    day = f"{month} {local.tm_mday:2d} {local.tm_year}"
    clock = f"{local.tm_hour:02d}:{local.tm_min:02d}:{local.tm_sec:02d}.{nanoseconds % SECOND:09d}"
    return f"{day} {clock} ({_seconds(nanoseconds)})"


def message_sizes(uri: str, metadata: BagMetadata, log: Log = to_console) -> dict[str, int]:
    """Read all messages; returns the sum of their sizes in bytes by topic."""
    sizes: Counter[str] = Counter()
    for topic, data, _ in _all_messages(uri, metadata, log):
        sizes[topic] += len(data)
    return dict(sizes)


def _all_messages(uri: str, metadata: BagMetadata, log: Log) -> Iterator[tuple[str, bytes, int]]:
    from rosbag2_py._reader import SequentialReader

    reader = SequentialReader(log)
    reader.open(StorageOptions(uri, storage_id=metadata.storage_identifier))
    try:
        while reader.has_next():
            yield reader.read_next()
    finally:
        reader.close()


def _calls(uri: str, metadata: BagMetadata, log: Log) -> dict[str, tuple[int, int]]:
    """Return the numbers of different requests and responses in the events of each service."""
    from day6_core.interfaces import deserialize, get_interface

    kinds = {
        each.topic_metadata.name: get_interface(each.topic_metadata.type)
        for each in metadata.topics_with_message_count
        if each.topic_metadata.name.endswith(EVENT_SUFFIX) and each.topic_metadata.type.endswith("_Event")
    }
    seen: dict[str, tuple[set[Any], set[Any]]] = {topic: (set(), set()) for topic in kinds}
    for topic, data, _ in _all_messages(uri, metadata, log):
        if topic in kinds:
            event = deserialize(data, kinds[topic]).info
            key = (bytes(event.client_gid), event.sequence_number)
            # REQUEST_SENT and REQUEST_RECEIVED are 0 and 1, the responses 2 and 3: client and server report the same call.
            seen[topic][0 if event.event_type < 2 else 1].add(key)
    return {
        topic.removesuffix(EVENT_SUFFIX): (len(requests), len(responses))
        for topic, (requests, responses) in seen.items()
    }
