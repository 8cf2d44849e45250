"""Profiles that leave policies open, settled as Fast DDS and rmw_dds_common settle them."""

from __future__ import annotations

import pytest

from day6_core.graph import Graph
from day6_core.graph.endpoints import EventKind
from day6_core.graph.open_policies import is_open, resolved_for_publisher, resolved_for_subscription
from day6_core.graph.qos import (
    BEST_AVAILABLE_NS,
    CHOICES,
    POLICIES,
    Durability,
    History,
    Liveliness,
    PolicyKind,
    QoS,
    Reliability,
    is_finite,
)

SYSTEM = QoS(depth=0, reliability=Reliability.SYSTEM_DEFAULT, durability=Durability.SYSTEM_DEFAULT)
BEST = QoS(
    reliability=Reliability.BEST_AVAILABLE,
    durability=Durability.BEST_AVAILABLE,
    liveliness=Liveliness.BEST_AVAILABLE,
    deadline=BEST_AVAILABLE_NS,
    liveliness_lease_duration=BEST_AVAILABLE_NS,
)
SENSOR = QoS(reliability=Reliability.BEST_EFFORT)
LATCHED = QoS(durability=Durability.TRANSIENT_LOCAL)


def offer_and_request(offer: QoS, request: QoS, *, subscription_first: bool = False) -> tuple[QoS, QoS, bool]:
    """Make a publisher and a subscription; returns what they really have, and whether they match."""
    node = Graph().create_node("robot")

    def subscribe() -> QoS:
        return node.create_subscription("/scan", "std_msgs/msg/String", "", request).qos

    requested = subscribe() if subscription_first else None
    publisher = node.create_publisher("/scan", "std_msgs/msg/String", "", offer, lambda message: message)
    requested = requested or subscribe()
    refused = publisher.status(EventKind.INCOMPATIBLE_QOS).total_count
    assert refused + publisher.subscription_count == 1
    return publisher.qos, requested, not refused


def test_the_systems_default_of_a_publisher_suits_everybody() -> None:
    for request in (SYSTEM, QoS(), SENSOR, LATCHED):
        offered, _, match = offer_and_request(SYSTEM, request)
        assert match
        assert (offered.reliability, offered.durability) == (Reliability.RELIABLE, Durability.TRANSIENT_LOCAL)
        assert offered.depth == 1


def test_the_systems_default_of_a_subscription_takes_what_a_sensor_offers() -> None:
    _, requested, match = offer_and_request(SENSOR, SYSTEM)
    assert match
    assert (requested.reliability, requested.durability) == (Reliability.BEST_EFFORT, Durability.VOLATILE)


def test_the_best_available_is_what_all_publishers_offer() -> None:
    strict = QoS(deadline=5, liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=7)
    for offer in (QoS(), SENSOR, LATCHED, strict):
        offered, requested, match = offer_and_request(offer, BEST)
        assert match
        assert requested._replace(depth=offered.depth) == offered


def test_a_publishers_best_is_as_strict_as_its_subscriptions_ask_for() -> None:
    strict = QoS(deadline=5, liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=7)
    offered, _, match = offer_and_request(BEST, strict, subscription_first=True)
    assert match
    assert (offered.deadline, offered.liveliness, offered.liveliness_lease_duration) == (
        5,
        Liveliness.MANUAL_BY_TOPIC,
        7,
    )


def test_the_best_available_is_settled_when_the_endpoint_is_made() -> None:
    _, requested, match = offer_and_request(QoS(), BEST, subscription_first=True)
    assert requested.durability == Durability.TRANSIENT_LOCAL
    assert not match


NONE, LIMIT = 0, 50
MANUAL, AUTOMATIC = Liveliness.MANUAL_BY_TOPIC, Liveliness.AUTOMATIC


@pytest.mark.parametrize(
    ("others", "as_publisher", "as_subscription"),
    [
        ([], (1, 1, AUTOMATIC, NONE, NONE), (1, 1, MANUAL, NONE, NONE)),
        ([QoS(deadline=9)], (1, 1, AUTOMATIC, 9, NONE), (1, 2, AUTOMATIC, 9, NONE)),
        (
            [QoS(deadline=9, liveliness=MANUAL), QoS(deadline=5, liveliness_lease_duration=7)],
            (1, 1, MANUAL, 5, 7),
            (1, 2, AUTOMATIC, 9, NONE),
        ),
        (
            [QoS(liveliness=MANUAL, liveliness_lease_duration=3), QoS(liveliness=MANUAL, liveliness_lease_duration=8)],
            (1, 1, MANUAL, NONE, 3),
            (1, 2, MANUAL, NONE, 8),
        ),
        ([LATCHED, LATCHED], (1, 1, AUTOMATIC, NONE, NONE), (1, 1, AUTOMATIC, NONE, NONE)),
        ([LATCHED, QoS()], (1, 1, AUTOMATIC, NONE, NONE), (1, 2, AUTOMATIC, NONE, NONE)),
        ([SENSOR, QoS()], (1, 1, AUTOMATIC, NONE, NONE), (2, 2, AUTOMATIC, NONE, NONE)),
    ],
)
def test_the_best_is_found_among_all_others(
    others: list[QoS], as_publisher: tuple[int, ...], as_subscription: tuple[int, ...]
) -> None:
    resolved = [each.resolved() for each in others]
    for found, expected in (
        (resolved_for_publisher(BEST, resolved), as_publisher),
        (resolved_for_subscription(BEST, resolved), as_subscription),
    ):
        policies = (found.reliability, found.durability, found.liveliness)
        assert (*policies, found.deadline, found.liveliness_lease_duration) == expected
        assert found.depth == BEST.depth


def test_what_a_program_has_said_is_kept() -> None:
    said = QoS(
        depth=3, deadline=LIMIT, liveliness=MANUAL, liveliness_lease_duration=LIMIT, reliability=Reliability.BEST_EFFORT
    )
    others = [QoS(deadline=9, liveliness_lease_duration=9)]
    assert resolved_for_publisher(said, others) == said
    assert resolved_for_subscription(said, others) == said
    assert resolved_for_subscription(QoS(durability=Durability.SYSTEM_DEFAULT), []).durability == Durability.VOLATILE


@pytest.mark.parametrize(
    ("profile", "expected"),
    [
        (QoS(), False),
        (SYSTEM, True),
        (BEST, True),
        (QoS(reliability=Reliability.SYSTEM_DEFAULT), True),
        (QoS(reliability=Reliability.BEST_AVAILABLE), True),
        (QoS(durability=Durability.SYSTEM_DEFAULT), True),
        (QoS(durability=Durability.BEST_AVAILABLE), True),
        (QoS(liveliness=Liveliness.BEST_AVAILABLE), True),
        (QoS(liveliness=Liveliness.SYSTEM_DEFAULT), False),
        (QoS(deadline=BEST_AVAILABLE_NS), True),
        (QoS(liveliness_lease_duration=BEST_AVAILABLE_NS), True),
        (QoS(lifespan=BEST_AVAILABLE_NS), False),
    ],
)
def test_a_profile_is_open_where_a_choice_is_left(profile: QoS, expected: bool) -> None:
    assert is_open(profile) is expected


def test_a_profile_has_defaults() -> None:
    assert tuple(QoS()) == (10, 1, 1, 2, 0, 0, 0, 0, False)
    assert tuple(SYSTEM.resolved()) == (1, 1, 1, 2, 0, 0, 1, 0, False)
    assert tuple(QoS(history=History.SYSTEM_DEFAULT).resolved()) == (10, 1, 1, 2, 0, 0, 1, 0, False)
    assert tuple(BEST.resolved())[2:4] == (1, 2)
    assert BEST.resolved().liveliness == AUTOMATIC
    strict = QoS(depth=1, history=History.KEEP_ALL, reliability=Reliability.BEST_EFFORT, liveliness=MANUAL)
    assert strict.resolved() == strict


@pytest.mark.parametrize(
    ("profile", "capacity"),
    [(QoS(depth=3), 3), (QoS(depth=0), 1), (QoS(depth=1), 1), (QoS(depth=3, history=History.KEEP_ALL), 5000)],
)
def test_a_queue_holds_what_its_profile_says(profile: QoS, capacity: int) -> None:
    assert profile.capacity == capacity


@pytest.mark.parametrize(
    ("duration", "finite"),
    [(0, False), (1, True), (BEST_AVAILABLE_NS - 1, True), (BEST_AVAILABLE_NS, False), (2**63 - 1, False)],
)
def test_a_duration_is_a_limit_or_none(duration: int, finite: bool) -> None:
    assert is_finite(duration) is finite


def test_the_table_has_a_row_for_each_policy_of_a_profile() -> None:
    assert set(POLICIES) == set(QoS._fields) == {kind.name.lower() for kind in PolicyKind if kind != PolicyKind.INVALID}
    assert all(isinstance(getattr(QoS(), choice.name), choice.values) for choice in CHOICES)


def test_the_kinds_of_policies_have_rmws_numbers() -> None:
    assert [int(kind) for kind in PolicyKind] == [2**power for power in range(10)]
    assert [kind.name for kind in PolicyKind][:5] == ["INVALID", "DURABILITY", "DEADLINE", "LIVELINESS", "RELIABILITY"]


def test_choices_have_rmws_numbers() -> None:
    assert [int(each) for each in Reliability] == [0, 1, 2, 3, 4]
    assert [int(each) for each in Durability] == [0, 1, 2, 3, 4]
    assert [int(each) for each in History] == [0, 1, 2, 3]
    assert [int(each) for each in Liveliness] == [0, 1, 3, 4, 5]
    assert Reliability.BEST_EFFORT == Durability.VOLATILE == History.KEEP_ALL == 2
