"""What rqt_graph shows and hides: node and edge sets computed from the rules of the real tool."""

from __future__ import annotations

from dataclasses import replace

import pytest

from day6_core.ros.programs.rqt_graph.model.content import Content, GraphContent, GraphOptions, GraphType, select

FEEDBACK = "/turtle1/rotate_absolute/_action/feedback"
TURTLE = GraphContent(
    publishers={
        "/turtle1/cmd_vel": ("/teleop_turtle",),
        "/turtle1/pose": ("/turtlesim",),
        FEEDBACK: ("/turtlesim",),
        "/rosout": ("/turtlesim", "/teleop_turtle", "/_ros2cli_1042"),
        "/parameter_events": ("/turtlesim", "/teleop_turtle"),
    },
    subscribers={
        "/turtle1/cmd_vel": ("/turtlesim", "/_ros2cli_1042"),
        FEEDBACK: ("/teleop_turtle",),
        "/parameter_events": ("/turtlesim",),
    },
)


def edges(content: Content) -> set[tuple[str, str, str]]:
    return {(edge.start.strip(), edge.end.strip(), edge.label) for edge in content.edges}


def names(content: Content) -> set[str]:
    return {box.lines[0] for box in content.boxes}


def hidden(content: Content) -> dict[str, set[str]]:
    return {each.option: set(each.names) for each in content.hidden}


def test_the_first_view_is_the_two_ellipses_of_the_lesson() -> None:
    content = select(TURTLE, GraphOptions())
    assert names(content) == {"/teleop_turtle", "/turtlesim"}
    assert edges(content) == {
        ("/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel"),
        ("/turtlesim", "/teleop_turtle", FEEDBACK),
    }


def test_what_is_hidden_is_told_with_its_reason() -> None:
    assert hidden(select(TURTLE, GraphOptions())) == {
        "Dead sinks": {"/turtle1/pose", "/rosout"},
        "Params": {"/parameter_events"},
        "Debug": {"/_ros2cli_1042"},
    }


def test_showing_debug_brings_the_echo_into_the_picture() -> None:
    content = select(TURTLE, GraphOptions(hide_debug=False))
    assert ("/teleop_turtle", "/_ros2cli_1042", "/turtle1/cmd_vel") in edges(content)


def test_a_node_that_hears_itself_shows_its_loop() -> None:
    content = select(TURTLE, GraphOptions(hide_params=False))
    (turtlesim,) = [box for box in content.boxes if box.key == "/turtlesim"]
    assert turtlesim.lines == ("/turtlesim", "↺ /parameter_events")


def test_topics_become_boxes_between_the_nodes() -> None:
    content = select(TURTLE, GraphOptions(graph_type=GraphType.ALL))
    assert edges(content) == {
        ("/teleop_turtle", "/turtle1/cmd_vel", ""),
        ("/turtle1/cmd_vel", "/turtlesim", ""),
        ("/turtlesim", FEEDBACK, ""),
        (FEEDBACK, "/teleop_turtle", ""),
    }
    shapes = {box.lines[0]: box.shape for box in content.boxes}
    assert shapes["/turtlesim"] == "node"
    assert shapes["/turtle1/cmd_vel"] == "topic"


@pytest.mark.parametrize(
    ("sinks", "leaves", "shown"), [(True, True, False), (False, True, False), (False, False, True)]
)
def test_a_topic_nobody_hears_needs_both_boxes_off(sinks: bool, leaves: bool, shown: bool) -> None:
    options = GraphOptions(graph_type=GraphType.ALL, hide_dead_sinks=sinks, hide_leaf_topics=leaves)
    assert ("/turtle1/pose" in names(select(TURTLE, options))) is shown


def test_a_topic_only_heard_is_a_leaf_but_no_dead_sink() -> None:
    facts = GraphContent(publishers={}, subscribers={"/joint_states": ("/robot_state_publisher",)})
    options = GraphOptions(graph_type=GraphType.ALL)
    assert "/joint_states" not in names(select(facts, options))
    assert hidden(select(facts, options)) == {"Leaf topics": {"/joint_states"}}
    assert "/joint_states" in names(select(facts, replace(options, hide_leaf_topics=False)))


TF = GraphContent(
    publishers={"/tf": ("/robot_state_publisher",), "/tf_static": ("/robot_state_publisher",)},
    subscribers={"/tf": ("/viewer",), "/tf_static": ("/viewer",)},
)


def test_tf_topics_share_one_group_box() -> None:
    content = select(TF, GraphOptions(graph_type=GraphType.ALL))
    assert {(box.lines[0], box.shape) for box in content.boxes if box.shape != "node"} == {("/tf", "group")}
    assert edges(content) == {("/robot_state_publisher", "/tf", ""), ("/tf", "/viewer", "")}


def test_tf_can_be_shown_apart_or_hidden() -> None:
    apart = select(TF, GraphOptions(graph_type=GraphType.ALL, group_tf=False))
    assert {"/tf", "/tf_static"} <= names(apart)
    gone = select(TF, GraphOptions(graph_type=GraphType.ALL, hide_tf=True))
    assert gone.edges == ()
    assert hidden(gone) == {"tf": {"/tf", "/tf_static"}}


def test_rviz_is_hidden_by_debug_as_in_the_real_tool() -> None:
    facts = GraphContent(publishers={"/tf": ("/a",)}, subscribers={"/tf": ("/rviz2", "/b")})
    assert names(select(facts, GraphOptions())) == {"/a", "/b"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("/", {"/teleop_turtle", "/turtlesim"}),
        ("/turtlesim", {"/turtlesim"}),
        ("-/turtlesim", {"/teleop_turtle"}),
        ("/tele.*", {"/teleop_turtle"}),
        ("/t.*,-/turtle.*", {"/teleop_turtle"}),
        ("(", set()),
    ],
)
def test_the_node_filter_takes_names_patterns_and_exclusions(text: str, expected: set[str]) -> None:
    assert names(select(TURTLE, GraphOptions(node_filter=text))) == expected


def test_the_topic_filter_takes_edges_out() -> None:
    content = select(TURTLE, GraphOptions(topic_filter="-/turtle1/cmd_vel"))
    assert edges(content) == {("/turtlesim", "/teleop_turtle", FEEDBACK)}


def test_an_action_with_all_five_topics_is_one_group() -> None:
    topics = ["/fib/" + each for each in ("status", "result", "goal", "cancel", "feedback")]
    facts = GraphContent(dict.fromkeys(topics, ("/server",)), dict.fromkeys(topics, ("/client",)))
    content = select(facts, GraphOptions(graph_type=GraphType.ALL))
    assert edges(content) == {("/server", "/fib/action_topics", ""), ("/fib/action_topics", "/client", "")}


def test_trouble_follows_its_topic_into_both_views() -> None:
    facts = GraphContent({"/a": ("/p",)}, {"/a": ("/s",)}, {"/a": ("Found qos incompatibilities:",)})
    assert set(select(facts, GraphOptions()).trouble) == {"/a"}
    assert set(select(facts, GraphOptions(graph_type=GraphType.ALL)).trouble) == {" /a"}


STATUS = "/turtle1/rotate_absolute/_action/status"
DRIVEN = GraphContent(
    publishers={**TURTLE.publishers, STATUS: ("/turtlesim",)},
    subscribers={**TURTLE.subscribers, STATUS: ("/teleop_turtle",)},
)


def test_a_driven_turtle_is_three_arrows_as_in_the_official_tutorial() -> None:
    """The box "Actions" joins five topics of ROS 1; an action of ROS 2 has two, so nothing is joined."""
    assert edges(select(DRIVEN, GraphOptions())) == {
        ("/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel"),
        ("/turtlesim", "/teleop_turtle", FEEDBACK),
        ("/turtlesim", "/teleop_turtle", STATUS),
    }
    boxes = names(select(DRIVEN, GraphOptions(graph_type=GraphType.ACTIVE)))
    assert boxes == {"/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel", FEEDBACK, STATUS}


def test_ten_times_as_many_nodes_are_compared_ten_times_as_often() -> None:
    compared = 0

    class Name(str):
        def __eq__(self, other: object) -> bool:
            nonlocal compared
            compared += 1
            return str.__eq__(self, other)

        __hash__ = str.__hash__

    def comparisons(count: int) -> int:
        nonlocal compared
        compared = 0
        nodes = [Name(f"/node_{number}") for number in range(count)]
        content = select(
            GraphContent(
                {f"/topic_{number}": (node,) for number, node in enumerate(nodes)},
                {f"/topic_{number}": (Name(str(nodes[number - 1])),) for number in range(count)},
            ),
            GraphOptions(),
        )
        assert len(content.edges) == count
        return compared

    assert comparisons(400) < 15 * comparisons(40)
