"""Selects the topics of a recorder (rosbag2_transport/topic_filter.cpp)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.interfaces import get_interface
from day6_core.reason import named_reason
from day6_core.ros.differences import value
from day6_core.user_pattern import user_pattern
from rosbag2_py._options import RecordOptions
from rosbag2_py._storage import EVENT_SUFFIX

if TYPE_CHECKING:
    from rclpy.impl.rcutils_logger import RcutilsLogger
    from rclpy.node import Node

HIDDEN = "Hidden topics are not recorded. Enable them with --include-hidden-topics"


_OF_ACTIONS = {
    "/_action/send_goal/_service_event": ("/action/", "_SendGoal_Event"),
    "/_action/cancel_goal/_service_event": ("action_msgs/srv/", "CancelGoal_Event"),
    "/_action/get_result/_service_event": ("/action/", "_GetResult_Event"),
    "/_action/feedback": ("/action/", "_FeedbackMessage"),
    "/_action/status": ("action_msgs/msg/", "GoalStatusArray"),
}
"""How an action's topics end, what is in the names of their types, and how those end (rosbag2_cpp/action_utils.cpp)."""


def action_of(topic: str, type_name: str) -> str:
    """Return the action of which this is a topic, "" for other topics, and where actions aren't told from them."""
    if not value("bag.records_actions"):
        return ""
    for ending, (within, last) in _OF_ACTIONS.items():
        if topic.endswith(ending) and within in type_name and type_name.endswith(last):
            return topic.removesuffix(ending)
    return ""


def type_of_action(type_name: str) -> str:
    """Return the type of the action of which this is the type of an own topic."""
    return re.sub("(_SendGoal|_GetResult)?_Event$|_FeedbackMessage$", "", type_name)


def topics_of_actions(actions: Iterable[str]) -> list[str]:
    """Return the topics of actions."""
    return [action + ending for action in actions for ending in _OF_ACTIONS]


def is_service_event(topic: str, type_name: str) -> bool:
    """Return whether a topic carries the events of a service that isn't an action's."""
    is_event = topic.endswith(EVENT_SUFFIX) and "/srv/" in type_name and type_name.endswith("_Event")
    return is_event and not action_of(topic, type_name)


def is_action_selected(action: str, options: RecordOptions) -> bool:
    """Return whether the topics of an action are recorded, hidden though they are."""
    named = options.all_actions or action in options.actions or _found(options.regex, action)
    return named and action not in options.exclude_actions and not _found(options.exclude_regex, action)


class TopicFilter:
    """Selects topics of the graph. `warn(text)` is called once for each different text."""

    def __init__(
        self,
        options: RecordOptions,
        node: Node,
        warn: Callable[[str], object],
        static: Mapping[str, str] | None = None,
    ) -> None:
        """`static`: topics with their types that are wanted whether they are in the graph or not."""
        self._options = options
        self._static = static or {}
        self._node = node
        self._warn = warn
        self._warned: set[str] = set()

    @property
    def selects_from_graph(self) -> bool:
        """Whether anything but static topics is recorded."""
        options = self._options
        chosen = (options.topics, options.topic_types, options.services, options.actions, options.regex)
        return options.all_topics or options.all_services or options.all_actions or any(chosen)

    def wanted(self) -> dict[str, Any]:
        """Return the classes of the topics to record, by topic."""
        found = {}
        for name, type_name in self._static.items():
            kind = self._class_of(name, type_name)
            if kind is not None:
                found[name] = kind
        for name, types in self._node.get_topic_names_and_types() if self.selects_from_graph else ():
            if len(types) > 1:
                if self._is_selected(name, types[0]):
                    self._warn_once(
                        f"Topic '{name}' has more than one type associated. Only topics with one type are supported"
                    )
            elif self._is_selected(name, types[0]) and self._published(name):
                kind = self._class_of(name, types[0])
                if kind is not None:
                    found[name] = kind
        return found

    def _warn_once(self, text: str) -> None:
        if text not in self._warned:
            self._warned.add(text)
            self._warn(text)

    def _is_selected(self, name: str, type_name: str) -> bool:
        if action := action_of(name, type_name):
            return is_action_selected(action, self._options)
        return self._service(name) if is_service_event(name, type_name) else self._topic(name, type_name)

    def _topic(self, name: str, type_name: str) -> bool:
        options = self._options
        named = name in options.topics or type_name in options.topic_types or _found(options.regex, name)
        if not options.all_topics and not named:
            return False
        if type_name in options.exclude_topic_types or name in options.exclude_topics:
            return False
        if _found(options.exclude_regex, name):
            return False
        if not options.include_hidden_topics and any(part.startswith("_") for part in name.split("/")):
            self._warn_once(HIDDEN)
            return False
        return True

    def _service(self, name: str) -> bool:
        options = self._options
        service = name.removesuffix(EVENT_SUFFIX)
        if not options.all_services and name not in options.services and not _found(options.regex, service):
            return False
        return name not in options.exclude_service_events and not _found(options.exclude_regex, service)

    def _published(self, name: str) -> bool:
        options = self._options
        if not options.include_unpublished_topics and not self._node.count_publishers(name):
            return False
        return not options.ignore_leaf_topics or bool(self._node.count_subscribers(name))

    def _class_of(self, name: str, type_name: str) -> Any | None:
        try:
            return get_interface(type_name)
        except Exception as error:
            # Whatever is wrong with a type, the other topics are recorded.
            self._warn_once(
                f"Topic '{name}' has unknown type '{type_name}' . Only topics with known type are supported. "
                f"Reason: '{error}"
            )
            return None


def read_static_topics(path: str, log: RcutilsLogger) -> dict[str, str]:
    """Return topics and their types from a YAML file; none, with an error, if something in it is wrong."""
    if not path:
        return {}
    import yaml

    log.info(f"Reading static topics from {path}")
    key, found = "static_topics_and_types_list", {}
    try:
        content = yaml.safe_load(Path(path).read_text(encoding="utf-8"))
        if not isinstance(content, dict) or key not in content:
            raise ValueError(f"Static topics YAML file must have top-level key '{key}'")
        if not isinstance(content[key], list):
            raise ValueError(f"Top-level key '{key}' must contain a list of 'topic_name, topic_type' pairs")
        for pair in content[key]:
            if not isinstance(pair, list) or len(pair) != 2:
                raise ValueError(f"not a 'topic_name, topic_type' pair: {pair}")
            found[str(pair[0])] = str(pair[1])
    except (OSError, ValueError, yaml.YAMLError) as error:
        log.error(f"Failed to read static topics list: {named_reason(error)}")
        log.info("Cleared static topics list due to read failure.")
        return {}
    log.info(f"Read {len(found)} static topics")
    return found


def _found(pattern: str, name: str) -> bool:
    return bool(pattern) and user_pattern(pattern).search(name) is not None
