"""Options of recording and playing, with the names of the real rosbag2_py; and the file of QoS overrides."""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import timedelta
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from day6_core.graph.qos import POLICIES, Choice, Limit
from day6_core.ros import differences
from rosbag2_py._storage import ACTIONS, NEWER, Bound

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile


class ServiceRequestsSource(IntEnum):
    """The side whose introspection events replayed requests are taken from."""

    SERVICE_INTROSPECTION = 0
    CLIENT_INTROSPECTION = 1


_OLD_NAMES = {"all": "all_topics", "exclude": "exclude_regex"}
"""Humble's names and the present ones."""


@dataclass
class RecordOptions(Bound):
    """The options of a recording. `services` lists event topics, `/name/_service_event`."""

    all_topics: bool = False
    all_services: bool = False
    all_actions: bool = field(default=False, metadata=ACTIONS)
    is_discovery_disabled: bool = False
    topics: list[str] = field(default_factory=list)
    topic_types: list[str] = field(default_factory=list)
    services: list[str] = field(default_factory=list)
    actions: list[str] = field(default_factory=list, metadata=ACTIONS)
    rmw_serialization_format: str = ""
    topic_polling_interval: timedelta = timedelta(milliseconds=100)
    regex: str = ""
    exclude_regex: str = ""
    exclude_topics: list[str] = field(default_factory=list)
    exclude_topic_types: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    exclude_actions: list[str] = field(default_factory=list, metadata=ACTIONS)
    node_prefix: str = ""
    compression_mode: str = "NONE"
    compression_format: str = ""
    compression_queue_size: int = 1
    compression_threads: int = 0
    compression_threads_priority: int = 0
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    ignore_leaf_topics: bool = False
    start_paused: bool = False
    use_sim_time: bool = False
    disable_keyboard_controls: bool = False
    input_serialization_format: str = field(default="", metadata=NEWER)
    output_serialization_format: str = field(default="", metadata=NEWER)
    static_topics_uri: str = field(default="", metadata=NEWER)
    """A YAML file with topics and types that are recorded whether anybody publishes them or not."""
    statistics_max_publishing_rate: float = field(default=1.0, metadata=NEWER)
    """How often in a second lost messages are told at most; 0: never."""
    repeat_transient_local_messages: dict[str, int] = field(default_factory=dict, metadata=NEWER)
    """Topics whose last messages each new file begins with, and how many."""
    repeat_all_transient_local_depth: int = field(default=0, metadata=NEWER)
    """The same for all topics that somebody offers with transient local durability; 0: for none."""

    def __setattr__(self, name: str, value: object) -> None:
        known = name in _OLD_NAMES and differences.value("bag.options_have_old_names")
        super().__setattr__(_OLD_NAMES[name] if known else name, value)


@dataclass
class PlayOptions(Bound):
    """The options of a playback. Times are in seconds, `playback_until_timestamp` in nanoseconds since 1970 (-1: to the end)."""

    read_ahead_queue_size: int = 1000
    node_prefix: str = ""
    rate: float = 1.0
    topics_to_filter: list[str] = field(default_factory=list)
    services_to_filter: list[str] = field(default_factory=list)
    actions_to_filter: list[str] = field(default_factory=list, metadata=ACTIONS)
    regex_to_filter: str = ""
    exclude_regex_to_filter: str = ""
    exclude_topics_to_filter: list[str] = field(default_factory=list)
    exclude_service_events_to_filter: list[str] = field(default_factory=list)
    exclude_actions_to_filter: list[str] = field(default_factory=list, metadata=ACTIONS)
    topic_qos_profile_overrides: dict[str, QoSProfile] = field(default_factory=dict)
    loop: bool = False
    topic_remapping_options: list[str] = field(default_factory=list)
    clock_publish_frequency: float = 0.0
    clock_publish_on_topic_publish: bool = False
    clock_topics: list[str] = field(default_factory=list)
    delay: float = 0.0
    playback_duration: float = -1.0
    playback_until_timestamp: int = -1
    start_paused: bool = False
    start_offset: float = 0.0
    disable_keyboard_controls: bool = False
    wait_acked_timeout: int = -1
    disable_loan_message: bool = False
    publish_service_requests: bool = False
    send_actions_as_client: bool = field(default=False, metadata=ACTIONS)
    service_requests_source: ServiceRequestsSource = ServiceRequestsSource.SERVICE_INTROSPECTION
    progress_bar_update_rate: int = 0
    progress_bar_separation_lines: int = 3
    message_order: str = "received"


def qos_overrides(content: Any) -> dict[str, QoSProfile]:
    """Return the profiles of a loaded YAML file by topic. Raises ValueError or InvalidQoSProfileException."""
    if not isinstance(content, dict):
        raise ValueError("The QoS overrides must be a map from topics to profiles.")
    return {str(topic): qos_profile_of(profile) for topic, profile in content.items()}


def qos_profile_of(profile: Any) -> QoSProfile:
    """Return the profile of a map from policies to values. Raises ValueError or InvalidQoSProfileException."""
    from rclpy.qos import QoSProfile

    if not isinstance(profile, dict):
        raise ValueError("The QoS profile of a topic must be a map from policies to values.")
    values: dict[str, Any] = {}
    for key, value in profile.items():
        policy = POLICIES.get(key)
        if policy is None:
            raise ValueError(f"Unexpected key `{key}` for QoS profile.")
        if isinstance(policy, Limit):
            values[key] = duration_of(value)
        elif isinstance(policy, Choice):
            values[key] = int(policy.values[value.upper()])
        elif value < 0:
            raise ValueError(f"`{key}` may not be a negative value.")
        else:
            values[key] = value
    return QoSProfile(**values)


def duration_of(value: Any) -> Any:
    """Return a rclpy Duration of {sec: …, nsec: …}, zero of nothing. Raises ValueError."""
    from rclpy.duration import Duration

    if not value:
        return Duration()
    try:
        seconds, nanoseconds = value["sec"], value["nsec"]
    except (KeyError, TypeError):
        raise ValueError("Time overrides must include both seconds (sec) and nanoseconds (nsec).") from None
    if seconds < 0 or nanoseconds < 0:
        raise ValueError("Time duration may not be a negative value.")
    return Duration(seconds=seconds, nanoseconds=nanoseconds)
