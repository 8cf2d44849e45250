"""The page of a step keeps its task in sight, and F5 leads to where the step is done."""

from __future__ import annotations

import threading
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from rich.segment import Segment

from day6_core.lessons.catalogue import LessonOffer, days, drills, offer
from day6_core.lessons.state import State
from day6_tui.app import make_look
from day6_tui.options import Options
from day6_tui.panes.layouts import lesson as lesson_layout
from day6_tui.panes.splits import Split
from day6_tui.windows.lesson.page import PageRow, StepPage, list_rows, step_page
from tests.support import waiting
from tests.tui.screens import UTF8, screen_lines, screen_text, step
from tests.tui.test_real_desk import _shows, _type, opened, until

COURSE: Any = SimpleNamespace(kept=SimpleNamespace(failed=""))


def rows(words: str, count: int) -> list[PageRow]:
    return [PageRow([Segment(f"{words} {number}")]) for number in range(count)]


def texts_of(found: list[PageRow]) -> list[str]:
    return ["".join(segment.text for segment in row.line) for row in found]


def page(*, do: int = 2, checks: int = 2, picture: int = 0, problems: int = 0, told: int = 0) -> StepPage:
    return StepPage(
        rows("title", 1), rows("picture", picture), rows("text", 12), rows("problem", problems), rows("do", do), [],
        rows("check", checks), rows("told", told),
    )  # fmt: skip


def test_where_all_has_room_nothing_is_pinned() -> None:
    found, pinned = page().laid_out(30)
    assert pinned == [] and texts_of(found)[-2:] == ["check 0", "check 1"]


def test_the_task_stays_below_what_scrolls() -> None:
    found, pinned = page().laid_out(13)
    assert texts_of(pinned) == ["do 0", "do 1", "check 0", "check 1"]
    assert "text 11" in texts_of(found) and "do 0" not in texts_of(found)


def test_checks_make_room_for_the_text_and_scroll_with_it() -> None:
    found, pinned = page(checks=9, told=1).laid_out(12)
    assert texts_of(pinned) == ["do 0", "do 1", "told 0"]
    assert texts_of(found)[-1] == "check 8"


def test_what_comes_next_is_told_where_hardly_a_line_is_left_to_read() -> None:
    _, pinned = page(do=6, told=1).laid_out(10)
    assert texts_of(pinned)[-1] == "told 0" and len(pinned) == 7


def test_a_task_that_is_as_high_as_the_window_comes_first() -> None:
    found, pinned = page(do=9).laid_out(10)
    assert pinned == [] and texts_of(found)[0] == "do 0" and "text 11" in texts_of(found)


def test_in_a_low_window_the_picture_comes_after_the_text() -> None:
    high, _ = page(picture=5).laid_out(22)
    low, _ = page(picture=5).laid_out(12)
    assert texts_of(high).index("picture 0") < texts_of(high).index("text 0")
    assert texts_of(low).index("picture 0") > texts_of(low).index("text 11")


@pytest.mark.parametrize("language", ["zh", "en"])
@pytest.mark.parametrize("height", [10, 20])
def test_of_every_step_of_the_six_days_the_task_is_in_sight(language: str, height: int) -> None:
    """Of 20 lines, which the page has alone, and of 10, which it has above a picture."""
    look = make_look(Options(lang=language), UTF8)
    hidden = []
    for each in days():
        for number, task in enumerate(each.steps):
            built = step_page(COURSE, State(each, number), look, 36, lambda what: lambda: what)
            scrolls, pinned = built.laid_out(height)
            there = pinned or scrolls[:height]
            wanted = built.do if height == 20 else built.do[:1]
            if not all(row in there for row in wanted):
                hidden.append((each.name, task.name))
    assert hidden == []


def test_a_step_has_its_panes_in_two_columns() -> None:
    tree = lesson_layout(1, [2], [3, 4], [5], [6], 80)
    assert isinstance(tree.root, Split) and tree.root.across
    assert [[stack.keys for stack in tree.stacks(part)] for part in tree.root.parts] == [[[2, 5], [3]], [[1], [4, 6]]]
    assert [stack.front for stack in tree.stacks()] == [2, 3, 1, 4]
    for width, columns in ((80, 38), (120, 45), (200, 45)):
        root = lesson_layout(1, [2], [], [], [], width).root
        assert isinstance(root, Split) and root.shares is not None
        assert round(root.shares[1] * width) == columns


def test_drills_are_numbered_in_their_order() -> None:
    course: Any = SimpleNamespace(
        exam=None, state=State(), progress=SimpleNamespace(solved=lambda name: 0),
        offer=SimpleNamespace(lessons=(), drills=drills(), broken=()),
    )  # fmt: skip
    found, entries = list_rows(course, make_look(Options(lang="en"), UTF8), 60, -1, lambda number: None)
    shown = [texts_of(found)[entry.row].split()[0] for entry in entries]
    assert shown == [str(number) for number in range(1, len(drills()) + 1)]


@asynccontextmanager
async def lesson(home: Path, name: str) -> AsyncIterator[tuple[Any, Any]]:
    """The desktop at 80x24 with a lesson at its first step."""
    async with opened(home, 80, 24, lesson=name) as (app, pilot):
        await until(app, pilot, lambda: app.lessons.pane is not None and app.lessons.pane.course.state.step is not None)
        await until(app, pilot, _shows(app, "student@day6:~$"))
        yield app, pilot


@pytest.mark.process
async def test_what_is_typed_before_the_lesson_has_come_up_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked, may_come = threading.Event(), threading.Event()

    def late(folder: Path | None) -> LessonOffer:
        asked.set()
        assert may_come.wait(60)
        return offer(folder)

    monkeypatch.setattr("day6_core.lessons.course.offer", late)
    async with opened(tmp_path, 80, 24, lesson="day1") as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        _type(app, "clear; ls\r")
        runs = app.terminals.current.view.terminal.runs
        await until(app, pilot, lambda: asked.is_set() and runs.all and runs.all[-1].status == 0)
        assert app.lessons.pane is None
        may_come.set()
        await until(app, pilot, lambda: app.lessons.pane is not None and app.lessons.pane.course.state.solved)


@pytest.mark.process
async def test_f5_shows_the_next_step_and_the_keyboard_is_in_the_terminal(tmp_path: Path) -> None:
    async with lesson(tmp_path, "day2") as (app, pilot):
        course = app.lessons.pane.course
        _type(app, "ros2 run day6_kitchen kitchen &\r")
        await until(app, pilot, lambda: course.state.solved and len(app.desktop.panes) == 2)
        kitchen = app.desktop.panes[max(app.desktop.panes)]
        app.desktop.focus_pane(kitchen)
        app.desktop.toggle_enlarged()
        await until(app, pilot, lambda: "Done · F5" in screen_lines(app)[0])
        await pilot.press("f5")
        await until(app, pilot, _shows(app, "Step 2 of 12"))
        # The page may be that of a step which the desktop follows at the next frame only.
        await until(app, pilot, lambda: app.desktop.is_shown(kitchen) and "Done · F5" not in screen_text(app))
        assert app.desktop.focused_pane is app.terminals.current
        await pilot.press("f5")  # once too often: into the lesson
        for key in ("r", "o", "s", "2", "space", "n", "o", "d", "e", "space", "l", "i", "s", "t", "enter"):
            await pilot.press(key)
        await until(
            app, pilot, lambda: any(run.source.strip() == "ros2 node list" for run in course.opened.live.runs(0))
        )


@pytest.mark.process
async def test_f5_before_the_desktop_has_followed_the_step_goes_to_the_lesson_and_stays(tmp_path: Path) -> None:
    async with lesson(tmp_path, "day2") as (app, pilot):
        pane = app.lessons.pane
        _type(app, "ros2 run day6_kitchen kitchen &\r")
        await until(app, pilot, lambda: pane.course.state.solved and len(app.desktop.panes) == 2)
        app.lessons.toggle()
        waiting.until(lambda: pane.course.state.index == 1)  # no frame is drawn meanwhile
        app.lessons.toggle()
        for _ in range(3):
            await step(app, pilot)
        assert app.desktop.focused_pane is pane


@pytest.mark.process
async def test_the_keyboard_is_in_the_terminal_when_an_editor_was_closed(tmp_path: Path) -> None:
    async with lesson(tmp_path, "day3") as (app, pilot):
        terminal = app.terminals.current
        _type(app, "nano star.py\r")
        await until(app, pilot, lambda: app.desktop.focused_pane is not terminal)
        editor = app.desktop.focused_pane
        await pilot.press("f5")
        assert app.desktop.focused_pane is app.lessons.pane
        await pilot.press("f5")
        assert app.desktop.focused_pane is editor and app.desktop.is_shown(app.lessons.pane)
        await pilot.press("ctrl+x")
        await until(app, pilot, lambda: not app.desktop.holds(editor))
        await until(app, pilot, lambda: app.desktop.focused_pane is terminal)


@pytest.mark.process
async def test_a_drill_that_was_left_is_the_one_that_enter_opens_again(tmp_path: Path) -> None:
    name = drills()[2].name
    async with lesson(tmp_path, name) as (app, pilot):
        pane = app.lessons.pane
        await until(app, pilot, lambda: pane.course.opened.injected)
        await pilot.press("f5", "L")
        await until(app, pilot, lambda: pane.course.state.lesson is None and pane._entries)
        assert pane._entries[pane.chosen].name == name
