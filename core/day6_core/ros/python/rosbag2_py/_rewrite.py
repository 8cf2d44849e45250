"""`ros2 bag convert`: merges bags by time and rewrites them with other topics, storage, files or compression."""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

from rosbag2_py._compression import CompressionOptions, compression_mode_from_string
from rosbag2_py._console import Log, to_console
from rosbag2_py._options import RecordOptions
from rosbag2_py._playing import _messages
from rosbag2_py._reader import SequentialReader
from rosbag2_py._storage import ConverterOptions, MessageDefinition, StorageOptions, TopicMetadata
from rosbag2_py._topic_filter import action_of, is_action_selected, is_service_event
from rosbag2_py._writer import SequentialCompressionWriter, SequentialWriter

_STORAGE = {each.name for each in fields(StorageOptions)}
_RECORD = {each.name for each in fields(RecordOptions)}


AT_ONCE = 200
"""Messages after which `rewrite` lets other programs run."""


def bag_rewrite(
    inputs: list[StorageOptions], output_config_file: str, newer_output_config_file: str | None = None
) -> None:
    """Write the bags that the YAML file lists under 'output_bags'. Raises RuntimeError with the reason.

    Since Lyrical another file may list the bags to read, under 'input_bags': `bag_rewrite([], input_file, output_file)`.
    """
    if newer_output_config_file is not None:
        input_file, output_config_file = output_config_file, newer_output_config_file
        if not inputs and not input_file:
            raise RuntimeError("Either input_options vector or input_config_file must be provided.")
        if inputs and input_file:
            raise RuntimeError(
                "Exactly one input source must be provided: provide either input_options or input_config_file, but not both."
            )
        inputs = inputs or input_options(input_file, Path())
    for _ in rewrite(inputs, output_config_file, Path()):
        pass


def input_options(path: str, folder: Path) -> list[StorageOptions]:
    """Return the bags that a YAML file lists under 'input_bags'; paths are relative to `folder`. Raises RuntimeError."""
    bags = _listed(path, "input_bags")
    for bag in bags:
        if not bag.get("uri"):
            raise RuntimeError("Input bag StorageOptions must specify a non-empty 'uri'.")
        if not Path(folder, bag["uri"]).exists():
            raise RuntimeError(f"Bag path '{bag['uri']}' does not exist!")
    return [_storage(path, bag, "input") for bag in bags]


def rewrite(
    input_options: list[StorageOptions], output_config_file: str, folder: Path, log: Log = to_console
) -> Iterator[None]:
    """Like `bag_rewrite`, in steps; the paths of output bags are relative to `folder`."""
    outputs = _outputs(output_config_file)
    for storage, _ in outputs:
        storage.uri = str(folder / storage.uri)
    readers = []
    for options in input_options:
        reader = SequentialReader(log)
        reader.open(options)
        readers.append(reader)
    topics: dict[str, TopicMetadata] = {}
    definitions: dict[str, MessageDefinition] = {}
    for reader in readers:
        for topic in reader.get_all_topics_and_types():
            topics.setdefault(topic.name, topic)
        for definition in reader.get_all_message_definitions():
            definitions.setdefault(definition.topic_type, definition)
    writers = [_Output(storage, record, topics, definitions, log) for storage, record in outputs]
    for number, message in enumerate(heapq.merge(*map(_messages, readers), key=lambda each: each.received_ns)):
        if number % AT_ONCE == 0:
            yield
        for writer in writers:
            if message.topic in writer.topics and writer.is_in_time(message.received_ns):
                writer.writer.write(message.topic, message.data, message.received_ns, message.sent_ns)
    for writer in writers:
        writer.writer.close()


class _Output:
    """One output bag and its topics."""

    def __init__(
        self,
        storage: StorageOptions,
        record: RecordOptions,
        topics: dict[str, TopicMetadata],
        definitions: dict[str, MessageDefinition],
        log: Log,
    ) -> None:
        self._storage = storage
        mode = compression_mode_from_string(record.compression_mode)
        options = CompressionOptions(record.compression_format or "zstd", mode)
        self.writer = SequentialCompressionWriter(options, log) if mode else SequentialWriter(log)
        self.writer.open(storage, ConverterOptions("cdr", "cdr"))
        self.topics = {name for name, topic in topics.items() if _wanted(topic, record)}
        for name in sorted(self.topics):
            self.writer.create_topic(topics[name], definitions.get(topics[name].type))

    def is_in_time(self, moment: int) -> bool:
        start, end = self._storage.start_time_ns, self._storage.end_time_ns
        return (start < 0 or moment >= start) and (end < 0 or moment <= end)


def _wanted(topic: TopicMetadata, options: RecordOptions) -> bool:
    from day6_core.user_pattern import user_pattern

    name = topic.name
    if action := action_of(name, topic.type):
        return is_action_selected(action, options)
    if options.exclude_regex and user_pattern(options.exclude_regex).search(name):
        return False
    if is_service_event(name, topic.type):
        named = options.all_services or name in options.services
        return (named or bool(options.regex and user_pattern(options.regex).search(name))) and (
            name not in options.exclude_service_events
        )
    if name in options.exclude_topics or topic.type in options.exclude_topic_types:
        return False
    named = options.all_topics or name in options.topics or topic.type in options.topic_types
    return named or bool(options.regex and user_pattern(options.regex).search(name))


def _outputs(path: str) -> list[tuple[StorageOptions, RecordOptions]]:
    return [(_storage(path, bag, "output"), _record(bag)) for bag in _listed(path, "output_bags")]


def _listed(path: str, key: str) -> list[dict[str, Any]]:
    import yaml

    try:
        content = yaml.safe_load(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise RuntimeError(f"{error.strerror}: {path}") from None
    except yaml.YAMLError as error:
        raise RuntimeError(f"{path}: {error}") from None
    bags = content.get(key) if isinstance(content, dict) else None
    if not isinstance(bags, list) or not all(isinstance(bag, dict) for bag in bags):
        raise RuntimeError(f"{path}: the top-level key '{key}' must hold a sequence of bags")
    return bags


def _storage(path: str, bag: dict[str, Any], what: str) -> StorageOptions:
    if "uri" not in bag:
        raise RuntimeError(f"{path}: an {what} bag has no 'uri'")
    unknown = [key for key in bag if key not in _STORAGE | _RECORD | set(_OLD_NAMES)]
    if unknown:
        raise RuntimeError(f"{path}: unknown option '{unknown[0]}'")
    return StorageOptions(**{key: value for key, value in bag.items() if key in _STORAGE and value is not None})


_OLD_NAMES = {"all": ("all_topics", "all_services", "all_actions"), "exclude": ("exclude_regex",)}
"""Names in older files (Humble)."""


def _record(bag: dict[str, Any]) -> RecordOptions:
    found = {key: value for key, value in bag.items() if key in _RECORD and value is not None}
    for old, names in _OLD_NAMES.items():
        if old in bag:
            found.update(dict.fromkeys(names, bag[old]))
    found["services"] = [f"{name}/_service_event" for name in found.get("services", ())]
    return RecordOptions(**found)
