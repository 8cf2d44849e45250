"""Which panes are seen when, and how large: the windows of the article, one after the other in one desktop."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import pytest

from tests.support.stepped_machine import SteppedMachine
from tests.tui.fakes import FakeDesk, FakeSimulation
from tests.tui.screens import opened, screen_lines, screen_text, step

SMALL, WIDE = (80, 24), (120, 40)


class Pupil:
    """Somebody with a keyboard: opens terminals with F2 and runs in them what opens windows."""

    def __init__(self, machine: SteppedMachine, desk: FakeDesk, app: Any, pilot: Any) -> None:
        self.machine, self.desk, self.app, self.pilot = machine, desk, app, pilot

    async def run(self, command: str, *, new: bool = True, reads_keys: bool = False) -> None:
        """Type a command in a new terminal, or in the first one; it goes on running."""
        if new:
            await self.pilot.press("f2")
            await step(self.app, self.pilot)
        terminal = self.desk.terminals[-1]
        terminal.title, terminal.busy = command, True
        terminal.discipline.front.is_raw = reads_keys
        await step(self.app, self.pilot)

    async def window(self, executable: str, package: str = "", *, launch: int = 0) -> Any:
        """A window opens; `launch` is the pid of the launch that runs its program."""
        known = set(self.app.desktop.panes)
        self.machine.start(package or executable, executable, screen=True, background=bool(launch))
        self.machine.until(lambda: len(self.machine.display.windows) > len(known))
        newest = self.machine.display.windows[-1]
        newest.command, newest.is_launched = launch, bool(launch)
        await step(self.app, self.pilot)
        (number,) = self.app.desktop.panes.keys() - known
        return self.app.desktop.panes[number]

    async def press(self, *keys: str) -> None:
        await self.pilot.press(*keys)
        await step(self.app, self.pilot)

    def size(self, pane: Any) -> tuple[int, int]:
        """Columns and rows of a pane, with its frame; none if it is not seen."""
        place = self.app.desktop.plan_now().places.get(pane.slot)
        return (place.width, place.height) if place is not None else (0, 0)

    @property
    def keyboard(self) -> Any:
        return self.app.desktop.focused_pane

    @property
    def terminals(self) -> list[Any]:
        return list(self.app.terminals.panes)


@asynccontextmanager
async def pupil(size: tuple[int, int], lang: str = "zh") -> AsyncIterator[Pupil]:
    machine, desk = SteppedMachine(), FakeDesk()
    desk.display = machine.display
    async with opened(desk, *size, lang=lang, scene="empty") as (app, pilot):
        yield Pupil(machine, desk, app, pilot)
    machine.end()


TELEOP = "ros2 run turtlesim turtle_teleop_key"
ECHO = "ros2 topic echo /turtle1/cmd_vel"


async def _section_2(one: Pupil) -> Any:
    await one.run("ros2 run turtlesim turtlesim_node", new=False)
    turtle = await one.window("turtlesim_node", "turtlesim")
    await one.run(TELEOP, reads_keys=True)
    await one.run(ECHO)
    return turtle


@pytest.mark.parametrize("size", [SMALL, WIDE])
@pytest.mark.parametrize("order", [(TELEOP, ECHO), (ECHO, TELEOP)])
async def test_a_whole_twist_has_room_beside_teleop_and_turtle(size: Any, order: Any) -> None:
    async with pupil(size) as one:
        await one.run("ros2 run turtlesim turtlesim_node", new=False)
        turtle = await one.window("turtlesim_node", "turtlesim")
        for command in order:
            await one.run(command, reads_keys=command is TELEOP)
        twist = [f"{part}:\n  x: 0.0\n  y: 0.0\n  z: 0.0\n" for part in ("linear", "angular")]
        echo = one.desk.terminals[1 + order.index(ECHO)]
        echo.write("\n" + "".join(twist) + "---\n")
        await step(one.app, one.pilot)
        text = screen_text(one.app)
        assert "linear:" in text and text.count("  z: 0.0") == 2 and "---" in text.split("angular:")[1]
        teleop = one.terminals[1 + order.index(TELEOP)]
        assert one.size(teleop)[1] >= 10 and one.size(turtle) >= (41, 22)


@pytest.mark.parametrize("lang", ["zh", "en"])
async def test_rviz_is_as_large_as_possible_when_the_wheels_turn_at_the_end_of_the_article(lang: str) -> None:
    """Sections 2 to 5.4 at 80x24: TurtleSim stays open, RViz comes from the launch, then wheel_spinner, then the sliders."""
    async with pupil(SMALL, lang) as one:
        turtle = await _section_2(one)
        await one.run("rqt_graph")
        graph = await one.window("rqt_graph")
        assert one.size(graph) >= (38, 8) and one.size(turtle) >= (24, 10)
        graph.close()
        await step(one.app, one.pilot)
        await one.run("ros2 run day6_publisher talker")
        await one.run("ros2 topic echo /chatter")
        await one.run("ros2 launch day6_publisher day6_display.launch.py")
        launch = one.keyboard
        rviz = await one.window("rviz2", launch=4711)
        assert one.keyboard is launch and one.size(rviz) == (80, 14) and one.size(launch) == (80, 8)
        one.app.desktop.go_to_pane(rviz)
        await one.run("ros2 run day6_publisher wheel_spinner")
        assert one.size(rviz) == (80, 14) and one.keyboard is one.terminals[-1] and one.size(one.keyboard)[1] >= 8
        assert one.size(turtle) == (0, 0), "it yields, as nobody uses it"
        assert one.app.desktop.holds(turtle) and "TurtleSim" in screen_lines(one.app)[1]
        # The fight of the two publishers: what moves the joints beside what shows it.
        await one.run("ros2 run joint_state_publisher_gui joint_state_publisher_gui")
        sliders = await one.window("joint_state_publisher_gui")
        assert one.size(rviz) == (80, 14) and one.size(sliders) >= (38, 8) and one.size(one.keyboard) >= (36, 8)
        assert one.keyboard is one.terminals[-1]


async def test_at_120x40_rviz_is_comfortable_beside_the_terminals_that_are_used() -> None:
    async with pupil(WIDE) as one:
        await _section_2(one)
        for command in ("talker", "listener", "ros2 launch day6_publisher day6_display.launch.py"):
            await one.run(command)
        rviz = await one.window("rviz2", launch=4711)
        await one.run("ros2 run day6_publisher wheel_spinner")
        await one.run("joint_state_publisher_gui")
        sliders = await one.window("joint_state_publisher_gui")
        assert one.size(rviz) >= (72, 28) and one.size(sliders) >= (44, 8) and one.size(one.keyboard) >= (40, 8)


async def test_windows_of_one_launch_are_seen_together() -> None:
    async with pupil(SMALL) as one:
        await _section_2(one)
        await one.run("ros2 launch day6_publisher all.launch.py")
        panes = [await one.window(each, launch=4711) for each in ("joint_state_publisher_gui", "rviz2")]
        assert not [one.size(pane) for pane in (*panes, one.keyboard) if one.size(pane) < (30, 6)], screen_text(one.app)
        assert one.keyboard is one.terminals[-1]


@pytest.mark.parametrize("size", [SMALL, WIDE])
async def test_when_a_large_window_is_closed_everything_stands_as_before_unless_somebody_moved_it(size: Any) -> None:
    async with pupil(size) as one:
        await _section_2(one)
        before = dict(one.app.desktop.plan_now().places)
        rviz = await one.window("rviz2")
        assert one.size(rviz) >= (72, 14) and one.size(one.keyboard) >= (40, 8)
        await one.press("f3", "f3", "f3")
        one.app.desktop.focus_pane(one.terminals[-1])
        rviz.close()
        await step(one.app, one.pilot)
        assert one.app.desktop.plan_now().places == before
        rviz = await one.window("rviz2")
        one.app.desktop.split_tree.swap(rviz.slot, one.keyboard.slot)
        rviz.close()
        await step(one.app, one.pilot)
        assert one.app.desktop.plan_now().places != before


async def test_tabs_that_are_not_seen_tell_what_they_are() -> None:
    async with pupil(SMALL, "en") as one:
        await _section_2(one)
        for command in ("ros2 run day6_publisher wheel_spinner", "ros2 run demo_nodes_cpp talker", "bash"):
            await one.run(command)
        await one.press("f3", "f3", "f3")
        for pane in one.terminals:
            one.app.desktop.go_to_pane(pane)
            await step(one.app, one.pilot)
            for line in screen_lines(one.app):
                words = line.split()
                numbers = [at for at, word in enumerate(words) if word.isdigit()]
                assert not any(words[at + 1].isdigit() for at in numbers if at + 1 < len(words)), line
        assert "2 TurtleSim" in screen_text(one.app)


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (200, 60), (20, 5)])
async def test_fifty_windows_at_a_time_are_all_reached_by_their_keys(size: Any) -> None:
    desk = FakeDesk()
    async with opened(desk, *size, lang="en", scene="empty") as (app, pilot):
        for number in range(50):
            desk.display.open("turtlesim", f"Turtle {number}", FakeSimulation(), chosen=number == 49)
        await step(app, pilot)
        reached = set()
        for _ in range(51):
            await pilot.press("f3")
            pane = app.desktop.focused_pane
            assert app.desktop.is_shown(pane) and app.screen.focused is pane.focus_target
            reached.add(pane.slot)
        await step(app, pilot)
        assert reached == set(app.desktop.slots) and len(reached) == 51
        for window in desk.display.windows:
            window.close()
        await step(app, pilot)
        assert not app.desktop.panes and app.desktop.focused_pane is app.terminals.panes[0]
