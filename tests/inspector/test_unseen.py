"""The inspector is in nothing that it looks at: what commands, windows and programs see is the same without it."""

from __future__ import annotations

import re
import time
from typing import Any

import pytest

from day6_core.graph import EndpointKind
from day6_core.ros.programs.rqt_graph.model.content import GraphOptions, GraphType
from tests.inspector.drills import HEAD, robot
from tests.inspector.lab import Lab

TURNER = (
    HEAD
    + """
from sensor_msgs.msg import JointState

rclpy.init()
node = Node('turner')
publisher = node.create_publisher(JointState, 'joint_states', 10)

def turn():
    message = JointState(name=['left_wheel_joint', 'right_wheel_joint'], position=[0.1, 0.1])
    message.header.stamp = node.get_clock().now().to_msg()
    publisher.publish(message)

node.create_timer(0.05, turn)
rclpy.spin(node)
"""
)
LOOKER = (
    HEAD
    + """
from day6_core.link import link_of

rclpy.init()
node = Node('looker')
tired = node.create_publisher(String, 'robot_description', 10)
input()
assert link_of(node.context._graph).wait_settled(600)
print(sorted(node.get_node_names_and_namespaces()))
print(sorted(node.get_topic_names_and_types()), sorted(node.get_service_names_and_types()))
for topic, _ in sorted(node.get_topic_names_and_types()):
    found = node.get_subscriptions_info_by_topic(topic)
    print(topic, node.count_publishers(topic), node.count_subscribers(topic), sorted(info.node_name for info in found))
print(tired.get_subscription_count())
"""
)
LINES = (
    "ros2 node list -a",
    "ros2 topic list -t --include-hidden-topics",
    "ros2 service list --include-hidden-services",
    "ros2 node info --include-hidden /robot_state_publisher",
    *(
        f"ros2 topic info -v {topic}"
        for topic in ("/joint_states", "/robot_description", "/tf", "/tf_static", "/rosout")
    ),
)


def of_another_program(lab: Lab) -> str:
    """What a program sees that the inspector, while it is there, has had time to look at."""
    lab.start("python3 looker.py", 4)
    lab.wait_node("/looker")
    if lab.windows("inspector"):
        lab.settle()
    lab.terminal(4).send("\n")
    lab.wait(lambda: (lab.screen(4), lab.terminal(4).runs.all[-1].status is not None)[1])
    lab.wait(lambda: all(node.name != "looker" for node in lab.desk.graph.nodes))
    return lab.terminal(4).runs.all[-1].output


def counted_for_each_message(lab: Lab, kitchen: Any) -> int:
    """How many messages the kitchen counts when one comes on /joint_states."""
    (taker,) = (
        each
        for each in lab.desk.graph.endpoints(EndpointKind.SUBSCRIPTION, topic="/joint_states")
        if each.node.name == "robot_state_publisher"
    )
    counts: list[tuple[int, int]] = []
    """What each look counted, and how many had come by then: not every look is one, and many may come between two."""

    def put(lane: tuple[str, str], more: int) -> None:
        if lane[0] == "/joint_states":
            counts.append((more, taker.received))

    def look() -> None:
        kitchen.look(time.monotonic())

    kitchen.conveyor.put = put
    lab.wait(lambda: look() or any(more for more, _ in counts))
    (_, begin), begun = counts[-1], len(counts)
    lab.wait(lambda: look() or counts[-1][1] - begin >= 20)
    return round(sum(more for more, _ in counts[begun:]) / (counts[-1][1] - begin))


def seen(lab: Lab) -> dict[str, Any]:
    """What each of them shows now, without numbers that are never the same."""
    printed = {line: lab.run(line, 4) for line in LINES}
    printed["looker"] = of_another_program(lab)
    found: dict[str, Any] = {line: re.sub(r"[0-9a-f.]{16,}|\d{4,}", "N", text) for line, text in printed.items()}
    kitchen, graph = lab.windows("kitchen")[-1].model, lab.windows("rqt_graph")[-1].model
    kitchen.show_everything(True)
    found["counted"] = counted_for_each_message(lab, kitchen)
    # Another kitchen, rqt_graph and the commands' daemon are nodes of their own, with a number in their names.
    found["cooks"] = [re.sub(r"\d+", "N", str(cook)) for cook in kitchen.content.cooks]
    found["belts"] = [re.sub(r"\d+", "N", str(belt)) for belt in kitchen.content.belts]
    graph.change_options(GraphOptions(GraphType.ALL, hide_dead_sinks=False, hide_leaf_topics=False, hide_debug=False))
    refreshed: list[Any] = []
    lab.desk.scheduler.call_soon_threadsafe(lambda: refreshed.append(graph.refresh()))
    lab.wait(lambda: refreshed)
    found["rqt_graph"] = re.sub(r"\d+", "N", str(graph.content))
    return found


@pytest.mark.process
def test_what_others_see_is_the_same_with_and_without_it(lab: Lab) -> None:
    lab.file("turner.py", TURNER)
    lab.file("looker.py", LOOKER)
    robot(lab)
    lab.start("python3 turner.py", 1)
    lab.start("ros2 run day6_kitchen kitchen", 2)
    lab.start("rqt_graph", 3)
    lab.start("ros2 run tf2_ros tf2_echo nowhere base_link", 5, shows="does not exist")  # it listens to transforms too
    lab.wait(lambda: lab.windows("kitchen") and lab.windows("rqt_graph") and lab.findings.get("no_frame"))
    lab.wait(lambda: lab.inspector._hearing.facts()["frames"])
    lab.settle()
    lab.run("ros2 node list", 4)  # the commands' daemon is there from now on
    before = seen(lab)
    lab.desk.scheduler.call_soon_threadsafe(lab.windows("inspector")[0].close_by_user)
    lab.wait(lambda: all("inspector" not in node.name for node in lab.desk.graph.observers))
    after = seen(lab)
    assert before == after
    assert before["counted"] == 1 and "inspector" not in str(before) and "/turner" in str(before)
