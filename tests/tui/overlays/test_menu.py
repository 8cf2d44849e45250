"""What a menu offers for what was typed, and in which order."""

from __future__ import annotations

import pytest
from textual import events

from day6_tui.app import Day6App
from day6_tui.options import Options
from day6_tui.overlays.menu import Menu, MenuEntry, ranked
from tests.tui.screens import UTF8, make_look, opened, running, screen_text, step

ENTRIES = (
    MenuEntry("Quit", "^Q", lambda: None, also=("退出", "Quit"), words="Ends day6-tui and closes everything"),
    MenuEntry("Enclose in a frame", "", lambda: None),
    MenuEntry("Do close window", "^W", lambda: None, words="x"),
    MenuEntry("Close window", "^W", lambda: None, also=("关闭窗口",), words="Ends its program"),
    MenuEntry("Other", "close", lambda: None),
    MenuEntry("Clear the old screen", "", lambda: None),
    MenuEntry("LaserScan", "", lambda: None),
    MenuEntry("/scan", "by topic", lambda: None),
    MenuEntry("RobotModel", "", lambda: None),
    MenuEntry("Odometry", "shows where a robot was", lambda: None),
)


@pytest.mark.parametrize(
    ("typed", "names"),
    [
        ("", [entry.name for entry in ENTRIES]),
        (
            "close",
            ["Close window", "Do close window", "Enclose in a frame", "Other", "Quit", "Clear the old screen"],
        ),
        ("CLOSE w", ["Close window", "Do close window"]),
        ("window close", ["Do close window", "Close window"]),
        ("关", ["Close window"]),
        ("robot", ["RobotModel", "Odometry"]),
        ("scan", ["/scan", "LaserScan"]),
        ("rbtmdl", ["RobotModel"]),
        ("nothing", []),
    ],
)
def test_the_likeliest_comes_first(typed: str, names: list[str]) -> None:
    assert [entry.name for entry in ranked(ENTRIES, typed)] == names


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize(
    ("typed", "action"), [("close", "close"), ("关闭", "close"), ("quit", "quit"), ("退出", "quit")]
)
async def test_the_palette_never_takes_a_word_of_an_explanation_for_a_name(
    desk, lang: str, typed: str, action: str
) -> None:
    options = Options(fps=0, lang=lang)
    app = Day6App(options, desk=desk, look=make_look(options, UTF8))
    async with running(app, 100, 30) as pilot:
        app.actions["palette"]()
        menu = app.desktop.overlay
        assert isinstance(menu, Menu)
        for key in typed:
            app.post_message(events.Key(key, key))
        await step(app, pilot)
        assert menu.matches()[0].name == app.look.texts(f"action.{action}")


@pytest.mark.parametrize(
    ("typed", "action"),
    [
        ("主题", "theme"),
        ("外观", "theme"),
        ("颜色", "theme"),
        ("换颜色", "theme"),
        ("夜间模式", "theme"),
        ("appearance", "theme"),
        ("colour", "theme"),
        ("语言", "language"),
        ("英文", "language"),
        ("字体", "letters"),
        ("字体大小", "letters"),
        ("font", "letters"),
        ("大小", "enlarge"),
        ("全屏", "enlarge"),
        ("搜索", "find"),
        ("速度", "faster"),
        ("快捷键", "help"),
        ("报错", "inspector"),
        ("录屏", "record"),
        ("清屏", "clear"),
        ("关机", "quit"),
        ("exit", "quit"),
        ("教程", "lessons"),
        ("版本", "distro"),
        ("动画", "motion"),
    ],
)
async def test_the_palette_finds_what_people_call_otherwise(desk, typed: str, action: str) -> None:
    async with opened(desk, 100, 30, lang="zh") as (app, pilot):
        app.actions["palette"]()
        menu = app.desktop.overlay
        assert isinstance(menu, Menu)
        for key in typed:
            app.post_message(events.Key(key, key))
        await step(app, pilot)
        assert menu.matches()[0].name == app.look.texts(f"action.{action}")


async def test_the_palette_says_how_to_change_the_size_of_letters(desk) -> None:
    async with opened(desk, 80, 24, lang="zh") as (app, _):
        app.actions["letters"]()
        assert app.notices.text == app.look.texts("help.action.letters")


async def test_what_is_not_found_is_told_as_a_search_that_may_go_on(desk) -> None:
    async with opened(desk, 80, 24, lang="zh") as (app, pilot):
        await pilot.press("f7", "q", "w", "x", "z")
        await step(app, pilot)
        assert "没找到，换个词试试" in screen_text(app)


def test_a_name_made_to_be_searched_for_ever_is_not() -> None:
    assert ranked([MenuEntry("/" + "ab" * 120, "", lambda: None)], "a" * 30) == []
