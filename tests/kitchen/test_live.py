"""The kitchen of a whole machine: what a student's program puts on a belt that nobody takes from, and commands by their names."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from day6_core.ros.programs.day6_kitchen.model import Kitchen
from day6_core.shell.desk import Desk
from day6_core.shell.terminal import Terminal
from tests.support.waiting import until

TALKER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('talker')
publisher = node.create_publisher(String, 'news', 10)
node.create_timer(0.1, lambda: publisher.publish(String(data='hello')))
rclpy.spin(node)
"""


@pytest.fixture
def desk(short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Desk]:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "r"))
    monkeypatch.setenv("DAY6_LINK", "on")
    made = Desk(short_folder / "home", domain_id=0)
    made.start()
    yield made
    made.hurry()
    made.close()


def terminal_with(desk: Desk, line: str) -> Terminal:
    made: list[Terminal] = []
    desk.scheduler.call_soon_threadsafe(lambda: made.append(desk.open_terminal(100, 30)))
    until(lambda: made)
    made[0].run_line(line)
    return made[0]


@pytest.mark.process
def test_what_a_students_program_says_to_nobody_piles_up_until_a_command_takes_it(desk: Desk) -> None:
    (desk.home / "talker.py").write_text(TALKER, encoding="utf-8")
    terminals = [terminal_with(desk, "python3 talker.py"), terminal_with(desk, "ros2 run day6_kitchen kitchen")]
    display = desk.display
    assert display is not None

    def look(condition: Callable[[], object]) -> None:
        """Look as a window does, and at the terminals, until something holds."""

        def holds() -> object:
            for each in terminals:
                each.update()
            kitchen.look(time.monotonic())
            return condition()

        until(holds, told=lambda: f"{kitchen.content}\n{kitchen.rates}\n{kitchen.left}")

    found = until(lambda: [each.model for each in display.windows if each.kind == "kitchen"], told=lambda: "no window")
    assert isinstance(found[0], Kitchen)
    kitchen = found[0]
    look(lambda: kitchen.content.belt("/news") and kitchen.left.get("/news", 0) > 5 and kitchen.rates["/news"])
    assert kitchen.conveyor.moving, "what is counted is seen on its way"
    terminals.append(terminal_with(desk, "ros2 topic hz /news"))
    look(lambda: [cook.title for cook in kitchen.content.cooks] == ["talker", "ros2 topic hz"])
    look(lambda: not kitchen.left)
