"""Tab in a Python file: modules, message types and fields; elsewhere it indents."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.editing.completion import completions
from tests.editor.editor_bench import Bench

NODE = """\
from geometry_msgs.msg import Twist, PoseStamped as Where
from sensor_msgs.msg import JointState
from std_msgs.msg import String
class A(Node):
    def __init__(self):
        self.create_subscription(String, 'chatter', self.heard, 10)
        self.create_subscription(Twist, 'a', self.either, 10)
        self.create_subscription(String, 'b', self.either, 10)
        self.state = JointState()
        self.odd = Twist()
        self.odd = 3
    def heard(self, msg):
        HERE
    def either(self, msg):
        HERE
    def other(self, place: Where, unknown):
        msg = Twist()
        HERE
"""


def at_the_end(text: str, tmp_path: Path) -> tuple[list[str], int]:
    lines = text.split("\n")
    return completions(text, len(lines) - 1, len(lines[-1]), {}, tmp_path)


@pytest.mark.parametrize(
    ("text", "choices", "start"),
    [
        ("import geometry_", ["geometry_msgs"], 7),
        ("import os.pa", [], 10),
        ("from std_msgs.", ["msg"], 14),
        ("import rclpy.no", ["node"], 13),
        ("from turtlesim.srv import Ki", ["Kill"], 26),
        ("from geometry_msgs.msg import Twist, Vec", ["Vector3", "Vector3Stamped"], 37),
        ("from rclpy.executors import SingleT", ["SingleThreadedExecutor"], 28),
        ("import pupils_", ["pupils_module"], 7),
        ("import no_such_thing", [], 7),
        ("import rclpy  # so.", [], 19),
        ("x = 1", [], 5),
        ("x.", [], 2),
    ],
)
def test_modules_and_their_names(tmp_path: Path, text: str, choices: list[str], start: int) -> None:
    (tmp_path / "pupils_module.py").write_text("")
    found, begin = at_the_end(text, tmp_path)
    assert (found, begin) == (choices, start) if choices else found == []


@pytest.mark.parametrize(
    ("function", "typed", "choices"),
    [
        ("heard", "msg.", ["data"]),
        ("either", "msg.", []),
        ("other", "msg.", ["angular", "linear"]),
        ("other", "msg.linear.", ["x", "y", "z"]),
        ("other", "x = msg.li", ["linear"]),
        ("other", "place.", ["header", "pose"]),
        ("other", "place.pose.position.", ["x", "y", "z"]),
        ("other", "unknown.", []),
        ("other", "self.state.", ["effort", "header", "name", "position", "velocity"]),
        ("other", "self.state.name.", []),
        ("other", "self.odd.", []),
        ("other", "f(msg.angular.z, msg.linear.", ["x", "y", "z"]),
    ],
)
def test_fields_where_the_type_is_certain(tmp_path: Path, function: str, typed: str, choices: list[str]) -> None:
    before, _, after = NODE.partition(f"def {function}(")
    text = before + f"def {function}(" + after.partition("HERE")[0] + typed
    assert at_the_end(text + "", tmp_path)[0] == choices


async def _pressed(bench: Bench, text: str, *keys: str) -> str:
    bench.pane.area.load_text(text)
    bench.pane.area.move_cursor(bench.pane.area.document.end)
    for key in keys:
        await bench.slowly(key)
    return bench.text


def test_tab_completes_offers_and_indents(tmp_path: Path) -> None:
    seen: list[Any] = []

    async def act(bench: Bench) -> None:
        seen.append(await _pressed(bench, "from geometry_msgs.msg import Twi", "tab"))
        seen.append(await _pressed(bench, "from geometry_msgs.msg import Vec", "tab"))
        await bench.slowly("tab")
        assert "Which one?" in await bench.press("down")
        await bench.press("enter")
        seen.append(bench.text)
        seen.append(await _pressed(bench, "import tf2_r", "tab", "enter"))
        seen.append(await _pressed(bench, "if x:\n    ", "tab"))
        seen.append(await _pressed(bench, "x = 1", "tab"))

    Bench(tmp_path).run(act)
    assert seen == [
        "from geometry_msgs.msg import Twist",
        "from geometry_msgs.msg import Vector3",
        "from geometry_msgs.msg import Vector3Stamped",
        "import tf2_ros\n",
        "if x:\n        ",
        "x = 1   ",
    ]


def test_a_tab_in_a_paste_and_in_other_files_is_a_tab_or_blanks(tmp_path: Path) -> None:
    seen: list[Any] = []

    async def act(bench: Bench) -> None:
        seen.append(await _pressed(bench, "import tf2_r", "tab"))

    Bench(tmp_path, file="notes.txt").run(act)
    assert seen[0].strip() == "import tf2_r" and seen[0] != "import tf2_r"
