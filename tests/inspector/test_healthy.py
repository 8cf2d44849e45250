"""What works gives no alarm: the turtle, the car, the world, talkers and listeners, the tutorials' packages, a launch."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.inspector.drills import HEAD, LISTENER, MODEL, TALKER, package, robot, rviz
from tests.inspector.faults_in_messages import HEALTHY
from tests.inspector.lab import Lab


def turtle(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    lab.start("ros2 run turtlesim turtle_teleop_key", 1)
    lab.start("ros2 topic echo /turtle1/cmd_vel", 2)


def square(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    lab.start("ros2 run turtlesim draw_square", 1)
    lab.run("ros2 service call /spawn turtlesim/srv/Spawn '{x: 2.0, y: 2.0, name: other}'", 2)
    lab.run("ros2 param set /turtlesim background_b 0", 2)
    lab.run("ros2 node list", 2)


def talker_and_listener(lab: Lab) -> None:
    lab.file("talker.py", TALKER)
    lab.file("listener.py", LISTENER)
    lab.start("python3 talker.py", 0)
    lab.start("python3 listener.py", 1, shows="I heard")


def demo_nodes(lab: Lab) -> None:
    lab.start("ros2 run demo_nodes_py talker", 0, shows="Publishing")
    lab.start("ros2 run demo_nodes_cpp listener", 1, shows="I heard")
    lab.start("ros2 run demo_nodes_py add_two_ints_server", 2)
    lab.run("ros2 run demo_nodes_py add_two_ints_client", 3)


def fibonacci(lab: Lab) -> None:
    lab.start("ros2 run action_tutorials_py fibonacci_action_server")
    line = "ros2 action send_goal --feedback /fibonacci example_interfaces/action/Fibonacci '{order: 4}'"
    lab.start(line, 1, shows="Goal accepted")


def slow_action(lab: Lab) -> None:
    """The tutorial's own action server sleeps in its callback; nothing else waits for it."""
    lab.file(
        "server.py",
        HEAD
        + """
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionServer

class Server(Node):
    def __init__(self):
        super().__init__('fibonacci_action_server')
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.execute)

    def execute(self, goal):
        feedback = Fibonacci.Feedback()
        feedback.partial_sequence = [0, 1]
        for i in range(1, goal.request.order):
            feedback.partial_sequence.append(i)
            goal.publish_feedback(feedback)
            time.sleep(1)
        goal.succeed()
        return Fibonacci.Result(sequence=feedback.partial_sequence)

rclpy.init()
rclpy.spin(Server())
""",
    )
    lab.start("python3 server.py")
    lab.wait_node("/fibonacci_action_server")
    line = "ros2 action send_goal /fibonacci action_tutorials_interfaces/action/Fibonacci '{order: 5}'"
    lab.start(line, 1, shows="Goal accepted")


def slow_service(lab: Lab) -> None:
    """A callback that takes its time holds nobody up where nobody waits."""
    lab.file(
        "server.py",
        HEAD
        + """
def answer(request, response):
    time.sleep(4)
    return response

rclpy.init()
node = Node('slow')
node.create_service(Trigger, 'trigger', answer)
rclpy.spin(node)
""",
    )
    lab.start("python3 server.py")
    lab.wait_node("/slow")
    lab.start("ros2 service call /trigger std_srvs/srv/Trigger", 1, shows="requester: making request")


def spin_once_loop(lab: Lab) -> None:
    """A program that spins now and then by itself, and one that only publishes."""
    lab.file(
        "loop.py",
        HEAD
        + """
rclpy.init()
node = Node('looper')
node.create_subscription(String, 'chatter', lambda message: None, 10)
while rclpy.ok():
    rclpy.spin_once(node, timeout_sec=0.05)
    time.sleep(0.3)
""",
    )
    lab.file(
        "sender.py",
        HEAD
        + """
rclpy.init()
node = Node('sender')
publisher = node.create_publisher(String, 'chatter', 10)
while rclpy.ok():
    publisher.publish(String(data='a'))
    time.sleep(0.1)
""",
    )
    lab.start("python3 loop.py", 0)
    lab.wait_node("/looper")
    lab.start("python3 sender.py", 1)
    lab.wait_node("/sender")


def threads(lab: Lab) -> None:
    """Rate and call() as they should be: with a second thread that spins."""
    lab.file(
        "program.py",
        HEAD
        + """
import threading
rclpy.init()
node = Node('mine')
client = node.create_client(Trigger, 'trigger')
node.create_service(Trigger, 'trigger', lambda request, response: response)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(5)
while rclpy.ok():
    client.call(Trigger.Request())
    rate.sleep()
""",
    )
    lab.start("python3 program.py")
    lab.wait_node("/mine")


def car(lab: Lab) -> None:
    robot(lab)
    lab.start("ros2 run day6_bot car_view", 1)
    lab.wait(lambda: lab.windows("car"))
    lab.start("ros2 run day6_bot wheel_spinner", 2)
    lab.wait_node("/wheel_spinner")


def display(lab: Lab) -> None:
    lab.start("ros2 launch day6_bot display.launch.py")
    lab.wait(lambda: lab.windows("rviz2"))


def rviz_with_the_robot(lab: Lab) -> None:
    robot(lab)
    lab.start("ros2 run day6_bot wheel_spinner", 1)
    lab.wait_node("/wheel_spinner")
    rviz(lab, "base_link", MODEL.format(topic="/robot_description"))


def world(lab: Lab) -> None:
    lab.start("ros2 launch day6_world world.launch.py world:=walls")
    lab.wait(lambda: lab.windows("world"))
    lab.start("ros2 run teleop_twist_keyboard teleop_twist_keyboard", 1)


def workspace(lab: Lab) -> None:
    """The end of the day of packages: built, sourced, started by a launch file of one's own."""
    folder = package(lab, build=False)
    (folder / "my_pkg/my_node.py").write_text(TALKER, encoding="utf-8")
    (folder / "launch").mkdir()
    (folder / "launch/my.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='my_pkg', executable='my_node', output='screen'),\n"
        "                              Node(package='demo_nodes_cpp', executable='listener')])\n",
        encoding="utf-8",
    )
    setup = (folder / "setup.py").read_text(encoding="utf-8")
    entry = "('share/' + package_name, ['package.xml']),"
    more = "\n        ('share/' + package_name + '/launch', ['launch/my.launch.py']),"
    (folder / "setup.py").write_text(setup.replace(entry, entry + more), encoding="utf-8")
    lab.run("colcon build && source install/setup.bash")
    lab.start("ros2 launch my_pkg my.launch.py")
    lab.wait_node("/talker")
    lab.wait_node("/listener")


def parameters(lab: Lab) -> None:
    lab.file("params.yaml", "/**:\n  ros__parameters:\n    background_b: 0\n")
    lab.start("ros2 run turtlesim turtlesim_node --ros-args --params-file params.yaml")
    lab.start("ros2 run turtlesim turtle_teleop_key", 1)


def parameters_elsewhere(lab: Lab) -> None:
    """The file is named from the folder of the terminal, and from the home folder, of programs of one's own."""
    text = TALKER.replace("'hello'", "self.get_parameter('word').value")
    text = text.replace("super().__init__('talker')", "super().__init__('talker'); self.declare_parameter('word', '')")
    lab.file("work/talker.py", text)
    lab.file("work/params.yaml", "/**/talker:\n  ros__parameters:\n    word: hello\n")
    lab.file("listener.py", LISTENER)
    lab.start("cd work; python3 talker.py --ros-args --params-file params.yaml")
    lab.start("python3 work/talker.py --ros-args -r __ns:=/b --params-file ~/work/params.yaml", 1)
    lab.start("python3 listener.py", 2, shows="I heard hello")
    lab.start("python3 listener.py --ros-args -r __ns:=/b", 3, shows="I heard hello")
    lab.start("cd work; python3 talker.py --ros-args -r __ns:=/c --params-file params.yaml &", 4)
    lab.wait_node("/c/talker")
    lab.run("cd /", 4)


def multisim(lab: Lab) -> None:
    lab.start("ros2 launch turtlesim multisim.launch.py")
    lab.wait_node("/turtlesim2/turtlesim")


def bag(lab: Lab) -> None:
    lab.start("ros2 run demo_nodes_py talker", 0, shows="Publishing")
    lab.start("ros2 bag record /chatter", 1)
    lab.start("ros2 topic hz /chatter", 2)


def minimal_examples(lab: Lab) -> None:
    lab.start("ros2 run examples_rclpy_minimal_publisher publisher_member_function", 0)
    lab.start("ros2 run examples_rclpy_minimal_subscriber subscriber_member_function", 1)
    lab.start("ros2 run examples_rclpy_minimal_service service_member_function", 2)
    lab.run("ros2 run examples_rclpy_minimal_client client_async_member_function 3 4", 3)


SCENES: tuple[Callable[[Lab], object], ...] = (
    turtle, square, talker_and_listener, demo_nodes, fibonacci, slow_action, slow_service, spin_once_loop, threads, car, display,
    rviz_with_the_robot, world, workspace, parameters, parameters_elsewhere, multisim, bag, minimal_examples,
    *HEALTHY,
)  # fmt: skip


@pytest.mark.process
@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_a_healthy_scene_gives_no_alarm(lab: Lab, scene: Callable[[Lab], object]) -> None:
    scene(lab)
    said = lab.stays_silent()
    assert said == {}, lab.screen()
