"""The windows of tools: nothing of their controls is cut, and a click does what the key does."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.graph import Graph
from day6_core.language import LANGUAGES
from day6_core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from day6_tui.actions import ACTIONS
from day6_tui.locale import catalogue
from day6_tui.overlays.manual import KEY_WIDTH
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_lines, screen_text, step


def test_no_key_is_cut_on_a_help_page() -> None:
    keys = [action.label for action in ACTIONS]
    for language in LANGUAGES:
        texts = [text for key, text in catalogue(language).items() if key.startswith("help.")]
        keys += [line.partition("\t")[0] for text in texts for line in text.split("\n") if "\t" in line]
    assert [key for key in keys if cell_len(key) >= KEY_WIDTH] == []


def _place(app: Any, text: str) -> tuple[int, int]:
    """Column and row of a text on the screen."""
    for row, line in enumerate(screen_lines(app)):
        if text in line:
            return line.index(text), row
    raise AssertionError(f"{text!r} is not on the screen:\n{screen_text(app)}")


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (100, 30)])
@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_every_check_box_of_rqt_graph_can_be_read(desk: FakeDesk, tmp_path: Path, size: Any, lang: str) -> None:
    async with opened(desk, *size, lang=lang, scene="empty") as (app, pilot):
        desk.display.open("rqt_graph", "rqt_graph", RqtGraph(None, Graph(0), tmp_path.joinpath))  # type: ignore[arg-type]
        await step(app, pilot)
        await step(app, pilot)
        pane = next(iter(app.desktop.panes.values()))
        assert all(cell_len(key) < KEY_WIDTH for key, _ in (*pane.key_hints(), *pane.more_key_hints()))
        if size[1] == 24:  # half of it is too little for them
            assert "[x]" not in screen_text(app)
            app.desktop.focus_pane(pane)
            await pilot.press("f8")
            await step(app, pilot)
        for label in (
            " s  [x] Dead sinks",
            " l  [x] Leaf topics",
            " d  [x] Debug",
            " f  [ ] tf",
            " u  [x] Unreachable",
            " p  [x] Params",
        ):
            assert label in screen_text(app)
        if size[1] == 40:
            for label in (" n  2 Namespaces", " 1  [x] Actions", " 3  [x] Images", " h  [x] Highlight", " v  [x] Fit"):
                assert label in screen_text(app)


async def test_a_click_on_a_check_box_of_rqt_graph_is_its_key(desk: FakeDesk, tmp_path: Path) -> None:
    model = RqtGraph(None, Graph(0), tmp_path.joinpath)  # type: ignore[arg-type]
    desk.display.open("rqt_graph", "rqt_graph", model)
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        for expected in (False, True):
            await step(app, pilot)
            await step(app, pilot)
            x, y = _place(app, "Debug")
            await pilot.click(offset=(x, y))
            await step(app, pilot)
            assert model.options.hide_debug is expected
        assert "[x] Debug" in screen_text(app)


@pytest.mark.parametrize(("size", "told"), [((40, 10), False), ((80, 24), False), ((120, 40), True)])
async def test_in_a_low_window_the_cars_picture_comes_before_what_is_only_worth_knowing(
    desk: FakeDesk, size: Any, told: bool
) -> None:
    line = SimpleNamespace(level="info", id="car.stays", parameters=())
    snapshot = SimpleNamespace(plan=None, robot=None, status=[line], rate=None)
    window = desk.display.open("car", "car_view", SimpleNamespace(snapshot=lambda: snapshot))
    async with opened(desk, *size, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        app.desktop.focus_pane(app.desktop.panes[window.number])
        await step(app, pilot)
        await step(app, pilot)
        assert ("This only draws angles." in screen_text(app)) is told
        line.level, line.id, line.parameters = "error", "car.no_transform", (("link", "left"), ("frame", "base"))
        app.desktop.panes[window.number].restyle()
        await step(app, pilot)
        assert "no transform from left to base" in screen_text(app)


async def test_a_click_on_the_type_in_the_title_of_rqt_graph_changes_it_by_one(desk: FakeDesk, tmp_path: Path) -> None:
    model = RqtGraph(None, Graph(0), tmp_path.joinpath)  # type: ignore[arg-type]
    desk.display.open("rqt_graph", "rqt_graph", model)
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        seen = []
        for _ in range(4):
            await step(app, pilot)
            await step(app, pilot)
            seen.append(model.options.graph_type)
            await pilot.click(offset=_place(app, seen[-1].value))
        assert seen[0] == seen[3] and len(set(seen)) == 3
