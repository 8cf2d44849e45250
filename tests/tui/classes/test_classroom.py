"""What a desktop tells a teacher of its screen, and that telling changes nothing on it."""

from __future__ import annotations

import math
from contextvars import Context

import numpy as np
from textual import events

from day6_core.classroom.order import Order
from day6_core.classroom.order import encode as order
from day6_tui.app import Day6App
from day6_tui.classes.modals import GRACE_SECONDS, Consent
from day6_tui.classes.pupil import strips_of
from day6_tui.pixels.ask import SIXEL, Ability
from day6_tui.pixels.halves import halved
from day6_tui.pixels.pictures import Pictures
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
