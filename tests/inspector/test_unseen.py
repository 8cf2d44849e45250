"""The inspector is in nothing that it looks at: what commands, windows and programs see is the same without it."""

from __future__ import annotations

import re
import time
from typing import Any

import pytest
from drills import HEAD, robot
from lab import Lab

from day6_tui.core.ros.programs.rqt_graph.model.content import GraphType, Options

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
rclpy.init()
node = Node('looker')
tired = node.create_publisher(String, 'robot_description', 10)
end = time.monotonic() + 1.0
while time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
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
    "python3 looker.py",
)


def seen(lab: Lab) -> dict[str, Any]:
    """What each of them shows now, without numbers that are never the same."""
    found: dict[str, Any] = {line: re.sub(r"[0-9a-f.]{16,}|\d{4,}", "N", lab.run(line, 4)) for line in LINES}
    kitchen, graph = lab.windows("kitchen")[-1].model, lab.windows("rqt_graph")[-1].model
    kitchen.show_everything(True)
    for _ in range(20):
        kitchen.look(time.monotonic())
        time.sleep(0.1)
    # Another kitchen, rqt_graph and the commands' daemon are nodes of their own, with a number in their names.
    found["cooks"] = [re.sub(r"\d+", "N", str(cook)) for cook in kitchen.content.cooks]
    found["belts"] = [re.sub(r"\d+", "N", str(belt)) for belt in kitchen.content.belts]
    found["rate"] = 15 < (kitchen.rates["/joint_states"] or 0) < 25
    graph.change_options(Options(GraphType.ALL, hide_dead_sinks=False, hide_leaf_topics=False, hide_debug=False))
    graph.request_refresh()
    time.sleep(0.5)
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
    lab.wait(lambda: "/tf" in lab.inspector._listening._subscriptions)
    lab.run("ros2 node list", 4)  # the commands' daemon is there from now on
    before = seen(lab)
    lab.desk.scheduler.call_soon_threadsafe(lab.windows("inspector")[0].close)
    lab.wait(lambda: not lab.windows("inspector"))
    after = seen(lab)
    assert before == after
    assert before["rate"] and "inspector" not in str(before) and "/turner" in str(before)
