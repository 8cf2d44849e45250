"""The kitchen's model: who stands at which belt, what passed, and that it only looks."""

from __future__ import annotations

from dataclasses import replace

import pytest

from day6_core.graph import EndpointKind, Graph
from day6_core.graph.qos import Durability, QoS, Reliability
from day6_core.ros.programs.day6_kitchen.belts import Belt, End, Hand, KitchenFacts, Refusal, select
from day6_core.ros.programs.day6_kitchen.dishes import GAP_SECONDS, TRAVEL_SECONDS, Conveyor, Dishes
from day6_core.ros.programs.day6_kitchen.model import Kitchen
from day6_core.ros.programs.day6_kitchen.rates import Rate

STRING, INT = "std_msgs/msg/String", "std_msgs/msg/Int32"
QOS = QoS().resolved()


def facts(*ends: tuple[str, str, bool, str], nodes: tuple[str, ...] = ()) -> KitchenFacts:
    found = tuple(End(topic, node, gives, kind, QOS) for topic, node, gives, kind in ends)
    return KitchenFacts(nodes or tuple(dict.fromkeys(end.node for end in found)), found)


def test_cooks_who_give_stand_before_those_who_take() -> None:
    content = select(facts(("/b", "/last", False, STRING), ("/b", "/first", True, STRING)))
    assert [cook.name for cook in content.cooks] == ["/first", "/last"]
    assert content.belts == (Belt("/b", (Hand("/first", STRING),), (Hand("/last", STRING),)),)


def test_cooks_who_work_together_stand_together() -> None:
    given = [
        ("/map", "/mapper", True),
        ("/chatter", "/talker", True),
        ("/map", "/late", False),
        ("/chatter", "/ear", False),
    ]
    content = select(
        facts(*((topic, node, gives, STRING) for topic, node, gives in given), nodes=("/alone", *(e[1] for e in given)))
    )
    assert [cook.name for cook in content.cooks] == ["/talker", "/ear", "/mapper", "/late", "/alone"]
    chain = facts(
        ("/c", "/3", True, STRING), ("/a", "/1", True, STRING), ("/a", "/3", False, STRING), ("/b", "/x", True, STRING)
    )
    assert [cook.name for cook in select(chain).cooks] == ["/1", "/3", "/x"]


def test_another_type_is_a_refusal_and_only_for_whom_it_concerns() -> None:
    content = select(facts(("/b", "/a", True, STRING), ("/b", "/fits", False, STRING), ("/b", "/no", False, INT)))
    (belt,) = content.belts
    assert belt.refusals == (Refusal(Hand("/a", STRING), Hand("/no", INT), "type", INT),)
    assert belt.refusal_of(Hand("/no", INT)) and belt.refusal_of(Hand("/fits", STRING)) is None


def test_one_giver_who_fits_is_enough() -> None:
    content = select(facts(("/b", "/a", True, STRING), ("/b", "/z", True, INT), ("/b", "/taker", False, INT)))
    assert len(content.belts[0].refusals) == 1 and content.belts[0].refusal_of(Hand("/taker", INT)) is None


def test_qos_names_every_policy_that_does_not_match() -> None:
    offer = QoS(reliability=Reliability.BEST_EFFORT, durability=Durability.VOLATILE).resolved()
    request = QoS(reliability=Reliability.RELIABLE, durability=Durability.TRANSIENT_LOCAL).resolved()
    ends = (End("/b", "/a", True, STRING, offer), End("/b", "/t", False, STRING, request))
    (refusal,) = select(KitchenFacts(("/a", "/t"), ends)).belts[0].refusals
    assert (refusal.why, refusal.detail) == ("qos", "durability, reliability")


def test_belts_without_the_other_side_are_lonely_unless_somebody_hidden_is_there() -> None:
    assert select(facts(("/b", "/a", True, STRING))).belts[0].lonely == "unheard"
    assert select(facts(("/b", "/a", False, STRING))).belts[0].lonely == "unfilled"
    assert select(facts(("/b", "/a", True, STRING), ("/b", "/_spy", False, STRING))).belts[0].lonely == ""


def test_what_is_hidden_is_left_out_and_counted() -> None:
    given = facts(
        ("/rosout", "/a", True, STRING),
        ("/b", "/a", True, STRING),
        ("/turn/_action/status", "/a", True, STRING),
        ("/b", "/_ros2cli_77", False, STRING),
        ("/rosout", "/_ros2cli_daemon_0_x", True, STRING),
        nodes=("/a", "/_ros2cli_77", "/_ros2cli_78", "/_ros2cli_daemon_0_x"),
    )
    content = select(given)
    assert {cook.name for cook in content.cooks} == {"/a", "/_ros2cli_77"}, "ros2 topic echo takes dishes"
    assert [belt.topic for belt in content.belts] == ["/b"]
    assert set(content.hidden) == {"/_ros2cli_78", "/_ros2cli_daemon_0_x", "/rosout", "/turn/_action/status"}
    everything = select(given, everything=True)
    assert len(everything.cooks) == 4 and len(everything.belts) == 3 and not everything.hidden


def test_two_nodes_of_one_name_are_one_cook_who_is_counted_twice() -> None:
    (cook,) = select(KitchenFacts(("/talker", "/talker"), ())).cooks
    assert (cook.name, cook.count) == ("/talker", 2)


def test_the_same_type_always_looks_the_same_and_others_differ_in_their_letter() -> None:
    dishes = Dishes()
    looks = [dishes.of(f"p/msg/{name}") for name in ("Twist", "TwistStamped", "Temperature", "Pose", "String")]
    assert len({dish.text[1] for dish in looks}) == 5
    assert dishes.of("p/msg/Twist") == looks[0]
    many = [dishes.of(f"p/msg/A{number}") for number in range(200)]
    assert all(len(dish.text) == 3 and dish.text.isascii() for dish in many)


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        ("geometry_msgs/msg/Twist", "(T)"),
        ("std_msgs/msg/String", "{S}"),
        ("std_msgs/msg/Int32", "[I]"),
        ("turtlesim/msg/Pose", "<P>"),
        ("tf2_msgs/msg/TFMessage", "<F>"),
        ("sensor_msgs/msg/Image", "#M#"),
        ("sensor_msgs/msg/JointState", "\\J/"),
        ("meal_msgs/msg/Soup", "=O="),
    ],
)
def test_the_shape_of_a_dish_says_what_kind_of_message_it_is_whatever_else_was_seen_before(
    kind: str, text: str
) -> None:
    dishes = Dishes()
    dishes.of("geometry_msgs/msg/TransformStamped")
    assert dishes.of(kind).text == text
    for fine in (True, False):
        assert [len(line) for line in dishes.of(kind).lines(fine=fine)] == [5, 5]
        assert text[1] in "".join(dishes.of(kind).lines(fine=fine))


def test_who_waits_for_dishes_stands_after_those_who_make_them() -> None:
    chain = facts(
        ("/joint_states", "/wheel_spinner", True, STRING),
        ("/joint_states", "/robot_state_publisher", False, STRING),
        *((topic, "/robot_state_publisher", True, STRING) for topic in ("/tf", "/tf_static", "/robot_description")),
        *((topic, "/rviz2", False, STRING) for topic in ("/tf", "/tf_static", "/robot_description")),
        ("/clicked_point", "/rviz2", True, STRING),
    )
    content = select(chain)
    assert [cook.name for cook in content.cooks] == ["/wheel_spinner", "/robot_state_publisher", "/rviz2"]
    assert [belt.topic for belt in content.belts] == [
        "/joint_states",
        "/robot_description",
        "/tf",
        "/tf_static",
        "/clicked_point",
    ]


def test_a_command_has_the_name_that_was_typed_and_never_its_nodes() -> None:
    ends = (
        ("/a", "/_ros2cli_1004", False, STRING),
        ("/a", "/talker", True, STRING),
        ("/b", "/_ros2cli_7", True, STRING),
    )
    known = replace(facts(*ends), commands={"/_ros2cli_1004": "ros2 topic hz"})
    assert {cook.title for cook in select(known).cooks} == {"ros2 topic hz", "talker", "ros2 topic pub"}
    assert {cook.title for cook in select(facts(*ends)).cooks} == {"ros2 topic", "talker", "ros2 topic pub"}


def test_many_messages_are_few_dishes_and_one_message_is_one() -> None:
    conveyor, lane = Conveyor(), ("/b", "/a")
    conveyor.put(lane, 1)
    conveyor.advance(0.0)
    assert conveyor.on_the_way(lane, 0.9) == [0.9 / TRAVEL_SECONDS]
    conveyor.advance(TRAVEL_SECONDS + 0.1)
    assert conveyor.moving == 0
    most = 0
    for step in range(100):
        conveyor.put(lane, 10)
        conveyor.advance(10 + step * 0.1)
        most = max(most, len(conveyor.on_the_way(lane, 10 + step * 0.1)))
    assert most <= TRAVEL_SECONDS / GAP_SECONDS + 1
    for step in range(40):
        conveyor.advance(20 + step * 0.1)
    assert conveyor.moving == 0


def test_rates_are_measured_and_fall_when_nothing_comes() -> None:
    rate = Rate()
    for step in range(41):
        rate.see(step * 0.1, 6 if step % 1 == 0 else 0)
    assert abs(rate.hertz(4.0) - 60) < 0.5
    rate.see(6.0, 0)
    assert 0 < rate.hertz(6.0) < 60
    rate.see(12.0, 0)
    assert rate.hertz(12.0) == 0.0


def kitchen() -> tuple[Graph, Kitchen]:
    graph = Graph()
    graph.create_node("_day6_kitchen_1")
    model = Kitchen(graph, "_day6_kitchen_1")
    graph.add_listener(model.on_change)
    return graph, model


def test_what_passes_between_two_other_processes_is_unknown_and_not_zero() -> None:
    graph, model = kitchen()
    there = graph.create_node("talker", origin="another process")
    there.create_publisher("/b", STRING, "", QoS(), lambda message: message)
    graph.create_node("listener", origin="a third one").create_subscription("/b", STRING, "", QoS())
    model.look(1.0)
    assert model.rates == {"/b": None} and model.conveyor.moving == 0


def test_a_message_of_another_process_counts_once_however_many_listen_here() -> None:
    graph, model = kitchen()
    there = graph.create_node("talker", origin="another process")
    publisher = there.create_publisher("/b", STRING, "", QoS(), lambda message: message)
    ears = [graph.create_node(f"ear{n}").create_subscription("/b", STRING, "", QoS()) for n in range(3)]
    for step in range(41):
        for _ in range(2 * len(publisher.matched)):  # as day6_core/link counts
            publisher.count_delivery()
        if step == 20:
            ears[0].destroy()
        model.look(1 + step * 0.1)
    assert 19 <= (model.rates["/b"] or 0) <= 21


def test_the_kitchen_is_in_nothing_it_shows_and_subscribes_to_nothing() -> None:
    graph, model = kitchen()
    graph.create_node("talker").create_publisher("/b", STRING, "", QoS(), lambda message: message)
    model.show_everything(True)
    model.look(1.0)
    assert [cook.name for cook in model.content.cooks] == ["/talker"]
    assert not graph.endpoints(EndpointKind.SUBSCRIPTION)


def test_the_content_is_kept_while_nothing_changes() -> None:
    graph, model = kitchen()
    node = graph.create_node("talker")
    model.look(1.0)
    before = model.version, model.content
    model.look(2.0)
    assert (model.version, model.content) == before
    node.destroy()
    model.look(2.05)
    model.look(3.0)
    assert model.version > before[0] and not model.content.cooks


def test_what_nobody_takes_is_counted_until_somebody_does() -> None:
    graph, model = kitchen()
    talker = graph.create_node("talker").create_publisher("/b", STRING, "", QoS(), lambda message: message)
    model.look(1.0)
    for _ in range(3):
        talker.publish(object())
    model.look(1.2)
    assert model.left == {"/b": 3}
    graph.create_node("wrong").create_subscription("/b", INT, "", QoS())
    talker.publish(object())
    model.look(1.6)
    assert model.left == {"/b": 4}, "who waits for another shape takes none of them"
    graph.create_node("listener").create_subscription("/b", STRING, "", QoS())
    model.look(2.0)
    talker.publish(object())
    model.look(2.2)
    assert model.left == {}


def test_what_another_process_publishes_to_nobody_is_known_when_it_tells() -> None:
    graph, model = kitchen()
    there = graph.create_node("talker", origin="another process")
    there.create_publisher("/b", STRING, "", QoS(), lambda message: message)
    model.look(1.0)
    assert model.unheard and model.rates == {"/b": None}
    model.told = {("/talker", "/b"): 40}
    model.look(2.0)
    assert not model.left, "what was published before the kitchen was opened is in nobody's way"
    model.told = {("/talker", "/b"): 42}
    model.look(3.0)
    assert model.left == {"/b": 2} and model.conveyor.moving == 2
