"""The inspector takes samples of what is sent: what that costs, and that a quiet publisher is heard beside a loud one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped, Twist, Vector3
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Header, String
from tf2_msgs.msg import TFMessage

from day6_core.graph import EndpointKind, Graph, Publisher
from day6_core.graph.names import OBSERVER_PREFIX
from day6_core.graph.qos import Durability, QoS
from day6_core.interfaces import copy_message, serialize, type_hash, type_name
from day6_core.ros.programs.day6_inspector.hearing import HELD, Hearing
from day6_core.ros.programs.day6_inspector.samples import MOST_TOPICS, MUCH, REST, Samples
from day6_core.ros.programs.day6_inspector.transforms import PAUSED, STILL

LATCHED = QoS(depth=1, durability=Durability.TRANSIENT_LOCAL)


class Place:
    """A graph with publishers, and one who looks."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.node = self.graph.create_node(f"{OBSERVER_PREFIX}_1")

    def says(self, topic: str, cls: Any, node: str, qos: QoS = QoS()) -> Publisher:  # noqa: B008
        by = self.graph.create_node(node)
        return by.create_publisher(topic, type_name(cls), type_hash(cls), qos, copy_message)


@pytest.fixture
def place() -> Iterator[Place]:
    yield Place()


def test_a_loud_topic_is_left_alone_for_some_looks_and_a_quiet_one_never(place: Place) -> None:
    loud, quiet = (place.says(topic, Twist, topic[1:]) for topic in ("/loud", "/quiet"))
    samples = Samples(place.node, lambda topic, cls: True)
    taken, opened = [], []
    for _ in range(2 * REST + 6):
        taken.append([each.publisher.topic for each in samples.look()])
        for _ in range(MUCH):
            loud.publish(Twist())
        quiet.publish(Twist())
        opened.append([bool(each.matched) for each in (loud, quiet)])
    assert [is_open for is_open, _ in opened[: REST + 3]] == [True, *[False] * REST, True, False]
    assert all(is_open for _, is_open in opened)
    assert taken[1].count("/loud") == 2, "of many only the newest are looked at"
    assert sum("/loud" in each for each in taken) == 3 and sum("/quiet" in each for each in taken) == len(taken) - 1
    assert place.graph.endpoints(EndpointKind.SUBSCRIPTION) == [], "nobody sees who looks"


def test_a_quiet_publisher_is_heard_beside_a_loud_one_on_its_topic(place: Place) -> None:
    loud, quiet = place.says("/cmd_vel", Twist, "loud"), place.says("/cmd_vel", Twist, "quiet")
    samples = Samples(place.node, lambda topic, cls: True)
    samples.look()
    quiet.publish(Twist(linear=Vector3(x=1.0)))
    for _ in range(100):
        loud.publish(Twist())
    assert {each.publisher.node.name for each in samples.look()} == {"loud", "quiet"}


def test_a_topic_of_two_types_and_one_whose_type_changes_are_heard(place: Place) -> None:
    first = place.says("/a", Twist, "first")
    samples = Samples(place.node, lambda topic, cls: True)
    samples.look()
    second = place.says("/a", Image, "second")
    samples.look()
    first.publish(Twist())
    second.publish(Image())
    assert {type(each.message) for each in samples.look()} == {Twist, Image}
    first.destroy()
    samples.look()
    second.publish(Image())
    assert [type(each.message) for each in samples.look()] == [Image]


def test_large_messages_count_as_many(place: Place) -> None:
    camera = place.says("/image", Image, "camera")
    samples = Samples(place.node, lambda topic, cls: True)
    samples.look()
    (tap,) = camera.matched
    tap.receive((serialize(Image(data=bytes(200_000))), 0, 1, camera, 0))
    assert [len(each.message.data) for each in samples.look()] == [200_000]
    assert not camera.matched


def test_what_cannot_be_read_is_named_and_what_has_no_numbers_is_not_listened_to(place: Place) -> None:
    unknown = place.graph.create_node("a").create_publisher("/x", "unknown_msgs/msg/X", "", QoS(), copy_message)
    broken, words = place.says("/broken", Twist, "b"), place.says("/words", String, "c")
    hearing = Hearing(place.node)
    hearing.look()
    (tap,) = broken.matched
    tap.receive((b"\0\1\0\0", 0, 1, broken, 0))
    hearing.look()
    assert hearing.facts()["unread"] == ("/broken", "/x")
    assert not unknown.matched and not words.matched
    broken.publish(Twist())
    hearing.look()
    assert hearing.facts()["unread"] == ("/x",)


def test_two_of_one_name_and_other_types_on_known_topics_end_nothing(place: Place) -> None:
    stamped = TransformStamped(header=Header(frame_id="a"), child_frame_id="b")
    said = [
        (place.says(topic, type(message), "twin"), message)
        for topic, message in {
            "/tf": Twist(),
            "/clock": Twist(),
            "/robot_description": Twist(),
            "/tf_static": TFMessage(),
            "/a": stamped,
            "/b": JointState(name=["a"]),
        }.items()
    ]
    said += [(place.says("/a", TransformStamped, "twin", LATCHED), stamped)]
    hearing = Hearing(place.node)
    hearing.look()
    for publisher, message in said:
        publisher.publish(message)
    hearing.look()
    facts = hearing.facts()
    assert len(facts["heard"]) == len(said) and facts["clock"] is None and facts["transforms"] == ()


def test_of_very_many_topics_some_are_passed_over_and_that_is_told(place: Place) -> None:
    publishers = [place.says(f"/robot{number}/cmd_vel", Twist, f"driver{number}") for number in range(MOST_TOPICS + 3)]
    hearing = Hearing(place.node)
    hearing.look()
    assert sum(bool(each.matched) for each in publishers) == MOST_TOPICS and hearing.facts()["passed_over"] == 3
    for each in publishers[:3]:
        each.destroy()
    hearing.look()
    assert hearing.facts()["passed_over"] == 0


def test_what_was_odd_is_remembered_for_a_while_and_of_a_latched_message_for_ever(place: Place) -> None:
    driver, map_server = place.says("/cmd_vel", Twist, "driver"), place.says("/goal", Twist, "planner", LATCHED)
    hearing = Hearing(place.node)
    hearing.look()
    driver.publish(Twist(linear=Vector3(x=float("nan"))))
    map_server.publish(Twist(linear=Vector3(x=float("nan"))))

    def odd() -> list[str]:
        hearing.look()
        driver.publish(Twist())
        return [each.topic for each in hearing.facts()["heard"] if each.odd]

    seen = [odd() for _ in range(HELD + 3)]
    assert seen[0] == seen[HELD] == ["/cmd_vel", "/goal"] and seen[-1] == ["/goal"]
    map_server.destroy()
    assert odd() == []


def test_a_frame_that_changes_its_parent_has_one_and_a_frame_of_two_programs_has_two(place: Place) -> None:
    time = 0
    place.graph.now_ns = lambda: time
    mover, other = place.says("/tf", TFMessage, "mover"), place.says("/tf", TFMessage, "other")
    hearing = Hearing(place.node)

    def parents(look: dict[Publisher, str]) -> set[str]:
        nonlocal time
        for publisher, parent in look.items():
            time += 1
            publisher.publish(
                TFMessage(transforms=[TransformStamped(header=Header(frame_id=parent), child_frame_id="cup")])
            )
        hearing.look()
        return {each.parent for each in hearing.facts()["transforms"]}

    hearing.look()
    assert [parents({mover: "table"}) for _ in range(3)][-1] == {"table"}
    assert [parents({mover: "hand"}) for _ in range(3)][-1] == {"hand"}
    assert [parents({mover: "table"}) for _ in range(PAUSED + 1)][-1] == {"table"}, "it is put down again"
    parents({mover: "table", other: "hand"})
    assert parents({mover: "table", other: "hand"}) == {"table", "hand"}
    for _ in range(STILL + 1):
        left = parents({mover: "table"})
    assert left == {"table"}


def test_two_programs_that_send_one_transform_are_told_if_they_differ(place: Place) -> None:
    one, other = (place.says("/tf_static", TFMessage, name, LATCHED) for name in ("one", "other"))
    hearing = Hearing(place.node)
    hearing.look()

    def apart(x: float, w: float = 1.0) -> bool:
        for publisher, (moved, turned) in {one: (0.0, 1.0), other: (x, w)}.items():
            made = TransformStamped(header=Header(frame_id="a"), child_frame_id="b")
            made.transform.translation.x, made.transform.rotation.w = moved, turned
            publisher.publish(TFMessage(transforms=[made]))
        hearing.look()
        (found,) = hearing.facts()["transforms"]
        assert found.nodes == ("/one", "/other") and found.static
        return bool(found.apart)

    assert apart(1.0) and not apart(0.0) and not apart(0.0, -1.0), "a quaternion and its negative are one rotation"
