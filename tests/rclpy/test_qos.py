"""QoS profiles: what is needed at least, defaults, predefined ones, names of choices, texts, and which fit together."""

from __future__ import annotations

from typing import Any

import pytest

from rclpy import qos
from rclpy.duration import Duration, Infinite
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    LivelinessPolicy,
    QoSCompatibility,
    QoSPolicyKind,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_policy_name_from_kind,
)

NAMES = (
    "history",
    "depth",
    "reliability",
    "durability",
    "lifespan",
    "deadline",
    "liveliness",
    "liveliness_lease_duration",
    "avoid_ros_namespace_conventions",
)
ZERO = Duration()
BEST = Duration(nanoseconds=2**63 - 2)


def values(profile: QoSProfile) -> tuple[Any, ...]:
    return tuple(getattr(profile, name) for name in NAMES)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"depth": 3}, (1, 3, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ({"history": HistoryPolicy.KEEP_ALL}, (2, None, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ({"history": 2, "depth": 7}, (2, 7, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        (
            {
                "depth": 1,
                "reliability": 2,
                "durability": 1,
                "lifespan": Duration(seconds=1),
                "deadline": Duration(seconds=2),
                "liveliness": 3,
                "liveliness_lease_duration": Duration(seconds=3),
                "avoid_ros_namespace_conventions": True,
            },
            (1, 1, 2, 1, Duration(seconds=1), Duration(seconds=2), 3, Duration(seconds=3), True),
        ),
    ],
)
def test_what_is_not_given_has_its_default(given: dict[str, Any], expected: tuple[Any, ...]) -> None:
    found = values(QoSProfile(**given))
    assert found[:1] + found[2:] == expected[:1] + expected[2:]
    if expected[1] is not None:
        assert found[1] == expected[1]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("unknown", (3, 0, 3, 3, ZERO, ZERO, 4, ZERO, False)),
        ("default", (1, 10, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ("system_default", (0, 0, 0, 0, ZERO, ZERO, 0, ZERO, False)),
        ("sensor_data", (1, 5, 2, 2, ZERO, ZERO, 0, ZERO, False)),
        ("services_default", (1, 10, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ("parameters", (1, 1000, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ("parameter_events", (1, 1000, 1, 2, ZERO, ZERO, 0, ZERO, False)),
        ("action_status_default", (1, 1, 1, 1, ZERO, ZERO, 0, ZERO, False)),
        ("best_available", (1, 10, 4, 4, ZERO, BEST, 5, BEST, False)),
        ("rosout_default", (1, 1000, 1, 1, Duration(seconds=10), ZERO, 0, ZERO, False)),
    ],
)
def test_the_predefined_profiles_are_those_of_rmw(name: str, expected: tuple[Any, ...]) -> None:
    profile = QoSPresetProfiles.get_from_short_key(name)
    assert values(profile) == expected
    assert profile is QoSPresetProfiles[name.upper()].value
    assert getattr(qos, f"qos_profile_{name}") == profile
    assert name in QoSPresetProfiles.short_keys()


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: QoSProfile(), InvalidQoSProfileException, "^History and/or depth settings are required.$"),
        (
            lambda: QoSProfile(history=1),
            InvalidQoSProfileException,
            "^History set to KEEP_LAST without a depth setting.$",
        ),
        (lambda: QoSProfile(depth="1"), AssertionError, None),
        (lambda: QoSProfile(history="1", depth=1), AssertionError, None),
        (lambda: QoSProfile(depth=1, reliability="1"), AssertionError, None),
        (lambda: QoSProfile(depth=1, durability="1"), AssertionError, None),
        (lambda: QoSProfile(depth=1, liveliness="1"), AssertionError, None),
        (lambda: QoSProfile(depth=1, lifespan=1), AssertionError, None),
        (lambda: QoSProfile(depth=1, deadline=1), AssertionError, None),
        (lambda: QoSProfile(depth=1, liveliness_lease_duration=1), AssertionError, None),
        (lambda: QoSProfile(depth=1, avoid_ros_namespace_conventions=1), AssertionError, None),
        (lambda: QoSProfile(depth=1, history=9), ValueError, "9 is not a valid"),
        (lambda: QoSProfile(depth=1, reliability=9), ValueError, "9 is not a valid"),
        (lambda: QoSProfile(depth=1, durability=9), ValueError, "9 is not a valid"),
        (lambda: QoSProfile(depth=1, liveliness=2), ValueError, "2 is not a valid"),
        (lambda: QoSProfile(depth=1, wrong=1), (TypeError, AssertionError), "wrong"),
    ],
)
def test_a_profile_that_cannot_be_is_refused(make: Any, error: Any, message: str | None) -> None:
    with pytest.raises(error, match=message):
        make()


def test_a_profile_without_any_depth_is_warned_of() -> None:
    with pytest.warns(UserWarning, match=r"A zero depth with KEEP_LAST doesn't make sense; no data could be stored."):
        QoSProfile(depth=0)
    with pytest.warns(UserWarning, match="This will be interpreted as SYSTEM_DEFAULT"):
        QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=0)


@pytest.mark.filterwarnings("error")
def test_a_depth_of_zero_with_another_history_is_nothing_to_warn_of() -> None:
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=0).depth == 0


@pytest.mark.parametrize(("name", "other"), [("depth", 4), ("reliability", 2), ("durability", 1), ("deadline", BEST)])
def test_profiles_are_equal_when_every_policy_is(name: str, other: Any) -> None:
    one, two = QoSProfile(depth=3), QoSProfile(depth=3)
    assert one == two
    assert one != 3
    setattr(two, name, other)
    assert getattr(two, name) == other
    assert one != two


def test_a_profile_shows_all_its_policies() -> None:
    assert str(QoSProfile(depth=3, lifespan=Infinite)) == (
        "QoSProfile(history=1, depth=3, reliability=1, durability=2, lifespan=Infinite, "
        "deadline=0 nanoseconds, liveliness=0, liveliness_lease_duration=0 nanoseconds, "
        "avoid_ros_namespace_conventions=False)"
    )


@pytest.mark.parametrize(
    ("policy", "keys"),
    [
        (HistoryPolicy, ["system_default", "keep_last", "keep_all", "unknown"]),
        (ReliabilityPolicy, ["system_default", "reliable", "best_effort", "unknown", "best_available"]),
        (DurabilityPolicy, ["system_default", "transient_local", "volatile", "unknown", "best_available"]),
        (LivelinessPolicy, ["system_default", "automatic", "manual_by_topic", "unknown", "best_available"]),
    ],
)
def test_choices_have_short_names_for_command_lines(policy: Any, keys: list[str]) -> None:
    assert policy.short_keys() == keys
    for key in keys:
        assert policy.get_from_short_key(key.title()) == policy[key.upper()].value
        assert policy[key.upper()].short_key == key
    with pytest.raises(KeyError):
        policy.get_from_short_key("nothing")


@pytest.mark.parametrize(
    ("policy", "old", "new"),
    [
        (HistoryPolicy, "RMW_QOS_POLICY_HISTORY_KEEP_ALL", "KEEP_ALL"),
        (ReliabilityPolicy, "RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT", "BEST_EFFORT"),
        (DurabilityPolicy, "RMW_QOS_POLICY_DURABILITY_VOLATILE", "VOLATILE"),
        (LivelinessPolicy, "RMW_QOS_POLICY_LIVELINESS_AUTOMATIC", "AUTOMATIC"),
    ],
)
def test_the_old_names_of_choices_work_with_a_warning(policy: Any, old: str, new: str) -> None:
    name = policy.__name__
    with pytest.warns(UserWarning, match=rf"{name}\.{old} is deprecated. Use {name}\.{new} instead"):
        assert getattr(policy, old) is policy[new]


@pytest.mark.parametrize("kind", list(QoSPolicyKind))
def test_a_kind_of_policy_is_named_by_its_number(kind: QoSPolicyKind) -> None:
    assert qos_policy_name_from_kind(int(kind)) == kind.name


def test_the_numbers_of_the_kinds_of_policies_are_rmws() -> None:
    assert [int(kind) for kind in QoSPolicyKind] == [1, 2, 4, 8, 16, 32, 64, 128, 256, 512]


def test_the_profile_of_the_middleware_has_the_same_policies() -> None:
    profile = QoSProfile(
        depth=4,
        deadline=Duration(seconds=1),
        lifespan=Duration(seconds=2),
        liveliness_lease_duration=Duration(seconds=3),
    )
    assert QoSProfile(**profile.get_c_qos_profile().to_dict()) == profile


OK, WARNING, ERROR = QoSCompatibility.OK, QoSCompatibility.WARNING, QoSCompatibility.ERROR


@pytest.mark.parametrize(
    ("offer", "wish", "expected"),
    [
        ({}, {}, (OK, "")),
        ({}, {"reliability": 2}, (OK, "")),
        ({"durability": 1}, {}, (OK, "")),
        ({"reliability": 2}, {}, (ERROR, "ERROR: Best effort publisher and reliable subscription;")),
        ({}, {"durability": 1}, (ERROR, "ERROR: Volatile publisher and transient local subscription;")),
        (
            {},
            {"deadline": Duration(seconds=1)},
            (ERROR, "ERROR: Subscription has a deadline, but publisher does not;"),
        ),
        ({"deadline": Duration(seconds=1)}, {"deadline": Duration(seconds=1)}, (OK, "")),
        ({"deadline": Duration(seconds=1)}, {}, (OK, "")),
        (
            {"deadline": Duration(seconds=1)},
            {"deadline": Duration(seconds=0.5)},
            (ERROR, "ERROR: Subscription deadline is less than publisher deadline;"),
        ),
        (
            {"liveliness": 1},
            {"liveliness": 3},
            (ERROR, "ERROR: Publisher's liveliness is automatic and subscription's is manual by topic;"),
        ),
        ({"liveliness": 3}, {"liveliness": 1}, (OK, "")),
        (
            {},
            {"liveliness_lease_duration": Duration(seconds=1)},
            (ERROR, "ERROR: Subscription has a liveliness lease duration, but publisher does not;"),
        ),
        (
            {"liveliness_lease_duration": Duration(seconds=1)},
            {"liveliness_lease_duration": Duration(seconds=1)},
            (OK, ""),
        ),
        (
            {"liveliness_lease_duration": Duration(seconds=2)},
            {"liveliness_lease_duration": Duration(seconds=1)},
            (ERROR, "ERROR: Subscription liveliness lease duration is less than publisher;"),
        ),
        (
            {"reliability": 2, "durability": 2},
            {"reliability": 1, "durability": 1},
            (
                ERROR,
                (
                    "ERROR: Best effort publisher and reliable subscription;"
                    "ERROR: Volatile publisher and transient local subscription;"
                ),
            ),
        ),
        (
            {"reliability": 0},
            {"reliability": 3},
            (WARNING, "WARNING: Publisher reliability is system_default and subscription reliability is unknown;"),
        ),
        (
            {"reliability": 2},
            {"reliability": 0},
            (WARNING, "WARNING: Best effort publisher, but subscription is system_default;"),
        ),
        (
            {"reliability": 3},
            {},
            (WARNING, "WARNING: Reliable subscription, but publisher is unknown;"),
        ),
        ({"reliability": 1}, {"reliability": 0}, (OK, "")),
        (
            {"durability": 0},
            {"durability": 0},
            (
                WARNING,
                "WARNING: Publisher durabilty is system_default and subscription durability is system_default;",
            ),
        ),
        (
            {"durability": 2},
            {"durability": 0},
            (WARNING, "WARNING: Volatile publisher, but subscription is system_default;"),
        ),
        (
            {"durability": 0},
            {"durability": 1},
            (WARNING, "WARNING: Transient local subscription, but publisher is system_default;"),
        ),
        (
            {"liveliness": 4},
            {"liveliness": 0},
            (WARNING, "WARNING: Publisher liveliness is unknown and subscription liveliness is system_default;"),
        ),
        (
            {"liveliness": 1},
            {"liveliness": 0},
            (WARNING, "WARNING: Publisher's liveliness is automatic, but subscription's is system_default;"),
        ),
        (
            {"liveliness": 0},
            {"liveliness": 3},
            (WARNING, "WARNING: Subscription's liveliness is manual by topic, but publisher's is system_default;"),
        ),
        (
            {"reliability": 2, "durability": 0},
            {},
            (ERROR, "ERROR: Best effort publisher and reliable subscription;"),
        ),
    ],
)
def test_two_profiles_fit_together_or_the_reason_is_told(
    offer: dict[str, Any], wish: dict[str, Any], expected: tuple[QoSCompatibility, str]
) -> None:
    # Liveliness is given, for one left open on both sides is a warning of its own.
    publisher = QoSProfile(depth=1, **{"liveliness": 1, **offer})
    subscription = QoSProfile(depth=1, **{"liveliness": 1, **wish})
    assert qos_check_compatible(publisher, subscription) == expected
