"""rqt's window on a stepped desktop: plugins are opened and closed, perspectives chosen, by keys and by the mouse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.programs.rqt_gui.catalogue import plugins
from day6_core.ros.programs.rqt_gui.model import Open, Rqt
from day6_tui.locale import catalogue
from tests.tui.screens import ToolWindow, step, use_window


def play(*keys: str, click: str = "", size: tuple[int, int] = (80, 24), **options: Any) -> tuple[list[Any], str]:
    """What is asked for after these keys, or after a click on a text, and the last screen. Plot is open."""
    model = Rqt(plugins(), Path("/nowhere").joinpath, lambda: None)
    model.open = (Open(plot(), 1),)
    model.perspective, model.perspectives = "Default", ("Default", "talk")
    model.trouble = options.pop("trouble", "")
    seen: list[str] = []

    async def act(window: ToolWindow) -> None:
        if click:
            lines = window.text.split("\n")
            y = next(y for y, line in enumerate(lines) if click in line)
            await window.pilot.click(offset=(lines[y].index(click), y))
            await step(window.app, window.pilot)
        await window.press(*keys)
        seen.append(window.text)

    use_window(("rqt", "rqt", model), act, size, ToolWindow, **options)
    return model.requests, seen[0]


def plot() -> Any:
    return next(entry for entry in plugins() if entry.package == "rqt_plot")


def test_enter_opens_a_plugin_and_x_closes_one_that_is_open() -> None:
    assert play("enter")[0] == [("start", plugins()[0])]
    at = plugins().index(plot())
    down = ["down"] * at
    assert play(*down, "enter")[0] == [("start", plot())]
    assert play(*down, "x")[0] == []
    assert play(*down, "down", "x")[0] == [("stop", Open(plot(), 1))]
    assert play(*down, "down", "enter")[0] == [("start", plot())]


def test_a_click_opens_the_plugin_it_is_on() -> None:
    assert play(click="numbers over time")[0] == [("start", plot())]


def test_perspectives_are_switched_made_and_removed_in_a_menu() -> None:
    assert play("p", "down", "enter")[0] == [("switch", "talk")]
    assert play("p", *"New", "enter", *"third", "enter")[0] == [("keep_as", "third")]
    assert play("p", "down", "delete")[0] == [("remove", "talk")]
    assert play("p", *"Open a", "enter", "enter")[0] == [("load", Path("/nowhere/Default.perspective"))]
    assert play("p", *"Write", "enter", "enter")[0] == [("export", Path("/nowhere/Default.perspective"))]


@pytest.mark.parametrize(("name", "complaint"), [("talk", "This name is taken."), ("a/b", "Not a valid name.")])
def test_a_name_that_is_taken_or_that_no_file_can_have_is_refused(name: str, complaint: str) -> None:
    requests, screen = play("p", *"New", "enter", *name, "enter")
    assert requests == [] and complaint in screen


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("size", [(80, 24), (40, 24)])
def test_every_plugin_is_offered_in_one_line(lang: str, size: tuple[int, int]) -> None:
    screen = play(lang=lang, size=size)[1]
    lines = [line for line in screen.split("\n") if any(f" {entry.title} " in line for entry in plugins())]
    assert len(lines) >= len(plugins()) and ("Visualization" in screen) == (size[0] == 80)


@pytest.mark.long
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("size", [(67, 24), (80, 24), (120, 40)])
def test_what_a_plugin_is_for_is_told_in_full(lang: str, size: tuple[int, int]) -> None:
    screen = play(lang=lang, size=size)[1]
    for entry in plugins():
        about = catalogue(lang)[f"rqt.about.{entry.package}"]
        assert f"{about} " in screen or f"{about}┃" in screen
    assert catalogue(lang)["rqt.about.rqt_action"] in play(lang=lang, size=(40, 24))[1]


def test_the_list_of_perspectives_begins_at_the_present_one() -> None:
    model = Rqt(plugins(), Path("/nowhere").joinpath, lambda: None)
    model.perspective, model.perspectives = "talk", ("Default", "talk", "zoo")

    async def act(window: ToolWindow) -> None:
        await window.press("p", "down", "enter")

    use_window(("rqt", "rqt", model), act, (80, 24), ToolWindow)
    assert model.requests == [("switch", "zoo")]


def test_close_is_offered_on_a_plugin_that_is_open_only() -> None:
    wide = (140, 24)
    assert " close" not in play(size=wide)[1].split("\n")[-1]
    assert " close" in play(*["down"] * (plugins().index(plot()) + 1), size=wide)[1].split("\n")[-1]


def test_what_went_wrong_stands_on_the_frame() -> None:
    assert "mine.perspective: No such file" in play(trouble="mine.perspective: No such file")[1]
