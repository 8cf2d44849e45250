"""Programs that tell about their reports: what is asked of whom, and what is done with odd answers."""

from __future__ import annotations

import json
import os
import signal
from typing import Any

import pytest

from day6_core.graph.endpoints import EndpointKind
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import finding
from day6_core.ros.programs.day6_inspector.process_reports import LONGEST_TEXT, read_process
from day6_core.ros.programs.day6_inspector.rules import findings
from tests.inspector.drills import HEAD, LISTENER
from tests.inspector.lab import Lab

GOOD: dict[str, Any] = {
    "pid": 7,
    "arguments": ["/home/a/talker.py", "x"],
    "nodes": [
        {
            "node": "/talker",
            "spun": False,
            "spins": False,
            "late": 2.0,
            "waiting": 0,
            "stands": False,
            "publishers": {"/chatter": 3},
            "subscriptions": {},
        }
    ],
    "busy": [],
    "standing": [],
    "hidden": [{"node": "", "thread": "", "error": "ValueError", "file": "/a/talker.py", "line": 3, "text": "x"}],
    "signs": [],
}


def test_an_answer_is_read() -> None:
    process = read_process("abc", json.dumps(GOOD).encode())
    assert process is not None and process.program == "talker.py" and process.nodes[0].publishers == {"/chatter": 3}
    assert process.hidden[0].place.short == "talker.py:3"
    assert {each.id for each in findings(Facts(processes=(process,)))} == {
        "inspector.never_spun",
        "inspector.hidden_error",
    }


@pytest.mark.parametrize(
    "answer",
    [
        b"",
        b"\xff\xfe",
        b"[]",
        b"{}",
        b"null",
        b'{"pid": "x"}',
        json.dumps({**GOOD, "nodes": [7]}).encode(),
        json.dumps({**GOOD, "nodes": 7}).encode(),
        json.dumps({**GOOD, "hidden": [{"node": "a"}]}).encode(),
        json.dumps({**GOOD, "arguments": None}).encode(),
        b"[" * 100_000,
    ],
    ids=range(11),
)
def test_what_is_no_answer_is_none(answer: bytes) -> None:
    assert read_process("abc", answer) is None


def test_long_texts_are_cut() -> None:
    process = read_process("abc", json.dumps({**GOOD, "arguments": ["a" * 10_000]}).encode())
    assert process is not None and len(process.arguments[0]) == LONGEST_TEXT


def test_a_command_that_would_press_return_by_itself_is_not_offered() -> None:
    assert (
        finding("error", "well", then="rm a\rb").next == "" and finding("error", "well", then="ls 家").next == "ls 家"
    )


@pytest.mark.process
def test_a_stopped_program_is_named_and_no_longer_judged(lab: Lab) -> None:
    lab.file(
        "program.py", HEAD + "rclpy.init()\nnode = Node('mine')\nnode.create_timer(0.1, print)\nrclpy.spin(node)\n"
    )
    lab.start("python3 program.py")
    lab.wait_node("/mine")
    lab.wait(lambda: lab.inspector._reports is not None and lab.inspector._reports.processes)
    pid = lab.inspector._reports.processes[0].pid  # type: ignore[union-attr]
    os.kill(pid, signal.SIGSTOP)
    try:
        found, _ = lab.finds("tells_nothing")
        assert found is not None and dict(found.parameters)["node"] == "/mine"
        assert "spin_ended" not in lab.findings
    finally:
        os.kill(pid, signal.SIGCONT)
    lab.wait(lambda: "tells_nothing" not in lab.findings)


@pytest.mark.process
def test_what_was_put_right_is_not_said_any_more(lab: Lab) -> None:
    lab.file("program.py", HEAD + "Twist().linear.x = 1\n")
    lab.run("python3 program.py")
    assert lab.finds("field_type")[0] is not None
    lab.file("program.py", HEAD + "Twist().linear.x = 1.0\n")
    lab.run("python3 program.py")
    lab.wait(lambda: "field_type" not in lab.findings)


@pytest.mark.process
def test_the_inspector_is_nowhere_while_it_looks_on(lab: Lab) -> None:
    lab.file("listener.py", LISTENER)
    lab.start("python3 listener.py")
    lab.wait(lambda: any(each.topic == "/chatter" for each in lab.desk.graph.endpoints(EndpointKind.SUBSCRIPTION)))
    assert "_day6_observer" not in lab.run("ros2 node list -a", 1)
    assert "/joint_states" not in lab.run("ros2 topic list", 1)
    assert "Publisher count: 0" in lab.run("ros2 topic info /chatter", 1)


@pytest.mark.process
def test_in_a_real_terminal_it_says_what_it_cannot_look_at(lab: Lab) -> None:
    from day6_core.ros.programs.day6_inspector.model import Inspector
    from day6_core.ros.programs.day6_inspector.sight import not_seen

    model = Inspector(lab.inspector._listening._node, lab.desk.clock, lab.desk.graph)
    assert not_seen(model.facts()) == (("terminals", ""), ("files", ""))
