"""A node for asyncio, in the shape of its official tutorial: two nodes on one event loop, in a process of Lyrical."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.distribution.command import day6

PROGRAM = """
import asyncio
import rclpy
from example_interfaces.srv import AddTwoInts, Trigger
from rclpy.experimental import AsyncNode
from std_msgs.msg import String


class Server(AsyncNode):
    def __init__(self):
        super().__init__("server")
        self.adding = self.create_client(AddTwoInts, "add")
        self.create_service(Trigger, "trigger", self.triggered)
        self.create_service(AddTwoInts, "add", self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response

    async def triggered(self, request, response):
        await self.get_clock().sleep(0.01)
        answer = await self.adding.call(AddTwoInts.Request(a=2, b=3))
        response.message = f"2+3={answer.sum}"
        return response


async def main():
    with rclpy.init():
        server = Server()
        running = asyncio.create_task(server.run())
        async with AsyncNode("client") as node:
            heard, infos, ticks = [], [], []
            publisher = node.create_publisher(String, "c", 10)

            async def slowly(message):
                await asyncio.sleep(0)
                heard.append(message.data)

            node.create_subscription(String, "c", slowly, 10)
            node.create_subscription(String, "c", lambda message, info: infos.append(len(info)), 10, concurrent=True)
            timer = node.create_timer(0.01, lambda: (ticks.append(1), publisher.publish(String(data=str(len(ticks))))))
            client = node.create_client(Trigger, "trigger")
            await client.wait_for_service()
            await node.wait_for_node("server")
            print((await client.call(Trigger.Request())).message)
            while len(heard) < 3:
                await asyncio.sleep(0.01)
            timer.cancel()
            print(heard[:3], bool(infos), timer.is_canceled(), timer.time_until_next_call())
            server.destroy_node()
            await running
        try:
            node.create_timer(1.0, print)
        except RuntimeError as error:
            print(error)

        async def failing():
            async with AsyncNode("failing") as node:
                node.create_timer(0.01, lambda: 1 / 0)
                await asyncio.sleep(10)

        try:
            await failing()
        except BaseException as error:
            print(type(error).__name__, error.exceptions)

asyncio.run(main())
"""


@pytest.mark.process
@pytest.mark.skipif(sys.version_info < (3, 11), reason="asyncio.TaskGroup")
def test_callbacks_services_and_timers_run_on_the_event_loop(tmp_path: Path) -> None:
    program = tmp_path / "program.py"
    program.write_text(PROGRAM, encoding="utf-8")
    done = day6("python", str(program), ROS_DISTRO="lyrical")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "2+3=5",
        "['1', '2', '3'] True True None",
        "Cannot create timer on a destroyed node",
        "ExceptionGroup (ZeroDivisionError('division by zero'),)",
    ]
    assert "cannot import name 'AsyncNode'" in day6("python", str(program), ROS_DISTRO="kilted").stderr
