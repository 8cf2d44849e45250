"""A Chinese comma in a robot description: the real tool's own message, the hint below it, the card, the editor."""

from __future__ import annotations

import os
from typing import Any

import pytest

from day6_core.advice.rules import in_short
from tests.shell.explanations.asking import said

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a terminal there has no pty")

ROBOT = """<robot name="car">
  <link name="base"/>
  <link name="wheel"/>
  <joint name="j" type="continuous">
    <parent link="base"/>
    <child link="wheel"/>
    <axis xyz="0，1，0"/>
  </joint>
</robot>
"""


@pytest.mark.parametrize("command", ["check_urdf", "ros2 run robot_state_publisher robot_state_publisher"])
def test_a_chinese_comma_is_told_below_the_tools_own_message(machine: Any, tall: Any, command: str) -> None:
    (machine.desk.home / "car.urdf").write_text(ROBOT)
    seen = said(tall, f"{command} car.urdf")
    message, hint = "Unable to parse component [0，1，0] to a double", 'write "0 1 0" instead of "0，1，0"'
    assert message in seen and hint in seen and seen.index(message) < seen.index(hint)
    card = said(tall, "why")
    assert hint in card and "What to check" not in card
    tall.line("export DAY6_LANG=zh")
    seen = said(tall, f"{command} car.urdf")
    assert message in seen and '把 "0，1，0" 写成 "0 1 0"' in seen and "意思：" not in seen


def test_the_editor_says_it_with_its_line() -> None:
    message = (
        "Malformed axis element for joint [j]: Unable to parse component [0，1，0] to a double (while parsing a vector)"
    )
    assert in_short(message, 7, "en").startswith('line 7: put spaces between numbers, not a Chinese "，"')
    assert in_short(message, 7, "zh").startswith("第 7 行：数和数之间用空格")
