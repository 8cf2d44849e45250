"""In a drill the pupil searches for the fault himself: the inspector, hints and (in an exam) cards do not give it away."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from day6_tui.app import Day6App
from day6_tui.locale import Texts
from day6_tui.overlays.card import CardModal
from tests.tui.screens import screen_lines, screen_text
from tests.tui.test_real_desk import _shows, _type, opened, until

DRILL = """---
drill: slip
order: 1
minutes: 3
fault: 1
topic: packages
title: {zh: 练, en: Slip}
---

# slip

~~~yaml
before:
  - type: ros2 run turtlesm turtlesim_node
check:
  - file: ~/done.txt
solve:
  - type: touch done.txt
~~~
"""
TEXT = "\n## {language} Slip\n\nText.\n\n### do\n\nDo.\n\n### hints\n\n1. a\n2. b\n3. c\n"
FINDING = "there is no package turtlesm"
NOT_FOUND = "Package 'turtlesm' not found"


@asynccontextmanager
async def drill(tmp_path: Path, *, exam: bool = False, **options: Any) -> AsyncIterator[tuple[Day6App, Any]]:
    """The desktop with the drill before the pupil: its line has failed in a terminal."""
    folder = tmp_path / "lessons"
    folder.mkdir()
    text = DRILL + "".join(TEXT.format(language=language) for language in ("zh", "en"))
    (folder / "slip.md").write_text(text, encoding="utf-8")
    first = {} if exam else {"lesson": "slip"}
    async with opened(tmp_path / "home", lessons=folder, **first, **options) as (app, pilot):
        await until(app, pilot, lambda: app.lessons.pane is not None)
        course = app.lessons.pane.course
        if exam:
            course.offer = replace(course.offer, drills=(course.offer.named("slip"),))
            await until(app, pilot, _shows(app, app.look.texts("lesson.drills")))
            app.desktop.go_to_pane(app.lessons.pane)
            await pilot.press("X")
        await until(app, pilot, lambda: course.state.verdicts and not course.state.working)
        await until(app, pilot, lambda: failed(app) is not None)
        app.desktop.go_to_pane(failed(app))
        await until(app, pilot, _shows(app, NOT_FOUND))
        yield app, pilot


def failed(app: Day6App) -> Any:
    """The terminal pane in which the drill's line failed."""
    for pane in app.terminals.panes:
        if pane.has_terminal and any(NOT_FOUND in run.output for run in pane.view.terminal.runs.all):
            return pane if pane.view.terminal.idle else None
    return None


def inspector(app: Day6App) -> Any:
    windows = app.machine.desk.display.windows
    return next((window.model for window in windows if window.kind == "inspector"), None)


async def inspect(app: Day6App, pilot: Any) -> None:
    await pilot.press("f6")
    await until(app, pilot, lambda: inspector(app) is not None)


async def solve(app: Day6App, pilot: Any) -> None:
    (app.machine.desk.login_home / "done.txt").touch()
    await until(app, pilot, lambda: app.lessons.pane.course.state.solved)


SLIPS = ("rso2 topic list", "python3 -c 'count = 1; cuont'", "ros2 run my_pkg my_node")
"""Lines that fail, with a hint below."""


@pytest.mark.long
@pytest.mark.parametrize("exam", [False, True], ids=["drill", "exam"])
async def test_the_inspector_names_nothing_until_the_drill_is_solved(tmp_path: Path, exam: bool) -> None:
    async with drill(tmp_path, exam=exam) as (app, pilot):
        await inspect(app, pilot)
        await until(app, pilot, _shows(app, "find the bug yourself"))
        model = inspector(app)
        assert model.findings == () and "turtlesm" not in "".join(map(str, model.findings))
        assert "no fault found" not in screen_text(app) and FINDING not in screen_text(app)
        await solve(app, pilot)
        await until(app, pilot, lambda: FINDING in screen_text(app).replace("\n", " ") or model.findings)
        assert any(each.id == "inspector.no_package" for each in model.findings)
        await until(app, pilot, lambda: "find the bug yourself" not in screen_text(app))


@pytest.mark.long
@pytest.mark.parametrize("how", ["solution", "next", "list"])
async def test_it_works_again_once_the_drill_is_given_up(tmp_path: Path, how: str) -> None:
    async with drill(tmp_path) as (app, pilot):
        await inspect(app, pilot)
        await until(app, pilot, _shows(app, "find the bug yourself"))
        app.desktop.go_to_pane(app.lessons.pane)
        await pilot.press({"solution": "S", "next": "right", "list": "L"}[how])
        await until(app, pilot, lambda: "find the bug yourself" not in screen_text(app))
        if how != "solution":
            await until(app, pilot, lambda: app.lessons.pane.course.state.lesson is None)


async def test_an_inspector_that_was_open_before_falls_silent(tmp_path: Path) -> None:
    async with drill(tmp_path) as (app, pilot):
        app.desktop.go_to_pane(app.lessons.pane)
        await pilot.press("L")
        await until(app, pilot, lambda: app.lessons.pane.course.state.lesson is None)
        await inspect(app, pilot)
        await until(app, pilot, lambda: inspector(app).version)
        app.lessons.pane.course.request(lambda: app.lessons.pane.course.open("slip"))
        await until(app, pilot, _shows(app, "find the bug yourself"))


@pytest.mark.long
@pytest.mark.parametrize(("language", "exam"), [("zh", False), ("zh", True), ("en", True)])
@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_it_says_so_in_the_users_language(
    tmp_path: Path, language: str, exam: bool, size: tuple[int, int]
) -> None:
    async with drill(tmp_path, exam=exam) as (app, pilot):
        if language == "zh":
            app.looks.next_language()
        await pilot.resize_terminal(*size)
        await inspect(app, pilot)
        words = Texts(language)(f"inspector.quiet.{'exam' if exam else 'drill'}")
        start = words[:8] if language == "zh" else " ".join(words.split()[:3])
        await until(app, pilot, _shows(app, start))


@pytest.mark.process
async def test_a_terminal_from_before_the_drill_has_no_hints_either(tmp_path: Path) -> None:
    package = tmp_path / "home/ros2_ws/src/my_pkg/package.xml"
    package.parent.mkdir(parents=True)
    package.write_text("<package><name>my_pkg</name></package>")
    async with opened(tmp_path / "home") as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        terminal = app.terminals.current.view.terminal
        for count, (searching, line) in enumerate((kind, line) for kind in ("", "drill", "exam") for line in SLIPS):
            app.machine.desk.searching = lambda searching=searching: searching
            _type(app, f"{line}\r")
            await until(app, pilot, lambda count=count: terminal.runs.count == count + 1 and terminal.idle)
            said = terminal.runs.all[-1].output
            assert "rror" in said or "not found" in said
            assert ("hint:" in said) != bool(searching)


async def ask(app: Day6App, pilot: Any, how: str) -> None:
    """Ask for the card of the failed line, in one of the ways there are."""
    pane = failed(app)
    app.desktop.go_to_pane(pane)
    if how == "f1":
        await pilot.press("f1")
    elif how == "click":
        lines = screen_lines(app)
        y = next(y for y, line in enumerate(lines) if NOT_FOUND in line and "explain" not in line)
        await pilot.click(offset=(lines[y].index(NOT_FOUND) + 3, y))
    else:
        pane.view.terminal.send(f"{how}\r")


WAYS = ["f1", "click", "why", "explain \"Package 'turtlesm' not found\""]


@pytest.mark.long
@pytest.mark.parametrize("how", WAYS, ids=["f1", "click", "why", "explain"])
async def test_in_an_exam_there_are_no_cards_until_the_drill_is_solved(tmp_path: Path, how: str) -> None:
    async with drill(tmp_path, exam=True) as (app, pilot):
        await ask(app, pilot, how)
        await until(app, pilot, _shows(app, "There are no cards in an exam"))
        assert not isinstance(app.desktop.overlay, CardModal)
        assert "Why here" not in screen_text(app)
        await solve(app, pilot)
        app.desktop.close_overlay()
        await ask(app, pilot, how)
        await until(app, pilot, lambda: "Why here" in screen_text(app))


@pytest.mark.long
@pytest.mark.parametrize("how", WAYS, ids=["f1", "click", "why", "explain"])
async def test_in_a_drill_for_practice_cards_are_allowed(tmp_path: Path, how: str) -> None:
    async with drill(tmp_path) as (app, pilot):
        await ask(app, pilot, how)
        await until(app, pilot, lambda: "Why here" in screen_text(app))
        assert isinstance(app.desktop.overlay, CardModal) == (how in ("f1", "click"))
