"""What a teacher says, asks and hands over, on a pupil's desktop."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from day6_core.classroom.note import LONGEST_REPLY, Reply
from day6_core.classroom.order import Order
from day6_core.classroom.order import encode as order
from day6_tui.app import Day6App
from day6_tui.classes.modals import Asked
from day6_tui.classes.sayings import MOST_WAITING
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_lines, screen_text, step

QUESTION = Order("say", text="Is the turtle \x1b[31mturning?", number=7)


async def hear(app: Day6App, pilot: Any, *heard: Order) -> None:
    app.classroom.observe("keeper", 1)
    app.classroom.hear(order(Order("attend", on=True)))
    for each in heard:
        app.classroom.hear(order(each))
    await step(app, pilot)


async def press(app: Day6App, pilot: Any, *keys: str) -> None:
    await pilot.press(*keys)
    await step(app, pilot)


@pytest.mark.parametrize(
    ("keys", "reply"),
    [
        (("f10", "y"), Reply(7, "yes")),
        (("f10", "n"), Reply(7, "no")),
        (("f10", "d"), Reply(7, "done")),
        (("f10", "escape", "f10", "tab", "enter"), Reply(7, "yes")),
        (("f10", "w", *"not yet", "enter"), Reply(7, "words", "not yet")),
    ],
)
@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_question_is_answered_by_one_key_after_f10(
    desk: FakeDesk, keys: tuple[str, ...], reply: Reply, lang: str
) -> None:
    async with opened(desk, 80, 24, lang=lang, scene="empty") as (app, pilot):
        await hear(app, pilot, QUESTION)
        assert "F10" in screen_lines(app)[0]
        await press(app, pilot, *(key.replace(" ", "space") for key in keys))
        assert app.classroom.sayings.replies == (reply,)
        assert app.classroom._note().replies == (reply,)
        assert "F10" not in screen_lines(app)[0] and len(app.screen_stack) == 1


async def test_no_key_of_a_terminal_is_an_answer_and_f10_is_the_terminals_when_nothing_waits(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        await hear(app, pilot, QUESTION)
        await press(app, pilot, "y", "enter", "n")
        assert desk.terminals[0].sent == "y\rn" and app.classroom.sayings.replies == ()
        await press(app, pilot, "f10", "y", "f10")
        assert desk.terminals[0].sent == "y\rn\x1b[21~" and len(app.classroom.sayings.replies) == 1


async def test_a_click_in_the_top_line_opens_the_question_and_a_click_answers(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await hear(app, pilot, QUESTION)
        await pilot.click(offset=(screen_lines(app)[0].index("F10"), 0))
        await step(app, pilot)
        assert isinstance(app.screen, Asked) and "turning?" in screen_text(app) and "\x1b" not in screen_text(app)
        line = next(at for at, text in enumerate(screen_lines(app)) if "D Done" in text)
        await pilot.click(offset=(screen_lines(app)[line].index("D Done"), line))
        await step(app, pilot)
        assert app.classroom.sayings.replies == (Reply(7, "done"),)


async def test_words_are_few_and_a_question_that_is_over_takes_none(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await hear(app, pilot, QUESTION)
        await press(app, pilot, "f10", "w", "enter")
        assert "nothing to send" in screen_text(app)
        await press(app, pilot, *"x" * (LONGEST_REPLY + 1), "enter")
        assert "too long" in screen_text(app)
        await press(app, pilot, "backspace")
        await hear(app, pilot, Order("settle", number=7))
        await press(app, pilot, "enter")
        assert "no longer waits" in screen_text(app) and app.classroom.sayings.replies == ()


async def test_many_questions_wait_one_after_the_other_and_not_for_ever(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await hear(app, pilot, *(Order("say", text=f"no {number}", number=number) for number in range(1, 20)))
        assert len(app.classroom.sayings.waiting) == MOST_WAITING
        await press(app, pilot, "f10", "y", "f10", "n")
        assert app.classroom.sayings.replies == (Reply(19, "yes"), Reply(18, "no"))
        await hear(app, pilot, Order("say", text="again", number=18))
        assert len(app.classroom.sayings.waiting) == MOST_WAITING - 1


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_file_is_opened_by_two_keys(desk: FakeDesk, tmp_path: Path, lang: str) -> None:
    desk.home = tmp_path
    (tmp_path / "handed").mkdir()
    (tmp_path / "handed" / "map.py").write_text("print()\n")
    (tmp_path / "handed" / "map.png").write_bytes(b"\x89PNG\xff")
    started: list[str] = []
    async with opened(desk, 80, 24, lang=lang, scene="empty") as (app, pilot):
        app.machine.start = lambda name, main: started.append(main.args[0])  # type: ignore[method-assign,assignment]
        await hear(app, pilot, Order("file", text="handed/map.py"))
        assert "F10" in screen_lines(app)[0]
        await press(app, pilot, "f10")
        assert "handed/map.py" in screen_text(app)
        await press(app, pilot, "enter")
        assert started == ["handed/map.py"] and "F10" not in screen_lines(app)[0]
        await hear(app, pilot, Order("file", text="handed/map.png"), Order("file", text="handed/gone.py"))
        await press(app, pilot, "f10", "enter", "f10", "enter")
        assert started == ["handed/map.py"] and app.classroom.sayings.waiting == []
        assert app.classroom.sayings.numbers_opened == ()  # they had no numbers
        numbered = {3: "handed/map.py", 4: "handed/map.png", 5: "handed/gone.py"}
        await hear(app, pilot, *(Order("file", text=text, number=number) for number, text in numbered.items()))
        assert "answer" not in screen_lines(app)[0] and "回答" not in screen_lines(app)[0]
        await press(app, pilot, *["f10", "enter"] * 3)
        assert app.classroom.sayings.numbers_opened == (4, 3)  # what is gone was not opened
        app.classroom.sayings.open()  # nothing waits: everything that came is there
        await step(app, pilot)
        assert "handed/map.py" in screen_text(app)


@pytest.mark.parametrize("is_in_page", [True, False])
async def test_a_link_is_opened_by_the_page_and_elsewhere_shown_and_copied(
    desk: FakeDesk, monkeypatch: pytest.MonkeyPatch, is_in_page: bool
) -> None:
    written: list[str] = []
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        app.detachment.is_in_page = is_in_page
        monkeypatch.setattr(app._driver, "write", written.append)
        await hear(app, pilot, Order("link", text="https://docs.ros.org/a?b#c", number=7))
        assert app.classroom.sayings.numbers_opened == ()
        await press(app, pilot, "f10", "enter")
        assert app.classroom.sayings.numbers_opened == (7,)
        opens = "\x1b]7701;open;https://docs.ros.org/a?b#c\x07"
        assert (opens in written) is is_in_page
        assert ("https://docs.ros.org/a?b#c" in screen_text(app)) is not is_in_page
        assert (app.clipboard == "https://docs.ros.org/a?b#c") is not is_in_page


@pytest.mark.parametrize(
    ("do", "text"),
    [
        ("link", "javascript:alert(1)"),
        ("link", "https://"),
        ("link", "https://a@b.c/"),
        ("link", "https://a/\x1b]0;x\x07"),
        ("link", "https://a/ b"),
        ("file", "/etc/passwd"),
        ("file", "handed/../../x"),
        ("file", "handed/\x1b"),
    ],
)
async def test_what_is_no_link_and_no_file_is_not_heard(desk: FakeDesk, do: str, text: str) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await hear(app, pilot, Order(do, text=text))
        assert app.classroom.sayings.all == [] and "F10" not in screen_lines(app)[0]
