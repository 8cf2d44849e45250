"""Robots and windows of every size: the picture and the panel bear them, with any colours and characters."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from day6_tui.panes.cells import cell_len
from tests.rviz2.rviz_walk import Walk, run, walking
from tests.rviz2.test_first_robot import in_pane, is_whole

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine


def link(name: str, geometry: str) -> str:
    return f'<link name="{name}"><visual><geometry>{geometry}</geometry></visual></link>'


def fixed(parent: str, child: str, xyz: str) -> str:
    return (
        f'<joint name="{parent}_{child}" type="fixed"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}"/></joint>'
    )


def of_many_links(count: int) -> str:
    """A staircase."""
    links = "".join(link(f"l{number}", '<box size="0.3 0.3 0.1"/>') for number in range(count))
    return links + "".join(fixed(f"l{number}", f"l{number + 1}", "0.1 -0.1 0.02") for number in range(count - 1))


SEEN = {
    "one link": link("l0", '<box size="0.4 0.25 0.08"/>'),
    "500 links": of_many_links(500),
    "a speck": link("l0", '<sphere radius="0.002"/>'),
    "a mountain": link("l0", '<box size="4000 3000 900"/>'),
    "a rod": link("l0", '<cylinder radius="0.01" length="3"/>'),
}
NOT_SEEN = {
    "of no size": link("l0", '<box size="0 0 0"/>'),
    "flat": link("l0", '<box size="1 1 0"/>'),
    "no visual": '<link name="l0"/>',
    "no mesh": link("l0", '<mesh filename="package://nowhere/no.stl"/>')
    + link("l1", '<mesh filename="file:///no.dae"/>')
    + fixed("l0", "l1", "0 0 1"),
    "out of all bounds": link("l0", '<box size="1e30 1e30 1e30"/>')
    + link("l1", "<sphere radius='1e-30'/>")
    + fixed("l0", "l1", "1e25 0 0"),
}
ENVIRONMENTS = {
    "colours": {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"},
    "sixteen": {"LANG": "C.UTF-8", "TERM": "linux"},
    "none": {"LANG": "C.UTF-8", "TERM": "xterm", "NO_COLOR": "1"},
    "ascii": {"LANG": "C", "TERM": "vt100"},
}
SCREENS = [
    ("colours", (20, 5)),
    ("colours", (78, 11)),
    ("sixteen", (38, 21)),
    ("none", (38, 21)),
    ("ascii", (20, 5)),
]


async def with_robot(at: Walk, machine: RVizMachine, tmp_path: Path, urdf: str) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text(f'<robot name="r">{urdf}</robot>', encoding="utf-8")
    machine.start("robot_state_publisher", "robot_state_publisher", str(file))
    machine.fix("l0")
    robot = machine.add("RobotModel", "/robot_description")
    machine.add("TF").names.set(True)
    machine.until(lambda: robot.status("URDF") is not None)
    await at.settle()


def assert_is_well(at: Walk) -> None:
    pane, lines = at.pane, at.screen().splitlines()
    assert not pane._failed and pane.rviz is at.machine.rviz
    assert all(cell_len(line) <= pane.size.width for line in lines)
    assert pane.view.columns and pane.view.rows
    assert pane.division.view.size == (pane.view.columns, pane.view.rows)


@pytest.mark.long
@pytest.mark.parametrize(
    ("robot", "environ", "size"),
    [(robot, *SCREENS[(n + more) % len(SCREENS)]) for n, robot in enumerate([*SEEN, *NOT_SEEN]) for more in (0, 2)],
)
def test_a_robot_in_a_window(
    machine: RVizMachine, tmp_path: Path, robot: str, environ: str, size: tuple[int, int]
) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane(size), environ=ENVIRONMENTS[environ]) as at:
            await with_robot(at, machine, tmp_path, {**SEEN, **NOT_SEEN}[robot])
            assert_is_well(at)
            if robot in SEEN:
                await at.until(lambda: at.pane.view.cells is not None and is_whole(at))
                cells = at.pane.view.cells
                drawn = (cells.chars != ord(" ")) | (cells.back != cells.back[0, 0])
                rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
                assert rows.size > at.pane.view.rows / 3 or columns.size > at.pane.view.columns / 3
            for key in ("f", "d", "tab", "plus", "left", "4", "v", "f", "v", "f", "d"):
                await at.press(key)
                assert_is_well(at)

    run(walk())


@pytest.mark.long
@pytest.mark.parametrize("columns", [8, 12, 20, 39, 52, 53, 54, 73, 74, 75])
def test_every_size_of_a_window_has_a_view_whatever_is_open(machine: RVizMachine, columns: int) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane((columns, 30))) as at:
            for rows in (4, 5, 9, 14, 20, 21):
                await at.pilot.resize_terminal(*in_pane((columns, rows)))
                await at.settle()
                for key in ("d", "d", "tab", "shift+tab"):
                    await at.press(key)
                    assert_is_well(at)

    run(walk())
