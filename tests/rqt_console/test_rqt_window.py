"""rqt's window on a stepped desktop: a list that is chosen from by keys, numbers and the mouse."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "tui"))

from screens import ToolWindow, step, use_window

from day6_tui.core.ros.programs.rqt_gui.model import Menu


def play(*keys: str, click: str = "", **options: str) -> tuple[str, str]:
    """What is chosen after these keys, or after a click on a text, and the screen before."""
    menu = Menu(lambda: None)
    seen: list[str] = []

    async def act(window: ToolWindow) -> None:
        seen.append(window.text)
        if click:
            lines = window.text.split("\n")
            y = next(y for y, line in enumerate(lines) if click in line)
            await window.pilot.click(offset=(lines[y].index(click), y))
            await step(window.app, window.pilot)
        await window.press(*keys)

    use_window(("rqt", "rqt", menu), act, (80, 24), ToolWindow, **options)
    return (menu.chosen.package if menu.chosen is not None else ""), seen[0]


@pytest.mark.parametrize(
    ("keys", "package"),
    [(["enter"], "rqt_graph"), (["down", "enter"], "rqt_console"), (["end", "enter"], "rqt_plot"), (["3"], "rqt_topic"),
     (["up", "enter"], "rqt_plot"), (["9"], ""), (["0"], "")],
)  # fmt: skip
def test_keys_choose_a_window(keys: list[str], package: str) -> None:
    assert play(*keys)[0] == package


@pytest.mark.parametrize(("text", "package"), [("Topic Monitor", "rqt_topic"), ("Which window?", "")])
def test_a_click_opens_the_window_it_is_on(text: str, package: str) -> None:
    assert play(click=text)[0] == package


@pytest.mark.parametrize(("lang", "text"), [("en", "Which window?"), ("zh", "打开哪个窗口？")])
def test_every_window_is_offered_with_its_command(lang: str, text: str) -> None:
    screen = play(lang=lang)[1]
    assert text in screen
    for plugin in Menu(lambda: None).plugins:
        assert plugin.title in screen and plugin.package in screen
