"""Several processes on one graph in virtual time: what lessons teach, what goes wrong, and the real world beside it."""

from __future__ import annotations

import os
import signal
import subprocess

import pytest

from tests.support.waiting import communicate, until
from tests.virtual.world import World

pytestmark = pytest.mark.process

TALKER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.count = 0
        self.create_timer(0.5, self.tick)
    def tick(self):
        message = String(data=f"Hello {self.count}")
        self.count += 1
        self.publisher.publish(message)
        self.get_logger().info(f"Publishing: {message.data}")
rclpy.init()
try: rclpy.spin(Talker())
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException): print("talker ends")
"""
LISTENER = """
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("listener")
node.create_subscription(String, "chatter", lambda message: node.get_logger().info(f"I heard: {message.data}"), 10)
try: rclpy.spin(node)
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException): print("listener ends")
"""
BROADCASTER = """
import math, rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose
class Broadcaster(Node):
    def __init__(self):
        super().__init__("broadcaster")
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, "turtle1/pose", self.send, 10)
    def send(self, pose):
        frame = TransformStamped()
        frame.header.stamp = self.get_clock().now().to_msg()
        frame.header.frame_id, frame.child_frame_id = "world", "turtle1"
        frame.transform.translation.x, frame.transform.translation.y = pose.x, pose.y
        frame.transform.rotation.z, frame.transform.rotation.w = math.sin(pose.theta / 2), math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(frame)
rclpy.init()
rclpy.spin(Broadcaster())
"""
FIBONACCI = """
import time, rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
class Server(Node):
    def __init__(self):
        super().__init__("fibonacci_action_server")
        self.server = ActionServer(self, Fibonacci, "fibonacci", self.execute)
    def execute(self, goal):
        self.get_logger().info("Executing goal...")
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for i in range(1, goal.request.order):
            feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
            goal.publish_feedback(feedback)
            time.sleep(1)
        goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)
rclpy.init()
rclpy.spin(Server())
"""


def files(world: World) -> None:
    world.file("talker.py", TALKER)
    world.file("listener.py", LISTENER)
    world.file("broadcaster.py", BROADCASTER)
    world.file("fibonacci.py", FIBONACCI)


def test_talker_and_listener_to_the_microsecond(world: World) -> None:
    files(world)
    done = world.fast(
        "python3 listener.py & python3 talker.py & sleep 1.7; ros2 node list; kill -INT %1 %2; wait; echo $SECONDS"
    )
    assert done.returncode == 0
    assert done.stdout == "/listener\n/talker\nlistener ends\ntalker ends\n1\n"
    lines = done.stderr.splitlines()
    assert [line.rpartition("]: ")[2] for line in lines] == [
        f"{what} Hello {n}" for n in range(3) for what in ("Publishing:", "I heard:")
    ]
    stamps = [float(line[8:28]) for line in lines]
    assert stamps == sorted(stamps)
    assert all(abs(stamp - 1767225600.5 - n // 2 / 2) < 0.001 for n, stamp in enumerate(stamps)), stamps


SIX = (
    "python3 listener.py & python3 talker.py & ros2 run turtlesim turtlesim_node & python3 broadcaster.py & "
    "python3 fibonacci.py & ros2 topic echo /tf --once & sleep 2; "
    'ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}, angular: {z: 1.8}}"; '
    'ros2 action send_goal -f /fibonacci example_interfaces/action/Fibonacci "{order: 4}"; '
    "ros2 topic echo --once /turtle1/pose; ros2 topic hz /turtle1/pose & sleep 3; kill -INT $!; "
    "ros2 node list; ros2 topic info -v /chatter; kill -9 %1 %2 %3 %4 %5; wait; echo end $SECONDS"
)
"""Six processes, tf2, a service, an action and the tools."""


def test_six_processes_do_the_same_each_time_whatever_else_runs(world: World) -> None:
    files(world)
    first = world.fast(SIX)
    assert first.returncode == 0, first.stderr
    assert "Goal finished with status: SUCCEEDED" in first.stdout
    assert "average rate: 62.5" in first.stdout
    assert first.stdout.endswith("end 8\n"), first.stdout
    busy = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(3)]
    try:
        again = [world.fast(SIX) for _ in range(3)]
    finally:
        for each in busy:
            each.kill()
            each.wait()
    for each in again:
        assert each.stdout.splitlines() == first.stdout.splitlines()
        assert each.stderr.splitlines() == first.stderr.splitlines()


def test_launch_ends_its_processes_at_the_time_it_says(world: World) -> None:
    files(world)
    world.file(
        "two_launch.py",
        """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, Shutdown, TimerAction
def generate_launch_description():
    programs = [ExecuteProcess(cmd=["python3", name + ".py"], name=name, output="screen") for name in ("talker", "listener")]
    return LaunchDescription([*programs, TimerAction(period=60.2, actions=[Shutdown(reason="it is late")])])
""",
    )
    done = world.fast("ros2 launch two_launch.py; echo $? $SECONDS")
    assert done.stdout.endswith("0 60\n"), (done.stdout, done.stderr)
    everything = done.stdout + done.stderr
    assert everything.count("I heard:") == 120
    assert "process has finished cleanly" in everything


def test_pipes_and_standard_input_go_on_with_the_time(world: World) -> None:
    done = world.fast(
        "(sleep 2; echo late) | python3 -c 'import time; print(input(), round(time.monotonic(), 1))'; "
        "printf 'a\\nb\\n' | python3 -c 'print(input() + input())'; "
        "python3 -c 'for n in range(20000): print(n)' | tail -1; echo $SECONDS"
    )
    assert (done.stdout, done.stderr) == ("late 2.0\nab\n19999\n2\n", "")


def test_a_flood_waits_for_whoever_reads_it(world: World) -> None:
    done = world.fast("python3 -c 'for n in range(30000): print(n)' | (sleep 3; tail -1); echo $SECONDS")
    assert (done.stdout, done.stderr) == ("29999\n3\n", "")


def test_what_comes_from_outside_holds_time_still(world: World) -> None:
    world.file("ask.py", "import time\nprint('?')\nprint(input(), round(time.monotonic(), 1))\n")
    running = world.begin("sleep 60 & python3 ask.py")
    running.wait_for("?")
    assert running.end("now\n") == 0
    assert running.out == "?\nnow 0.0\n"


WAITS_IN_C = "import _socket\na, b = _socket.socketpair()\na.recv(1)"


@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize(("program", "kind"), [("while True: pass", "busy"), (WAITS_IN_C, "real")])
def test_a_line_that_holds_time_is_named_and_can_be_interrupted(
    world: World, program: str, kind: str, language: str
) -> None:
    world.file("stuck.py", f"import time\ntime.sleep(1)\n{program}\n")
    running = world.begin("python3 stuck.py; echo $?", DAY6_LANG=language)
    line = 2 + len(program.splitlines())
    said = {
        "busy": {"en": "has been busy for 2 s without waiting", "zh": "已经忙了 2 秒没有等待"},
        "real": {"en": "waits for something real", "zh": "在等真实世界里的东西"},
    }
    running.wait_for(said[kind][language])
    assert f"stuck.py:{line} " in running.err
    running.end(signal=signal.SIGINT)
    assert running.err.endswith("KeyboardInterrupt\n")


def test_a_program_that_is_not_python_holds_time_still_and_is_named(world: World) -> None:
    world.file(
        "calls.py", "import subprocess, time\nsubprocess.run(['sleep', '3'])\nprint(round(time.monotonic(), 1))\n"
    )
    done = world.fast("python3 calls.py")
    assert done.stdout == "0.0\n"
    assert "time stands still while sleep 3 runs" in done.stderr


def test_processes_that_wait_for_each_other_do_not_stop_the_others(world: World) -> None:
    world.file("dead.py", "import threading\nlock = threading.Lock()\nlock.acquire()\nlock.acquire()\n")
    done = world.fast("timeout 5 python3 dead.py; echo $? $SECONDS")
    assert (done.stdout, done.stderr) == ("124 5\n", "")


def test_a_world_in_which_nothing_is_left_to_happen_says_so(world: World) -> None:
    files(world)
    running = world.begin("python3 listener.py", DAY6_LANG="en")
    running.wait_for("nothing is left to happen")
    assert "listener.py" in running.err
    running.end(signal=signal.SIGINT)
    assert running.out == "listener ends\n"


def test_a_world_and_the_real_one_never_meet(world: World) -> None:
    files(world)
    real = world.start("exec", "--home", str(world.home), "-c", "python3 talker.py")
    world.wait_nodes("/talker")
    done = world.fast("python3 listener.py & sleep 2; ros2 node list; kill -9 %1")
    assert done.stdout == "/listener\n"
    assert world.nodes() == ["/talker"]
    os.kill(real.pid, signal.SIGINT)
    communicate(real)


def test_clearing_up_follows_no_link(world: World) -> None:
    kept = world.file("kept.txt", "mine")
    planted = world.runtime / "day6-time-999999999-0"
    planted.symlink_to(world.work)
    assert world.fast("true").returncode == 0
    assert kept.read_text(encoding="utf-8") == "mine"
    assert planted.is_symlink()
    planted.unlink()


def test_a_killed_world_takes_its_processes_with_it(world: World) -> None:
    files(world)
    running = world.begin("python3 talker.py")
    running.wait_for("Hello 1")
    running.end(signal=signal.SIGKILL)
    until(lambda: not [each for each in world.left() if "python" in each], told=world.left)
    assert world.fast("true").returncode == 0  # and clears up what the killed one has left
