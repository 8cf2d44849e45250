"""The inspector's window: its list for keys and the mouse, on a desktop whose frames the test draws."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, replace
from typing import Any

import pytest
from textual import events

from day6_core.ros.programs.day6_inspector.rules import Finding
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_lines, screen_text, step


@dataclass
class Model:
    """What the window reads of an Inspector."""

    findings: tuple[Finding, ...] = ()
    looked: tuple[tuple[str, int], ...] = ()
    unseen: tuple[tuple[str, str], ...] = ()
    quiet: str = ""
    version: int = 1

    def find(self, *findings: Finding) -> None:
        self.findings, self.version = findings, self.version + 1


def finding(identifier: str, level: str, **parameters: str) -> Finding:
    return Finding(level=level, id=f"inspector.{identifier}", parameters=tuple(parameters.items()))


SLIP = finding("near", "warning", published="/cmd_vle", subscribed="/cmd_vel")
UNHEARD = [finding("unheard", "info", topic=f"/news_{number:02d}", nodes="/talker") for number in range(30)]


def use(
    model: Model, act: Callable[[Any, Any], Awaitable[None]], size: tuple[int, int] = (60, 14), **more: Any
) -> None:
    async def run() -> None:
        desk = FakeDesk()
        window = desk.display.open("inspector", "Inspector", model)
        async with opened(desk, *size, scene="empty", **{"lang": "en", **more}) as (app, pilot):
            await step(app, pilot)
            app.desktop.focus_pane(app.desktop.panes[window.number])
            await pilot.press("f8")
            await step(app, pilot)
            await act(app, pilot)

    asyncio.run(run())


def marked(app: Any) -> str:
    """The line of the cursor."""
    strips = app.screen._compositor.render_strips()
    choice = app.look.colours.choice.bgcolor
    lines = [strip for strip in strips[2:-2] if any(part.style and part.style.bgcolor == choice for part in strip)]
    return "".join(part.text for strip in lines for part in strip)


def test_the_arrow_keys_a_click_and_the_wheel_go_through_the_list() -> None:
    async def act(app: Any, pilot: Any) -> None:
        assert "/cmd_vle" in screen_text(app) and "/news_29" not in screen_text(app)
        await pilot.press("down", "down")
        await step(app, pilot)
        assert "/news_01" in marked(app)
        await pilot.press("end")
        await step(app, pilot)
        assert "/news_29" in marked(app)
        row = next(y for y, line in enumerate(screen_lines(app)) if "/news_27" in line)
        await pilot.click(offset=(8, row))
        await step(app, pilot)
        assert "/news_27" in marked(app)
        for _ in range(40):
            await pilot._post_mouse_events([events.MouseScrollUp], "FindingList", (8, 3))
        await step(app, pilot)
        assert "/cmd_vle" in screen_text(app)

    use(Model((SLIP, *UNHEARD)), act)


def test_the_cursor_stays_with_its_finding_while_others_come_and_go() -> None:
    model = Model(tuple(UNHEARD))

    async def act(app: Any, pilot: Any) -> None:
        await pilot.press(*["down"] * 4)
        await step(app, pilot)
        model.find(SLIP, *UNHEARD[2:])
        await step(app, pilot)
        assert "/news_04" in marked(app) and "/cmd_vle" in screen_text(app)
        model.find(*UNHEARD[:3])
        await step(app, pilot)
        assert "/news_02" in marked(app)
        model.find()
        await step(app, pilot)
        assert "no fault found" in screen_text(app) and "/news" not in screen_text(app)
        model.find(SLIP)
        await step(app, pilot)
        assert "/cmd_vle" in marked(app) and "no fault found" not in screen_text(app)

    use(model, act)


@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("size", [(40, 10), (80, 24)])
def test_a_long_finding_is_wrapped_and_none_of_it_is_lost(size: tuple[int, int], language: str) -> None:
    names = {"published": "/" + "a_long_name_" * 3, "subscribed": "/" + "a_long_nane_" * 3}

    async def act(app: Any, pilot: Any) -> None:
        text = "".join(line.strip("┃ ") for line in screen_lines(app)[2:-2])
        assert all(name in text for name in names.values())

    use(Model((finding("near", "warning", **names),)), act, size, lang=language)


@pytest.mark.parametrize("glyphs", ["half", "ascii"])
def test_the_names_of_joints_are_text_and_nothing_else(glyphs: str) -> None:
    """They come from messages, so that anything may stand in them."""

    async def act(app: Any, pilot: Any) -> None:
        text = screen_text(app)
        assert "[b]^[[2J^G" in text and "\x1b" not in text

    use(
        Model((finding("unknown_joint", "error", topic="/joint_states", nodes="/a", joint="[b]\x1b[2J\x07"),)),
        act,
        glyphs=glyphs,
    )


SOURCE = replace(finding("not_built", "error", line="ros2 run a b", package="a", folder="/a"), next="colcon build")


@pytest.mark.parametrize("how", ["enter", "click"])
def test_enter_or_a_click_writes_the_next_command_into_a_terminal_and_does_not_run_it(how: str) -> None:
    async def act(app: Any, pilot: Any) -> None:
        await pilot.press("f8")
        await step(app, pilot)
        terminal = app.machine.desk.terminals[0]
        assert "$ colcon build" in screen_text(app)
        for _ in range(2):
            pane = next(pane for pane in app.desktop.panes.values() if getattr(pane, "label", "") == "Inspector")
            app.desktop.focus_pane(pane)
            await step(app, pilot)
            if how == "enter":
                await pilot.press("down", "up", "enter")
            else:
                row = next(y for y, line in enumerate(screen_lines(app)) if "$ colcon" in line)
                column = screen_lines(app)[row].index("$ colcon")
                await pilot.click(offset=(column + 3, row))
            await step(app, pilot)
        assert terminal.sent == "colcon build\x05\x15colcon build", "a second time it takes the place of the first"
        assert app.desktop.focused_pane.view.terminal is terminal

    use(Model((SOURCE,)), act, (100, 30))


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("size", [(40, 12), (80, 24)])
def test_it_says_what_it_looked_at_and_what_not_and_never_that_nothing_is_wrong(
    size: tuple[int, int], lang: str
) -> None:
    said = {
        "en": [
            "no fault found in what was looked at",
            "topics 4 · messages 12",
            "so not looked at: frames",
            "not looked at: the files",
            "/a, /b",
        ],
        "zh": [
            "看过的地方没有发现问题",
            "话题 4 · 消息 12",
            "所以没有看：坐标系",
            "没有看：工作空间里的文件",
            "/a, /b",
        ],
    }

    async def act(app: Any, pilot: Any) -> None:
        seen: dict[str, None] = {}
        for _ in range(6):
            seen |= dict.fromkeys(line.strip("┃▇▆▅▄▃▂▁ ") for line in screen_lines(app)[2:-2])
            await pilot.press("down")
            await step(app, pilot)
        text = " ".join(seen)
        for each in said[lang]:
            assert each.replace(" ", "") in text.replace(" ", ""), text
        assert "nothing is wrong" not in text and "一切正常" not in text

    # Keys reach what stands below the last finding, or below none.
    looked = (("topics", 4), ("messages", 12), ("frames", 0))
    use(Model(looked=looked, unseen=(("files", ""), ("programs", "/a, /b"))), act, size, lang=lang)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_command_in_a_sentence_is_drawn_as_code_and_not_between_backticks(lang: str) -> None:
    command = "ros2 run lamp blink **x**"
    about = finding("not_built", "error", line=command, package="lamp", folder="src/lamp")

    async def act(app: Any, pilot: Any) -> None:
        text = screen_text(app)
        assert "`" not in text and command in text, text
        parts = [part for strip in app.screen._compositor.render_strips() for part in strip]
        code = app.look.colours.publisher.color
        assert command in [part.text for part in parts if part.style and part.style.color == code]

    use(Model((SLIP, about)), act, (120, 30), lang=lang)  # the first one has the cursor


@pytest.mark.parametrize("quiet", ["drill", "exam"])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_what_it_says_while_it_is_quiet_has_no_backticks_either(quiet: str, lang: str) -> None:
    async def act(app: Any, pilot: Any) -> None:
        assert "ros2 topic info" in screen_text(app) and "`" not in screen_text(app)

    use(Model(quiet=quiet), act, (100, 30), lang=lang)
