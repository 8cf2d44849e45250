"""The line to type: editing, complaints, and no hang however narrow it is."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual import events

from day6_tui.overlays.input_line import InputLine
from day6_tui.overlays.prompt import Prompt, before_replacing
from tests.e2e.hostile import SEQUENCES, foreign
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_text, step


@pytest.mark.parametrize("size", [(80, 24), (20, 6), (10, 3), (4, 2)])
async def test_a_prompt_shows_what_it_can_however_little_room_there_is(desk: FakeDesk, size: tuple[int, int]) -> None:
    async with opened(desk, *size) as (app, pilot):
        taken: list[str] = []
        app.desktop.open_overlay(Prompt(app.look, "Save", "rosgraph.dot", taken.append, note="a note"))
        await step(app, pilot)
        assert "rosgraph.dot" in screen_text(app) or size[0] < 80
        await pilot.press("x", "enter")
        assert taken == ["rosgraph.dotx"] and app.desktop.overlay is None


async def test_what_is_wrong_is_told_and_the_line_stays(desk: FakeDesk) -> None:
    async with opened(desk, 60, 20) as (app, pilot):
        taken: list[str] = []
        prompt = Prompt(app.look, "Line", "1", lambda text: taken.append(text) or (None if text == "12" else "1 to 20"))
        app.desktop.open_overlay(prompt)
        await pilot.press("home", "x", "enter")
        await step(app, pilot)
        assert "1 to 20" in screen_text(app) and app.desktop.overlay is prompt
        await pilot.press("delete", "backspace", "1", "2", "enter")
        await step(app, pilot)
        assert taken == ["x1", "12"] and app.desktop.overlay is None


async def test_a_file_that_is_there_is_replaced_only_after_a_second_enter(desk: FakeDesk, tmp_path: Path) -> None:
    (tmp_path / "there.svg").write_text("mine", encoding="utf-8")
    async with opened(desk, 60, 20) as (app, pilot):
        taken: list[str] = []
        checked = before_replacing(app.look, tmp_path.joinpath, lambda text: taken.append(text))
        app.desktop.open_overlay(Prompt(app.look, "Save", "there.svg", checked))
        await pilot.press("enter")
        await step(app, pilot)
        assert "there.svg already exists" in screen_text(app)
        assert taken == []
        await pilot.press("enter")
        await step(app, pilot)
        assert (taken, app.desktop.overlay) == (["there.svg"], None)
        app.desktop.open_overlay(Prompt(app.look, "Save", "new.svg", checked))
        await pilot.press("enter")
        await step(app, pilot)
        assert taken == ["there.svg", "new.svg"]


async def test_what_is_pasted_into_a_line_cannot_command_the_terminal(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24) as (app, pilot):
        taken: list[str] = []
        text = "".join(SEQUENCES[name] for name in ("print", "PM", "C1", "directions"))
        app.desktop.open_overlay(Prompt(app.look, "Line", "", taken.append))
        await step(app, pilot)
        app.desktop.overlay.query_one(InputLine).post_message(events.Paste(text))
        await step(app, pilot)
        shown = screen_text(app)
        assert "[5i" in shown and foreign(shown.replace("\n", "").encode(), desktop=True) == []
        await pilot.press("enter")
        assert taken == [" ".join(text.split())], "only the picture of it is changed"
