"""What goes wrong is told in the very words of real rclpy 9.1.2, with rcl's files and lines.

`PYTHON tests/rclpy/test_texts.py`, with an interpreter that has the real rclpy, records the cases into texts.json.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from std_msgs.msg import Int32, String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci
from test_msgs.msg import BasicTypes

from rclpy.action import ActionClient, ActionServer
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.expand_topic_name import expand_topic_name
from rclpy.guard_condition import GuardCondition
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.serialization import deserialize_message
from rclpy.subscription_content_filter_options import ContentFilterOptions

TEXTS = Path(__file__).parent / "texts.json"
RECORDED: dict[str, list[str]] = json.loads(TEXTS.read_text(encoding="utf-8"))

ARGUMENTS = (
    "-r|x", "-r|x:=", "-r|x:=1y", "-r|*:=y", "-r|**:=y", "-r|:=y", "-r|a/**:=y", "-r|a/*:=y", r"-r|x:=\1", r"-r|\1:=x",
    "-r|__node:=/x", "-r|__node:=a/b", "-r|__node:=1", "-r|__ns:=x", "-r|__ns:=/1", "-r|x:y:z:=w", "-r|a:=b:c", "-r|a b:=c",
    "-r|a:=b c", "-r|/a//b:=c", "-r|a:=/b//c", "-r|a:=~", "-r|~:=a", "-r|a:=b/", "-r|rostopic://:=b", "-r|:a:=b", "-p|x",
    "-p|x:=", "-p|*:=1", "-p|**:=1", "-p|:=1", "-p|a.:=1", "-p|a..b:=1", "-p|a.*:=1", "-p|a b:=1", "-p|n:a", "-p|x:=[1, a]",
    "-p|x:=[1, 2.0]", "-p|x:=[a, 1]", "-p|x:=[a, true]", "-p|x:={a: 1}", "-p|x:=[1", "-p|x:=*a", "-p|x:=[1, ]a", "-p|1:=2",
    "-p|__x:=1", "--params-file|/no/such/file", "--params-file|/", "--log-level|loud", "--log-level|x:=loud",
    "--log-level|:=info", "--log-level|x:=info:=debug", "--log-level|x:=", "--log-level|", "-r", "-p", "--remap", "--param",
    "--params-file", "--log-level", "-e", "--enclave", "--log-file-name", "--log-config-file", "-e|x", "-e|/a//b", "-e|/a/",
    "-e|/1", "-e|/a b", "--wrong", "--wrong|-p",
)  # fmt: skip
FILES = (
    "/**: 5\n", "/**:\n  ros__parameters: 5\n", "ros__parameters:\n  a: 1\n", "[1, 2]\n", "/**: [1]\n",
    "/**:\n  ros__parameters:\n    [a]: 1\n", "/**:\n  ros__parameters:\n    {a: b}: 1\n",
    "/**:\n  ros__parameters:\n    a: [1, x]\n", "/**:\n  ros__parameters:\n    a: [true, 1]\n",
    "/**:\n  ros__parameters:\n    a: [1, 2.5]\n", "/**:\n  ros__parameters:\n    a: [x, true]\n",
    "/**:\n  ros__parameters:\n    a:\n", "/**:\n  ros__parameters:\n    '': 1\n",
    "/**:\n  ros__parameters:\n    a: &x 1\n    b: *x\n", "/**:\n  ros__parameters: {a: 1\n",
    "/a//b:\n  ros__parameters: {a: 1}\n", "/a-b:\n  ros__parameters: {a: 1}\n", "/1b:\n  ros__parameters: {a: 1}\n",
    "/**:\n  ros__parameters: [1]\n",
)  # fmt: skip
NAMES = ("", "a b", "a/", "1a", "a/1", "~ab", "a~", "{a", "a}", "{a b}", "{{a}}", "{1}", "{x}", "a//b", "a" * 300)


def _ended_node(world: Any) -> Node:
    node = Node("ended", context=world.context)
    world.context.shutdown()
    return node


CASES: dict[str, Callable[[Any], Any]] = {}
for _name in NAMES:
    CASES |= {
        f"publisher {_name}": lambda w, n=_name: w.node("n").create_publisher(String, n, 1),
        f"subscription {_name}": lambda w, n=_name: w.node("n").create_subscription(String, n, print, 1),
        f"service {_name}": lambda w, n=_name: w.node("n").create_service(Trigger, n, print),
        f"client {_name}": lambda w, n=_name: w.node("n").create_client(Trigger, n),
        f"action server {_name}": lambda w, n=_name: ActionServer(w.node("n"), Fibonacci, n, print),
        f"action client {_name}": lambda w, n=_name: ActionClient(w.node("n"), Fibonacci, n),
        f"resolve topic {_name}": lambda w, n=_name: w.node("n").resolve_topic_name(n),
        f"resolve service {_name}": lambda w, n=_name: w.node("n").resolve_service_name(n),
        f"count {_name}": lambda w, n=_name: w.node("n").count_publishers(n),
        f"info {_name}": lambda w, n=_name: w.node("n").get_publishers_info_by_topic(n),
        f"expand {_name}": lambda _, n=_name: expand_topic_name(n, "n", "/"),
        f"expand at {_name}": lambda _, n=_name: expand_topic_name("t", n, "/"),
        f"expand in {_name}": lambda _, n=_name: expand_topic_name("t", "n", n),
        f"node {_name}": lambda w, n=_name: w.node(n),
        f"namespace {_name}": lambda w, n=_name: w.node("n", namespace=n),
        f"of node {_name}": lambda w, n=_name: w.node("n").get_publisher_names_and_types_by_node(n, "/"),
        f"of namespace {_name}": lambda w, n=_name: w.node("n").get_service_names_and_types_by_node("n", n),
    }
for _text in ARGUMENTS:
    CASES[f"arguments {_text}"] = lambda _, t=_text: Context().init(["--ros-args", *t.split("|")])
for _text in ("-r|x", "-p|x", "-r", "--wrong", "--log-level|loud"):
    CASES[f"arguments of a node {_text}"] = lambda w, t=_text: w.node("n", cli_args=["--ros-args", *t.split("|")])
for _text in FILES:

    def _read(world: Any, text: str = _text) -> None:
        path = world.folder / "p.yaml"
        path.write_text(text, encoding="utf-8")
        Context().init(["--ros-args", "--params-file", str(path)])

    CASES[f"file {_text}"] = _read
for _policy, _number in (("history", 3), ("reliability", 3), ("durability", 3), ("liveliness", 4)):
    _profile = QoSProfile(depth=1, **{_policy: _number})
    CASES |= {
        f"unknown {_policy} of a publisher": lambda w, q=_profile: w.node("n").create_publisher(String, "t", q),
        f"unknown {_policy} of a subscription": lambda w, q=_profile: w.node("n").create_subscription(
            String, "t", print, q
        ),
    }
for _what, _use in {
    "publisher": lambda node: node.create_publisher(String, "t", 1),
    "subscription": lambda node: node.create_subscription(String, "t", print, 1),
    "service": lambda node: node.create_service(Trigger, "t", print),
    "client": lambda node: node.create_client(Trigger, "t"),
    "timer": lambda node: node.create_timer(1.0, print),
    "guard condition": lambda node: node.create_guard_condition(print),
    "node names": lambda node: node.get_node_names(),
    "topic names": lambda node: node.get_topic_names_and_types(),
    "service names": lambda node: node.get_service_names_and_types(),
    "publishers of a node": lambda node: node.get_publisher_names_and_types_by_node("n", "/"),
    "clients of a node": lambda node: node.get_client_names_and_types_by_node("n", "/"),
    "count of subscribers": lambda node: node.count_subscribers("t"),
    "publishers of a topic": lambda node: node.get_publishers_info_by_topic("t"),
    "subscriptions of a topic": lambda node: node.get_subscriptions_info_by_topic("t"),
}.items():
    CASES[f"after the shutdown: {_what}"] = lambda w, use=_use: use(_ended_node(w))


def _ended(world: Any) -> Context:
    world.context.shutdown()
    context: Context = world.context
    return context


CASES |= {
    "executor after the shutdown": lambda w: SingleThreadedExecutor(context=_ended(w)),
    "guard condition after the shutdown": lambda w: GuardCondition(None, None, context=_ended(w)),
    "shutdown twice": lambda w: _ended(w).shutdown(),
    "node after the shutdown": lambda w: Node("n", context=_ended(w)),
    "negative period": lambda w: w.node("n").create_timer(-1.0, print),
    "another type": lambda w: (
        w.node("n").create_publisher(String, "t", 1),
        w.node("m").create_publisher(Int32, "t", 1),
    ),
    "another type of a subscription": lambda w: (
        w.node("n").create_publisher(String, "t", 1),
        w.node("m").create_subscription(Int32, "t", print, 1),
    ),
    "bad bytes": lambda _: deserialize_message(bytes.fromhex("00010000ff000000"), String),
    "bad filter": lambda w: w.node("n").create_subscription(
        BasicTypes, "t", print, 1, content_filter_options=ContentFilterOptions("nothing = 1", [])
    ),
    "no filter to get": lambda w: w.node("n").create_subscription(BasicTypes, "t", print, 1).get_content_filter(),
    "no filter to end": lambda w: w.node("n").create_subscription(BasicTypes, "t", print, 1).set_content_filter("", []),
    "no such node": lambda w: w.node("n").get_client_names_and_types_by_node("nobody", "/"),
    "no name of a node": lambda w: w.node(None),
    "no name of a topic": lambda w: w.node("n").create_publisher(String, None, 1),
}


def told(case: str, world: Any) -> list[str]:
    """Return kind and text of the exception of a case, [] where there is none."""
    try:
        CASES[case](world)
    except Exception as error:
        return [type(error).__name__, str(error).replace(f"{world.folder}{os.sep}", "FOLDER/")]
    return []


@pytest.mark.parametrize("case", list(RECORDED))
def test_what_goes_wrong_is_told_as_by_real_rclpy(world: Any, tmp_path: Path, case: str) -> None:
    if os.name == "nt" and case == "arguments --params-file|/":
        pytest.skip("a folder cannot be opened there")
    world.folder = tmp_path
    assert told(case, world) == RECORDED[case]


def test_every_case_was_recorded() -> None:
    assert set(CASES) == set(RECORDED)


class RealWorld:
    """What a case needs, of the real rclpy."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.context = Context()
        self.context.init([])

    def node(self, name: str, **keywords: Any) -> Node:
        return Node(name, context=self.context, **keywords)


def record() -> None:
    """Write what every case tells here."""
    texts = {}
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            world = RealWorld(Path(folder))
            texts[case] = told(case, world)
            world.context.try_shutdown()
    TEXTS.write_text(json.dumps(texts, indent=0, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    record()
