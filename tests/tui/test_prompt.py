"""The line to type: editing, complaints, and no hang however narrow it is."""

from __future__ import annotations

from pathlib import Path

from fakes import FakeDesk
from screens import UTF8, opened, screen_text, step

from day6_tui.tui.app import make_look
from day6_tui.tui.options import Options
from day6_tui.tui.prompt import Prompt, before_replacing


def test_a_prompt_without_any_room_shows_what_it_can() -> None:
    prompt = Prompt(make_look(Options(), UTF8), "Save", "rosgraph.dot", lambda text: None)
    for width in range(-2, 20):
        before, at, after = prompt._window(width)
        assert len(before + at + after) <= max(1, width)
    assert prompt._window(40) == ("rosgraph.dot", " ", "")


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
