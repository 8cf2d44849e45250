"""Cells of a real kernel after `%load_ext day6_tui`: a pupil writes them as for real ROS, and callbacks run between them."""

from __future__ import annotations

import re
from importlib.metadata import version
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.notebook.kernel import Kernel

pytestmark = pytest.mark.process

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.count = 0
        self.create_timer(0.05, self.tick)

    def tick(self):
        self.count += 1
        self.publisher.publish(String(data=f"hello {self.count}"))

node = Talker()
"""

BAD = """\
class Bad(Node):
    def __init__(self):
        super().__init__("bad")
        self.create_timer(0.01, self.tick)

    def tick(self):
        print(self.speed)

bad = Bad()
"""

STUCK = """\
class Stuck(Node):
    def __init__(self):
        super().__init__("stuck")
        self.create_timer(0.01, self.tick)

    def tick(self):
        while True:
            time.sleep(0.05)

stuck = Stuck()
"""


def test_nodes_of_cells_live_between_them(kernel: Kernel) -> None:
    assert "import rclpy" in kernel.run("%load_ext day6_tui")
    assert kernel.run("import rclpy; rclpy.init();") == ""
    assert kernel.run(TALKER) == "/talker keeps running in the background; node.destroy_node() ends it\n"
    kernel.until("node.count > 3")
    kernel.run("heard = []; listener = Node('listener')")
    kernel.run("listener.create_subscription(String, 'chatter', lambda message: heard.append(message.data), 10);")
    kernel.until("len(heard) > 3 and heard[0].startswith('hello')")
    assert "/talker" in kernel.run("%ros2 node list")
    until(lambda: "/chatter" in kernel.run("!ros2 topic list"))  # of another process, which waits for a second at most

    # One statement: between two, IPython itself is interrupted.
    said = kernel.run("print('spinning', flush=True), rclpy.spin(node)", interrupt_after="spinning")
    assert "KeyboardInterrupt" in said and "rclpy.spin(node)" in said and "rclpy/" not in said
    assert kernel.run("print(rclpy.ok())") == "True\n"
    kernel.run("before = node.count")
    kernel.until("node.count > before + 3")
    assert kernel.run("%unload_ext day6_tui") == ""
    assert kernel.run(
        "import threading; print(rclpy.ok(), [t.name for t in threading.enumerate() if '/' in t.name])"
    ) == ("True []\n")


def test_a_node_made_again_is_alone_and_heard_on_rosout(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; rclpy.init()")
    kernel.run(TALKER)
    kernel.run("from rcl_interfaces.msg import Log; lines = []; listener = Node('listener')")
    kernel.run("listener.create_subscription(Log, '/rosout', lambda message: lines.append(message.msg), 10);")
    assert kernel.run(TALKER) == "/talker: the node created here before has been destroyed\n"
    assert kernel.run("print(listener.get_node_names().count('talker'))") == "1\n"
    assert "[talker]: the new one" in kernel.run("node.get_logger().info('the new one')")
    assert not kernel.troubles
    kernel.until("'the new one' in lines")
    kernel.run("node.destroy_node()")
    assert kernel.run(TALKER) == ""


def test_init_is_done_once_however_often_its_cell_is_run(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    assert kernel.run("import rclpy\nrclpy.init(args=None);") == ""
    kernel.run(TALKER)
    assert "does nothing" in kernel.run("rclpy.init(args=None);")
    assert kernel.run("rclpy.init();") == ""
    assert "RuntimeError" in kernel.run("rclpy.init(domain_id=7)")
    kernel.run("before = node.count")
    kernel.until("node.count > before")
    assert kernel.run("rclpy.shutdown(); print(rclpy.ok())") == "False\n"
    assert kernel.run("rclpy.init(); print(rclpy.ok())") == "True\n"
    kernel.run(TALKER)
    kernel.until("node.count > 2")
    assert kernel.run("with rclpy.init():\n    print(rclpy.ok())\nprint(rclpy.ok())") == "True\nFalse\n"


def test_services_answer_in_the_cell_that_calls(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; from rclpy.node import Node; from example_interfaces.srv import AddTwoInts; rclpy.init()")
    kernel.run("def add(request, response):\n    response.sum = request.a + request.b\n    return response")
    said = kernel.run("server = Node('server'); server.create_service(AddTwoInts, 'add', add); user = Node('user')")
    assert (
        said == "/server, /user keep running in the background; destroy_node() ends one of them, rclpy.shutdown() all\n"
    )
    kernel.run("client = user.create_client(AddTwoInts, 'add'); print(client.wait_for_service(10.0))")
    assert kernel.run("print(client.call(AddTwoInts.Request(a=40, b=2)).sum)") == "42\n"
    future = "future = client.call_async(AddTwoInts.Request(a=1, b=2)); rclpy.spin_until_future_complete(user, future)"
    assert kernel.run(f"{future}; print(future.result().sum)") == "3\n"
    assert kernel.run("print(client.call(AddTwoInts.Request(a=5, b=6)).sum)") == "11\n"


def test_a_callback_that_fails_is_shown_once_and_ends_its_node_only(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; rclpy.init()")
    kernel.run(TALKER)
    cell = kernel.start(BAD)
    kernel.wait(lambda: "/bad no longer spins" in kernel.shown[cell], cell)
    kernel.run("before = node.count")
    kernel.until("node.count > before + 5")
    shown = kernel.shown[cell]
    assert shown.count("AttributeError: 'Bad' object has no attribute 'speed'") == 1
    assert re.search(r"Cell In\[\d+\], line 7", shown)
    assert "day6_tui" not in shown and "executor" not in shown
    assert kernel.run("rclpy.spin_once(node, timeout_sec=1); print(rclpy.ok())") == "True\n"
    kernel.run("rclpy.shutdown()")
    assert kernel.run("import time; time.sleep(0.2)") == "" and kernel.shown[cell] == shown


def test_a_callback_that_ends_the_program_ends_its_node(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; from rclpy.node import Node; rclpy.init()")
    cell = kernel.start(
        "node = Node('leaving'); node.create_timer(0.01, lambda: exit_now(3)); from sys import exit as exit_now"
    )
    kernel.wait(lambda: "/leaving no longer spins" in kernel.shown[cell], cell)
    assert "Traceback" not in kernel.shown[cell]


def test_a_callback_that_does_not_return_holds_up_its_own_node_only(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy, time; rclpy.init()")
    kernel.run(TALKER)
    cell = kernel.start(STUCK)
    kernel.run("before = node.count")
    kernel.until("node.count > before + 5")
    kernel.wait(lambda: "/stuck: a callback hasn't returned" in kernel.shown[cell], cell)
    assert re.search(r"\(Cell In\[\d+\], line \d\)", kernel.shown[cell])
    kernel.run("import threading; stuck.destroy_node()")
    kernel.until("not [each for each in threading.enumerate() if 'stuck' in each.name]")
    assert kernel.shown[cell].count("stuck") == 2 + 1  # it goes on, and the variable that ends it; it is stuck


def test_what_callbacks_print_is_shown_below_the_cell_of_their_node(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; from rclpy.node import Node; rclpy.init()")
    cell = kernel.start("node = Node('n'); timer = node.create_timer(0.05, lambda: print('tick'))")
    kernel.run("print('another')")
    kernel.wait(lambda: kernel.shown[cell].count("tick") > 3, cell)
    if int(version("ipykernel").partition(".")[0]) >= 7:  # the one before it knows one cell for each thread
        later = kernel.start("second = node.create_timer(0.05, lambda: print('tock'))")
        kernel.wait(lambda: kernel.shown[later].count("tock") > 3, later)
        assert "tock" not in kernel.shown[cell]
    assert kernel.run("timer.cancel(); print('another')") == "another\n"


def test_ros2_runs_without_a_terminal_and_ends_by_the_interrupt(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    cell = kernel.start("%ros2 run turtlesim turtlesim_node &")
    kernel.wait(lambda: "Spawning turtle [turtle1]" in kernel.shown[cell], cell)
    assert "\x1b" not in kernel.shown[cell]
    assert "/turtlesim\n" in kernel.run("%ros2 node list | sort")
    said = kernel.run("%ros2 topic echo /turtle1/pose", interrupt_after="theta")
    assert said.rstrip().endswith("^C") or "^C\n" in said
    assert "Traceback" not in said and "KeyboardInterrupt" not in said
    assert kernel.run("print(40 + 2)") == "42\n"
    kernel.run("%unload_ext day6_tui")
    assert "/turtlesim" not in kernel.run("!ros2 node list --no-daemon")
    assert "signal_handler(SIGINT" in kernel.shown[cell]
