"""The same commands in virtual and in real time: what is printed differs in stamps and in numbers of processes alone."""

from __future__ import annotations

import re

import pytest

from tests.virtual.test_worlds import files
from tests.virtual.world import World

pytestmark = pytest.mark.process

PENTAGRAM = """
import math, rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
class Pen(Node):
    def __init__(self):
        super().__init__("pen")
        self.publisher = self.create_publisher(Twist, "turtle1/cmd_vel", 10)
        while not self.publisher.get_subscription_count():
            rclpy.spin_once(self, timeout_sec=0.1)
        self.corner = 0
        self.timer = self.create_timer(0.5, self.step)
    def step(self):
        command = Twist()
        if self.corner == 10:
            raise SystemExit
        if self.corner % 2:
            command.angular.z = math.radians(144)
        else:
            command.linear.x = 2.0
        self.publisher.publish(command)
        self.get_logger().info(f"{'turn' if self.corner % 2 else 'line'} {self.corner // 2}")
        self.corner += 1
rclpy.init()
rclpy.spin(Pen())
"""
LAUNCH_TEST = """
import unittest, launch, launch_testing.actions, pytest
@pytest.mark.launch_test
def generate_test_description():
    talker = launch.actions.ExecuteProcess(cmd=["python3", "talker.py"], name="talker", output="screen")
    return launch.LaunchDescription([talker, launch_testing.actions.ReadyToTest()]), {"talker": talker}
class TestTalker(unittest.TestCase):
    def test_it_says_hello(self, proc_output, talker):
        proc_output.assertWaitFor("Hello 2", process=talker, timeout=30)
    def test_it_says_nothing_else(self, proc_output, talker):
        with self.assertRaises(AssertionError):
            proc_output.assertWaitFor("Goodbye", process=talker, timeout=1)
"""
WAYS = {
    "pentagram": (
        "ros2 run turtlesim turtlesim_node > turtle.txt 2>&1 & python3 pen.py > pen.txt 2>&1; sleep 1.5; "
        "ros2 topic echo --once /turtle1/pose --field linear_velocity; cat turtle.txt pen.txt"
    ),
    "two publishers fight": (
        "ros2 topic echo /chatter std_msgs/msg/String > heard.txt & sleep 2; "
        'ros2 topic pub -r 1 -t 3 -w 1 /chatter std_msgs/msg/String "data: one" > one.txt & sleep 0.5; '
        'ros2 topic pub -r 1 -t 3 -w 1 /chatter std_msgs/msg/String "data: two" > two.txt; '
        "wait %2; cat heard.txt one.txt two.txt"
    ),
    "action": (
        "python3 fibonacci.py > server.txt 2>&1 & "
        'ros2 action send_goal -f /fibonacci example_interfaces/action/Fibonacci "{order: 4}"; cat server.txt'
    ),
    # Not what it prints: lines of launch's thread come in between where they like, even inside of others.
    "launch test": "launch_test --junit-xml=r.xml talker_launch.py > /dev/null 2>&1; echo $?; sed 's/></>\\n</g' r.xml",
}
VARY = (
    (re.compile(r"\d{10}\.\d{9}|\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d-\d{6}-\S+-\d+"), "TIME"),
    (re.compile(r'time="\d+\.\d+"'), "SECONDS"),
    (re.compile(r"pid \[?\d+]?"), "PID"),
    (re.compile(r"ID: [0-9a-f]{32}"), "ID"),
    (re.compile(r"ROS_DOMAIN_ID \d+"), "DOMAIN"),
)


@pytest.mark.parametrize("name", WAYS)
def test_what_is_printed_is_that_of_real_time(world: World, name: str) -> None:
    files(world)
    world.file("pen.py", PENTAGRAM)
    world.file("talker_launch.py", LAUNCH_TEST)
    said = []
    for done in (world.execute(WAYS[name]), world.fast(WAYS[name])):
        text = done.stdout + done.stderr
        for pattern, word in VARY:
            text = pattern.sub(word, text)
        said.append((done.returncode, text))
    assert said[1] == said[0]
    assert len(said[0][1].splitlines()) > 5
