"""Cells of a real kernel after `%load_ext day6_tui`: a pupil writes them as for real ROS, and callbacks run between them."""

from __future__ import annotations

import os
import queue
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

manager = pytest.importorskip("jupyter_client.manager", reason="there is no ipykernel here")
pytest.importorskip("ipykernel", reason="there is no ipykernel here")

PATIENCE = 60.0

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


class Kernel:
    """Runs cells and gathers what they print, by the messages a notebook gets."""

    def __init__(self, runtime: Path) -> None:
        environment = {**os.environ, "DAY6_RUNTIME_DIR": str(runtime), "DAY6_LINK": "on"}
        environment.pop("PYTHONPATH", None)
        self.manager = manager.KernelManager()
        self.manager.kernel_spec.argv[0] = sys.executable
        self.manager.start_kernel(env=environment)
        self.client: Any = self.manager.client()
        self.client.start_channels()
        self.client.wait_for_ready(timeout=PATIENCE)

    def run(self, code: str, *, interrupt_after: str = "") -> str:
        """Run a cell; its text and errors. With `interrupt_after` the kernel is interrupted when that was printed."""
        request = self.client.execute(code)
        text, end = "", time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                message = self.client.get_iopub_msg(timeout=1.0)
            except queue.Empty:
                continue
            kind, content = message["msg_type"], message["content"]
            if kind == "stream":
                text += content["text"]
            elif kind == "error":
                text += f"{content['ename']}: {content['evalue']}"
            elif kind == "status" and content["execution_state"] == "idle" and _is_answer(message, request):
                return text
            if interrupt_after and interrupt_after in text:
                interrupt_after = ""
                self.manager.interrupt_kernel()
        raise AssertionError(f"the cell has not ended: {text}")

    def until(self, expression: str) -> None:
        """Run cells until this is true: what happens in between happens without a cell."""
        end = time.monotonic() + PATIENCE
        while "True" not in self.run(f"print(bool({expression}))"):
            assert time.monotonic() < end, expression
            time.sleep(0.1)

    def close(self) -> None:
        self.client.stop_channels()
        self.manager.shutdown_kernel(now=True)


def _is_answer(message: dict[str, Any], request: str) -> bool:
    return bool(message["parent_header"].get("msg_id") == request)


@pytest.fixture
def kernel(short_folder: Path) -> Iterator[Kernel]:
    made = Kernel(short_folder / "r")
    yield made
    made.close()


def test_nodes_of_cells_live_between_them(kernel: Kernel) -> None:
    assert kernel.run("%load_ext day6_tui") == ""
    assert kernel.run("import rclpy; rclpy.init()") == ""
    assert kernel.run(TALKER) == ""
    kernel.until("node.count > 3")
    kernel.run("heard = []; listener = Node('listener')")
    kernel.run("listener.create_subscription(String, 'chatter', lambda message: heard.append(message.data), 10);")
    kernel.until("len(heard) > 3 and heard[0].startswith('hello')")
    assert "/talker" in kernel.run("%ros2 node list")
    assert "/chatter" in kernel.run("!ros2 topic list")

    assert "/talker: the node that was made here before has been destroyed" in kernel.run(TALKER)
    assert kernel.run("print(listener.get_node_names().count('talker'))") == "1\n"

    said = kernel.run("print('spinning', flush=True); rclpy.spin(node)", interrupt_after="spinning")
    assert "KeyboardInterrupt" in said
    assert kernel.run("print(rclpy.ok())") == "True\n"
    kernel.run("before = node.count")
    kernel.until("node.count > before + 3")


def test_services_answer_in_the_cell_that_calls(kernel: Kernel) -> None:
    kernel.run("%load_ext day6_tui")
    kernel.run("import rclpy; from rclpy.node import Node; from example_interfaces.srv import AddTwoInts; rclpy.init()")
    kernel.run("def add(request, response):\n    response.sum = request.a + request.b\n    return response")
    kernel.run("server = Node('server'); server.create_service(AddTwoInts, 'add', add); user = Node('user')")
    kernel.run("client = user.create_client(AddTwoInts, 'add'); print(client.wait_for_service(10.0))")
    assert kernel.run("print(client.call(AddTwoInts.Request(a=40, b=2)).sum)") == "42\n"
    future = "future = client.call_async(AddTwoInts.Request(a=1, b=2)); rclpy.spin_until_future_complete(user, future)"
    assert kernel.run(f"{future}; print(future.result().sum)") == "3\n"

    kernel.run("def fail(): raise ValueError('of the pupil')")
    kernel.run("timer = user.create_timer(0.05, fail)")
    said = kernel.run("import time; time.sleep(1); timer.cancel()")
    assert "ValueError" in said or "ValueError" in kernel.run("time.sleep(0.5)")
    assert kernel.run("print(client.call(AddTwoInts.Request(a=5, b=6)).sum)") == "11\n"
    assert kernel.run("%unload_ext day6_tui") == ""
    assert kernel.run("print(rclpy.ok())") == "True\n"
