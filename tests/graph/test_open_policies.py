"""Profiles that leave policies open, settled as Fast DDS and rmw_dds_common settle them."""

from __future__ import annotations

from day6_tui.core.graph import Graph
from day6_tui.core.graph.endpoints import EventKind
from day6_tui.core.graph.qos import BEST_AVAILABLE_NS, Durability, Liveliness, QoS, Reliability

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
