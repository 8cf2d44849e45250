"""Against an implementation of others: zenoh-ros2-sdk (PyPI), which was written from rmw_zenoh and knows nothing of us."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import threading
from collections.abc import Iterator

import pytest

from tests.link.link_harness import HOUR, LEASE, World
from tests.support.waiting import until

pytestmark = [
    pytest.mark.process,
    pytest.mark.skipif(
        importlib.util.find_spec("zenoh_ros2_sdk") is None,
        reason="zenoh-ros2-sdk is not installed (the test extra has it)",
    ),
]

STRING = "std_msgs/msg/String"
START = """
import sys, time
import zenoh_ros2_sdk as sdk
port = int(sys.argv[1])
add = dict(srv_type="example_interfaces/srv/AddTwoInts", request_definition="int64 a\\nint64 b\\n",
           response_definition="int64 sum\\n", router_port=port)
text = dict(msg_type="std_msgs/msg/String", msg_definition="string data\\n", router_port=port)
"""


class Stranger:
    """A program that uses the SDK; prints lines, ends with its standard input."""

    def __init__(self, port: int, source: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-c", START + source, str(port)],
            env={
                **os.environ,
                "PYTHONPATH": "",
                "ZENOH_CONFIG_OVERRIDE": f'listen/endpoints=["tcp/127.0.0.1:0"];{LEASE}={HOUR}',
            },
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

        self.lines: list[str] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.append(line.strip())

    def says(self, *lines: str) -> bool:
        return bool(until(lambda: self.lines == list(lines)))

    def end(self) -> None:
        self.process.kill()
        self._reader.join()
        self.process.wait()


@pytest.fixture
def strangers() -> Iterator[list[Stranger]]:
    started: list[Stranger] = []
    yield started
    for each in started:
        each.end()


def test_its_publisher_is_listed_and_heard_here_and_behind_the_gate(
    world: World, port: int, strangers: list[Stranger]
) -> None:
    gate, behind = world.here(listen=f"tcp/127.0.0.1:{port}"), world.process()
    subscriptions = [(each, each.subscription(each.node("listener"), "/chatter", depth=50)) for each in (gate, behind)]
    strangers.append(
        Stranger(
            port,
            """
publisher = sdk.ROS2Publisher("/chatter", node_name="stranger", namespace="/far", **text)
while not publisher.pub.matching_status.matching:
    time.sleep(0.01)
for number in range(5):
    publisher.publish(data=f"hello {number}")
sys.stdin.read()
""",
        )
    )
    for each, subscription in subscriptions:
        assert until(lambda each=each: "/far/stranger" in each.nodes())
        assert until(lambda each=each, it=subscription: each.length(it) == 5)
        assert each.messages(subscription) == [f"hello {number}" for number in range(5)]
        (found,) = [found for found in each.endpoints("/chatter") if found[0] == "MP"]
        assert found[1:4] == ["/far/stranger", "/chatter", STRING]
        assert found[5] == "::,10:,:,:,,"
    strangers[0].process.kill()
    assert until(lambda: "/far/stranger" not in behind.nodes())


def test_it_hears_us(world: World, port: int, strangers: list[Stranger]) -> None:
    gate, behind = world.here(listen=f"tcp/127.0.0.1:{port}"), world.process()
    publisher = behind.publisher(behind.node("talker"), "/chatter")
    strangers.append(
        Stranger(
            port,
            """
sdk.ROS2Subscriber("/chatter", callback=lambda message: print(message.data, flush=True), **text)
sys.stdin.read()
""",
        )
    )
    assert until(lambda: behind.matched(publisher) == 1)
    # It says that it listens before it does: what is published in between is lost, as between any two of ROS.
    until(
        lambda: strangers[0].lines,
        every=0.1,
        meanwhile=lambda: behind.publish(publisher, data="from behind the gate"),
    )
    assert set(strangers[0].lines) == {"from behind the gate"}
    direct = gate.publisher(gate.node("direct"), "/chatter")
    assert until(lambda: gate.matched(direct) == 1)
    gate.publish(direct, data="from the gate")
    until(lambda: strangers[0].lines[-1] == "from the gate")


def test_its_client_asks_our_server(world: World, port: int, strangers: list[Stranger]) -> None:
    world.here(listen=f"tcp/127.0.0.1:{port}")
    behind = world.process()
    behind.service(behind.node("server"), "/add")
    strangers.append(
        Stranger(
            port,
            """
client = sdk.ROS2ServiceClient("/add", **add)
while not client.session_mgr.session.declare_querier(client.keyexpr).matching_status.matching:
    time.sleep(0.01)
for a in range(3):
    print(client.call(a=a, b=40).sum, flush=True)
sys.stdin.read()
""",
        )
    )
    assert strangers[0].says("40", "41", "42")


def test_our_client_asks_its_server(world: World, port: int, strangers: list[Stranger]) -> None:
    world.here(listen=f"tcp/127.0.0.1:{port}")
    behind = world.process()
    client = behind.client(behind.node("asker"), "/add")
    strangers.append(
        Stranger(
            port,
            """
kind = None
def serve(request):
    return response_class(sum=request.a + request.b)
server = sdk.ROS2ServiceServer("/add", callback=serve, **add)
response_class = server.response_msg_class
sys.stdin.read()
""",
        )
    )
    assert until(lambda: behind.matched(client))
    number = behind.call(client, 3, 4)
    assert until(lambda: behind.responses(client)) == [[number, 7]]
