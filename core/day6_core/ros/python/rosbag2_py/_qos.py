"""QoS profiles as bags store them: YAML with words (version 9) or numbers (before); the profiles to offer and request."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from day6_core.graph.qos import (
    COMPARED,
    INFINITE_NS,
    POLICIES,
    Choice,
    Durability,
    History,
    Limit,
    Liveliness,
    Plain,
    Reliability,
)
from day6_core.graph.qos import QoS as Profile

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile

DEFAULT_DEPTH = 10
_SECOND = 1_000_000_000
_INFINITE = (9223372036, 854775807)
_OLD_INFINITES = {(2147483647, 4294967295), (2147483647, 4294967294), (9223372036, 854775807), (0x7FFFFFFF, 0xFFFFFFFF)}
"""The values that Foxy's middlewares wrote for an infinite duration (rosbag2_storage/qos.hpp)."""


class rmw_qos_history_policy_t(IntEnum):
    """History policies under rmw's names."""

    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = History.SYSTEM_DEFAULT
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = History.KEEP_LAST
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = History.KEEP_ALL
    RMW_QOS_POLICY_HISTORY_UNKNOWN = History.UNKNOWN


class rmw_qos_reliability_policy_t(IntEnum):
    """Reliability policies under rmw's names."""

    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = Reliability.SYSTEM_DEFAULT
    RMW_QOS_POLICY_RELIABILITY_RELIABLE = Reliability.RELIABLE
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = Reliability.BEST_EFFORT
    RMW_QOS_POLICY_RELIABILITY_UNKNOWN = Reliability.UNKNOWN


class rmw_qos_durability_policy_t(IntEnum):
    """Durability policies under rmw's names."""

    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = Durability.SYSTEM_DEFAULT
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = Durability.TRANSIENT_LOCAL
    RMW_QOS_POLICY_DURABILITY_VOLATILE = Durability.VOLATILE
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = Durability.UNKNOWN


class rmw_qos_liveliness_policy_t(IntEnum):
    """Liveliness policies under rmw's names."""

    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = Liveliness.SYSTEM_DEFAULT
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = Liveliness.AUTOMATIC
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = Liveliness.MANUAL_BY_TOPIC
    RMW_QOS_POLICY_LIVELINESS_UNKNOWN = Liveliness.UNKNOWN


class QoS:
    """A profile; its setters return the same object: `QoS(10).best_effort().durability_volatile()`."""

    def __init__(self, history_depth: int = DEFAULT_DEPTH, *, profile: Profile | None = None) -> None:
        self.profile = profile if profile is not None else Profile(depth=history_depth, liveliness=Liveliness.AUTOMATIC)

    def _set(self, **values: Any) -> QoS:
        self.profile = self.profile._replace(**values)
        return self

    def keep_last(self, depth: int) -> QoS:
        return self._set(history=History.KEEP_LAST, depth=depth)

    def keep_all(self) -> QoS:
        return self._set(history=History.KEEP_ALL, depth=0)

    def reliable(self) -> QoS:
        return self._set(reliability=Reliability.RELIABLE)

    def best_effort(self) -> QoS:
        return self._set(reliability=Reliability.BEST_EFFORT)

    def transient_local(self) -> QoS:
        return self._set(durability=Durability.TRANSIENT_LOCAL)

    def durability_volatile(self) -> QoS:
        return self._set(durability=Durability.VOLATILE)

    def history(self, policy: int) -> QoS:
        return self._set(history=History(policy))

    def reliability(self, policy: int) -> QoS:
        return self._set(reliability=Reliability(policy))

    def durability(self, policy: int) -> QoS:
        return self._set(durability=Durability(policy))

    def liveliness(self, policy: int) -> QoS:
        return self._set(liveliness=Liveliness(policy))

    def deadline(self, duration: Any) -> QoS:
        return self._set(deadline=_nanoseconds(duration))

    def lifespan(self, duration: Any) -> QoS:
        return self._set(lifespan=_nanoseconds(duration))

    def liveliness_lease_duration(self, duration: Any) -> QoS:
        return self._set(liveliness_lease_duration=_nanoseconds(duration))

    def avoid_ros_namespace_conventions(self, avoid: bool) -> QoS:
        return self._set(avoid_ros_namespace_conventions=avoid)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, QoS) and other.profile == self.profile

    def __hash__(self) -> int:
        return hash(self.profile)

    def __repr__(self) -> str:
        return f"QoS({self.profile})"


def _nanoseconds(duration: Any) -> int:
    return _finite(int(duration.nanoseconds))


def _finite(nanoseconds: int) -> int:
    """Return a duration with an infinite one as 0, as in graph profiles."""
    return 0 if nanoseconds >= INFINITE_NS else nanoseconds


# -- rclpy -------------------------------------------------------------------------------------------------------------


def convert_rclcpp_qos_to_rclpy_qos(qos: QoS) -> QoSProfile:
    """Return the profile as an rclpy QoSProfile, for `create_publisher` and `create_subscription`."""
    from rclpy.qos import QoSProfile

    return QoSProfile._from_graph(qos.profile, known_history=True)


def from_rclpy(profile: QoSProfile) -> QoS:
    """Return rclpy's profile as a bag stores it; policies that discovery does not transmit stay unknown."""
    found = profile.get_c_qos_profile()
    limits = (each.name for each in POLICIES.values() if isinstance(each, Limit))
    finite: dict[str, Any] = {name: _finite(getattr(found, name)) for name in limits}
    return QoS(profile=found._replace(**finite))


def offer_for(recorded: list[QoS]) -> tuple[QoS, bool]:
    """Return the profile with which a player publishes a topic, and whether the recorded publishers agreed on it.

    Depth, history and lifespan may differ (rosbag2_storage, adapt_offer_to_recorded_offers).
    """
    if not recorded:
        return QoS(), True
    first = recorded[0].profile
    if all(_compatibility(each.profile) == _compatibility(first) for each in recorded[1:]):
        return QoS(profile=first._replace(history=History.KEEP_LAST, depth=DEFAULT_DEPTH)), True
    return QoS(), False


def _compatibility(profile: Profile) -> tuple[Any, ...]:
    return tuple(getattr(profile, each.name) for each in COMPARED)


# -- text --------------------------------------------------------------------------------------------------------------


def yaml_lines(profiles: Iterable[QoS], indent: str = "", *, word: Callable[[Any], str] | None = None) -> list[str]:
    """Return the lines of the YAML list of profiles as rosbag2 writes it (version 9), each after `indent`.

    `word` writes a policy; older versions have its number.
    """
    word = word or _word
    lines: list[str] = []
    for qos in profiles:
        entry = [line for each in POLICIES.values() for line in _lines(each, getattr(qos.profile, each.name), word)]
        lines += [f"{indent}{'- ' if number == 0 else '  '}{line}" for number, line in enumerate(entry)]
    return lines


def _word(policy: IntEnum) -> str:
    return policy.name.lower()


def _lines(policy: Choice | Limit | Plain, value: Any, word: Callable[[Any], str]) -> list[str]:
    if isinstance(policy, Limit):
        seconds, rest = divmod(value, _SECOND) if value else _INFINITE
        return [f"{policy.name}:", f"  sec: {seconds}", f"  nsec: {rest}"]
    return [f"{policy.name}: {word(value) if isinstance(policy, Choice) else str(value).lower()}"]


def from_yaml(text: Any) -> list[QoS]:
    """Return the profiles in a YAML text (or in its loaded value), with words or numbers.

    Raises ValueError for anything that isn't a list of profiles.
    """
    if isinstance(text, str):
        if not text.strip():
            return []
        import yaml

        try:
            text = yaml.safe_load(text)
        except yaml.YAMLError:
            raise ValueError("the QoS profiles of a topic are not YAML") from None
    if text is None:
        return []
    if not isinstance(text, list) or not all(isinstance(each, dict) for each in text):
        raise ValueError("the QoS profiles of a topic are not a list of profiles")
    try:
        return [_profile(each) for each in text]
    except TypeError as error:
        raise ValueError(f"a QoS profile of a topic is wrong: {error}") from None


def to_rclcpp_qos_vector(text: str, version: int) -> list[QoS]:
    """Return the profiles in a text from a bag of metadata `version` (the text itself shows the format)."""
    return from_yaml(text)


def _profile(entry: dict[str, Any]) -> QoS:
    return QoS(profile=Profile(**{each.name: _value(each, entry.get(each.name, 0)) for each in POLICIES.values()}))


def _value(policy: Choice | Limit | Plain, written: Any) -> Any:
    if isinstance(policy, Limit):
        return _duration(written)
    return _policy(policy.values, written) if isinstance(policy, Choice) else policy.values(written)


def _policy(kind: type[IntEnum], value: Any) -> Any:
    try:
        return kind[value.upper()] if isinstance(value, str) else kind(value)
    except (KeyError, ValueError):
        return kind["UNKNOWN"]


def _duration(entry: Any) -> int:
    if not isinstance(entry, dict):
        return 0
    seconds, rest = int(entry.get("sec", 0)), int(entry.get("nsec", 0))
    return 0 if (seconds, rest) in _OLD_INFINITES else seconds * _SECOND + rest
