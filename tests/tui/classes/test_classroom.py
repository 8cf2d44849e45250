"""What a desktop tells a teacher of its screen, and that telling changes nothing on it."""

from __future__ import annotations

import math
import time
from contextvars import Context

import numpy as np
import pytest
from textual import events
from textual.pilot import Pilot
from textual.widgets._toast import Toast

from day6_core.classroom import note as notes
from day6_core.classroom.note import Note
from day6_core.classroom.order import Order
from day6_core.classroom.order import encode as order
from day6_tui.app import Day6App
from day6_tui.classes.modals import GRACE_SECONDS, Asked, Consent
from day6_tui.classes.observed import strips_of
from day6_tui.pixels.ask import SIXEL, Ability
from day6_tui.pixels.halves import halved
from day6_tui.pixels.pictures import Pictures
from day6_tui.terminals.pane import TerminalPane
from tests.tui.fakes import FakeDesk, FakeSimulation
from tests.tui.screens import opened, screen_lines, screen_text, step


def watch(app: Day6App) -> None:
    app.classroom.observe("keeper", 1)
    app.classroom.hear(order(Order("watch", seconds=60)))


async def test_being_watched_changes_nothing_of_what_is_seen_behind_a_box(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        behind = "Terminal"
        assert behind in screen_text(app)
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("freeze", on=True)))
        await step(app, pilot)
        assert behind in screen_text(app)
        app.screen.refresh()  # as after every change behind it
        Context().run(watch, app)  # as in a timer
        await step(app, pilot)
        assert behind in screen_text(app)


async def test_a_picture_of_real_pixels_is_told_as_half_blocks(desk: FakeDesk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        app.look.pictures = Pictures(app.look, {}, lambda text: None, changed=app._pictures_changed)
        app.look.pictures.wanted = True
        app.look.pictures.use(Ability(SIXEL, (8, 16)))
        for _ in range(3):
            await step(app, pilot)
        pane = app.desktop.panes[window.number]
        inside = slice(pane.region.x + 1, pane.region.right - 1), slice(pane.region.y + 1, pane.region.bottom - 1)
        blank = [line[inside[0]] for line in screen_lines(app)[inside[1]]]
        strips = strips_of(app)
        told = ["".join(segment.text for segment in strip)[inside[0]] for strip in strips[inside[1]]]
        assert sum(line.count("▀") for line in blank) == 0 < sum(line.count("▀") for line in told)
        assert [strip.cell_length for strip in strips] == [80] * 24
        colours = {
            segment.style.color for strip in strips for segment in strip if "▀" in segment.text and segment.style
        }
        assert len(colours) > 2  # the sea and the turtle


async def test_where_the_pupil_works_is_told(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        watch(app)
        await step(app, pilot)
        pane = app.desktop.focused_pane
        screen = app.classroom.observed.screen()
        assert pane is not None and screen is not None and screen.work is not None
        assert screen.work == (*pane.region, pane.region.y + 1 + pane.view.cursor[1])  # type: ignore[attr-defined]


def test_a_thin_line_is_still_there_in_half_blocks() -> None:
    pixels = np.full((32, 16, 3), (69, 86, 255), np.uint8)
    pixels[4] = (255, 255, 255)
    halves = halved(pixels, (8, 16))
    assert halves.shape == (4, 2, 3)
    assert halves[1].tolist() == halves[2].tolist() == halves[3].tolist() == [[69, 86, 255]] * 2
    assert (halves[0] > (100, 110, 254)).all()


def answer(app: Day6App, key: str, time: float) -> None:
    """A key that came at this time, whenever it is dealt with."""
    event = events.Key(key, key)
    event.time = time
    app.post_message(event)


def told_by(app: Day6App) -> list[Note]:
    """What this desktop tells from now on."""
    told: list[Note] = []
    app.classroom._tell = lambda data: told.append(notes.decode(data))
    return told


async def test_a_screen_is_shown_to_the_class_after_a_yes_and_until_its_pupil_takes_it_back(desk: FakeDesk) -> None:
    async with opened(desk, 120, 24, lang="en", scene="empty") as (app, pilot):
        told = told_by(app)

        def ordered(do: str, *, on: bool = False) -> Note:
            app.classroom.hear(order(Order(do, on=on)))
            return told[-1]

        app.classroom.observe("keeper", 1)
        ordered("attend", on=True)
        assert not ordered("show", on=True).shown  # nobody has said yes
        assert ordered("ask_to_show").asked_show
        assert isinstance(app.screen, Consent)
        ordered("show")  # the teacher does not want it any more
        await step(app, pilot)
        assert not isinstance(app.screen, Consent) and not told[-1].asked_show
        ordered("ask_to_show")
        await step(app, pilot)
        question = app.screen
        assert isinstance(question, Consent)
        question._since = -100.0  # it was read
        await pilot.press("escape")
        await step(app, pilot)
        app.classroom._tick()
        assert (told[-1].refused, told[-1].may_show) == ("class.refused.no", False)
        ordered("ask_to_show")
        await step(app, pilot)
        question = app.screen
        assert isinstance(question, Consent)
        question._since = -100.0  # it was read
        answer(app, "y", 0.0)
        await step(app, pilot)
        assert told[-1].may_show and told[-1].screen is None
        assert ordered("show", on=True).shown and told[-1].screen is not None
        await step(app, pilot)
        assert "your class sees this screen: click to end" in screen_text(app)
        app.classroom._tell_picture()
        assert told[-1].screen is not None and "your class sees" in told[-1].screen.ansi
        count = len(told)
        app.classroom._tell_picture()  # nothing was drawn since
        assert len(told) == count
        app.actions["stop_showing"]()
        assert (told[-1].shown, told[-1].may_show, told[-1].screen) == (False, False, None)
        assert not ordered("show", on=True).shown  # one yes is good for one time


async def test_the_teachers_own_desktop_is_asked_nothing_and_is_shown_no_longer_when_the_server_goes(
    desk: FakeDesk,
) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, _):
        told = told_by(app)
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("show", on=True)))
        assert told[-1].shown and told[-1].screen is not None
        app.classroom.observe("keeper", 0)
        app.classroom.observe("keeper", 1)
        assert not told[-1].shown


async def test_what_was_typed_when_the_question_for_consent_came_is_no_answer_however_late_it_is_read(
    desk: FakeDesk,
) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("attend", on=True)))
        app.classroom.hear(order(Order("ask_to_type")))
        while not isinstance(app.screen, Consent) or math.isinf(app.screen._since):
            await step(app, pilot)
        question, seen = app.screen, app.screen._since
        question._since = math.inf  # as if its first picture took a while
        answer(app, "y", seen + 100)
        await step(app, pilot)
        assert app.screen is question
        question._since = seen - 100  # as if that was long ago
        answer(app, "y", seen - 100 + GRACE_SECONDS / 2)
        answer(app, "y", seen - 100 + GRACE_SECONDS * 1.2)  # it was typed on
        await step(app, pilot)
        assert app.screen is question
        answer(app, "y", seen - 100 + GRACE_SECONDS * 2.4)
        await step(app, pilot)
        assert app.screen is not question and app.classroom._may_type


def boxes(app: Day6App) -> list[str]:
    """The notifications on the screen in front, as they are read."""
    return [str(toast.render()) for toast in app.screen.query(Toast)]


async def say(app: Day6App, pilot: Pilot[None], *texts: str, number: int = 0) -> None:
    for text in texts:
        app.classroom.hear(order(Order("say", text=text, number=number)))
    await step(app, pilot)
    await step(app, pilot)


@pytest.mark.parametrize("frozen", [False, True], ids=["free", "frozen"])
async def test_what_the_teacher_says_stays_until_it_was_clicked(
    desk: FakeDesk, monkeypatch: pytest.MonkeyPatch, frozen: bool
) -> None:
    async with opened(desk, 100, 30, lang="en", scene="empty", toasts=True) as (app, pilot):
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("attend", on=True)))
        await say(app, pilot, "Save your file.")
        if frozen:
            app.classroom.hear(order(Order("freeze", on=True)))
            await step(app, pilot)
        after_a_day = time.time() + 24 * 3600
        monkeypatch.setattr("textual.notifications.time", lambda: after_a_day)
        app.notify("something else", timeout=48 * 3600.0)
        await step(app, pilot)
        assert sum("Save your file." in box for box in boxes(app)) == 1 and len(boxes(app)) == 2
        assert "teacher: 1" in screen_text(app)
        toast = next(toast for toast in app.screen.query(Toast) if "Save" in str(toast.render()))
        await pilot.click(toast)
        for _ in range(3):
            await step(app, pilot)
        shown = screen_text(app)
        assert "Save your file." not in shown and "teacher: 1" not in shown
        assert not any("Save" in str(toast.render()) for screen in app.screen_stack for toast in screen.query(Toast))
        assert boxes(app) == ["something else"]


async def test_several_sayings_are_in_one_box_and_looking_them_up_takes_away_no_other(desk: FakeDesk) -> None:
    async with opened(desk, 100, 30, lang="en", scene="empty", toasts=True) as (app, pilot):
        app.classroom.observe("keeper", 1)
        app.notify("something else", timeout=600.0)
        await say(app, pilot, *(f"number {count}" for count in range(1, 6)))
        (box,) = (box for box in boxes(app) if "number" in box)
        assert "… 2\nnumber 3\nnumber 4\nnumber 5\n" in box and "F7: Messages from the teacher" in box.replace(
            "\n", " "
        )
        assert len(boxes(app)) == 2
        app.actions["sayings"]()
        await step(app, pilot)
        assert "number 1" in screen_text(app)
        app.desktop.overlay.close()
        for _ in range(3):
            await step(app, pilot)
        assert boxes(app) == ["something else"] and "teacher: " not in screen_text(app)
        await say(app, pilot, "number 6")
        assert [box for box in boxes(app) if "number 6" in box and "number 5" not in box]


@pytest.mark.parametrize("width", range(60, 72))
async def test_a_box_for_which_there_is_room_is_whole_at_any_width(desk: FakeDesk, width: int) -> None:
    text = "look at the line that begins with Traceback, read the last line of it and tell me what it says, then look again"
    async with opened(desk, width, 43, lang="en", toasts=True) as (app, pilot):  # a phone beside a screen that is shown
        app.classroom.observe("keeper", 1)
        for number in (1, 2, 3):
            await say(app, pilot, f"<{number}> {text} once more at the line before it (</{number}>).", number=number)
        await step(app, pilot)
        assert "F10 answers." in screen_text(app) and "</3>" in screen_text(app)
        (toast,) = app.screen.query(Toast)
        assert toast.region.bottom < 43


LONG = {
    "en": "Look at the line that begins with Traceback, read the last line of it and tell me what it says " * 4,
    "zh": "先看以 Traceback 开头的那一行，再读最后一行，然后告诉我它说了什么。" * 6,
}
HOW = {"en": "F10 answers.", "zh": "按 F10 回答。"}


@pytest.mark.parametrize("lang", LONG)
@pytest.mark.parametrize(("width", "height"), [(80, 24), (48, 14), (40, 11), (30, 9)])
async def test_what_says_how_to_answer_is_seen_however_long_the_question_is(
    desk: FakeDesk, lang: str, width: int, height: int
) -> None:
    async with opened(desk, 100, 40, lang=lang, scene="empty", toasts=True) as (app, pilot):
        app.classroom.observe("keeper", 1)
        for number in (1, 2, 3):
            await say(app, pilot, f"<{number}> {LONG[lang]} </{number}>", number=number)
        await pilot.resize_terminal(width, height)
        for _ in range(3):
            await step(app, pilot)
        lines = screen_lines(app)
        assert any(HOW[lang] in line for line in lines), "\n".join(lines)
        assert "<3>" in screen_text(app) and "</3>" in screen_text(app)
        (toast,) = app.screen.query(Toast)
        assert app.screen.region.contains_region(toast.region)
        await pilot.resize_terminal(100, 40)
        for _ in range(3):
            await step(app, pilot)
        assert "</1>" in screen_text(app) and HOW[lang] in screen_text(app)


async def teach(app: Day6App, pilot: Pilot[None], keys: str) -> None:
    """Keys of a teacher who may type."""
    app.classroom._may_type = True
    app.classroom.hear(order(Order("type", text=keys)))
    for _ in range(3):
        await step(app, pilot)


async def test_a_teacher_types_where_the_pupils_own_keys_would_go(desk: FakeDesk) -> None:
    async with opened(desk, 100, 30, lang="en") as (app, pilot):
        told, typed_at = told_by(app), app.classroom.typed_at
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("attend", on=True)))
        app.classroom.hear(order(Order("type", text="\x1b[B")))
        await step(app, pilot)
        assert (told[-1].refused, app.welcome.chosen) == ("class.refused.type", 0)
        await teach(app, pilot, "\x1b[B")
        assert (told[-1].refused, app.welcome.chosen) == ("", 1)
        await teach(app, pilot, "\x1bOA")
        assert app.welcome.chosen == 0
        await teach(app, pilot, "ros2 n")
        app.classroom.hear(order(Order("type", text="od")))
        app.classroom.hear(order(Order("type", text="e\x7f")))
        for _ in range(3):
            await step(app, pilot)
        pane = app.desktop.focused_pane
        assert isinstance(pane, TerminalPane) and told[-1].refused == ""
        assert pane.view.terminal.sent == "ros2 node\x7f"  # type: ignore[attr-defined]
        assert app.classroom.typed_at == typed_at and not app.classroom.keys.are_coming


@pytest.mark.parametrize("key", ["\x11", "\x1b[21~", "\x1b[18~", "\x1b[<0;3;3M", "\x1b[200~ls\x1b[201~"], ids=repr)
async def test_no_key_of_a_teacher_is_one_of_the_desktop(desk: FakeDesk, key: str) -> None:
    async with opened(desk, 100, 30, lang="en") as (app, pilot):
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("say", text="Well?", number=7)))
        await teach(app, pilot, "\x1b[B")
        before = screen_text(app)
        await teach(app, pilot, key)
        assert app.desktop.overlay is None and app.is_running and app.leaving.running() == []
        assert screen_text(app) == before


async def test_a_teacher_answers_no_question_to_the_pupil_even_if_it_came_after_the_key(desk: FakeDesk) -> None:
    async with opened(desk, 100, 30, lang="en") as (app, pilot):
        told = told_by(app)
        app.classroom.observe("keeper", 1)
        app.classroom.hear(order(Order("attend", on=True)))
        app.classroom.hear(order(Order("say", text="Well?", number=7)))
        await step(app, pilot)
        app.classroom._may_type = True
        app.classroom.hear(order(Order("type", text="\x1b[B\ry")))
        app.actions["answer"]()  # by the pupil, before the keys are dealt with
        await step(app, pilot)
        await teach(app, pilot, "y")
        assert isinstance(app.screen, Asked) and not app.classroom.sayings.replies
        assert told[-1].refused == "class.refused.place" and app.welcome.chosen == 0
        app.screen.close()
        await step(app, pilot)
        app.classroom.hear(order(Order("freeze", on=True)))
        await teach(app, pilot, "\x1b[B")
        assert app.welcome.chosen == 0
