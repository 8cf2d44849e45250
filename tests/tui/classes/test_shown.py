"""A screen that is shown to a class on a network: at the teacher who shows it, and at the pupils who see it."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from functools import partial
from typing import Any

import pytest

from day6_core.classroom import note as notes
from day6_core.classroom import shown
from day6_core.classroom.note import Note, PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.order import encode as order
from day6_core.classroom.show import OWN, Show
from day6_core.classroom.shown import SILENT_SECONDS, Shown
from day6_core.link.classroom.pupil import Pupil
from day6_tui.locale import Texts
from tests.tui.class_of_pupils import ClassDesk, ClassWindow, in_class, screen_of
from tests.tui.screens import opened, screen_lines, screen_text, step, step_until
from tests.tui.stepped_time import move_on

Class = Callable[..., AbstractAsyncContextManager[ClassWindow]]
TEXTS = Texts("en")
MINE, ANNA = Show(OWN, None, full=False), Show("anna", None, full=False)


@pytest.fixture
def class_of(monkeypatch: pytest.MonkeyPatch) -> Class:
    return partial(in_class, monkeypatch)


# -- the teacher -------------------------------------------------------------------------------------------------------


async def agree(window: ClassWindow, name: str, text: str = "anna's ") -> None:
    """As if this pupil were asked and said yes."""
    await window.say(name, asked_show=True)
    await window.say(name, asked_show=False, may_show=True)
    assert window.part.asked_of(name, "show")[-1].on
    await window.say(name, shown=True, screen=screen_of(text))


async def test_the_own_screen_goes_to_all_who_are_told_so_until_the_same_key(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("m")
        picture = window.part.pictures[-1]
        assert picture is not None and picture.show == MINE and "Class" in picture.screen.ansi
        assert "the class sees your screen: click to end" in window.text
        assert TEXTS("class.bar.shown") in screen_lines(window.app)[0]
        before = len(window.part.pictures)
        await window.say("anna", trouble=None, nodes=("/a_new_node",))

        def is_seen() -> bool:
            return any(each is not None and "a_new_node" in each.screen.ansi for each in window.part.pictures[before:])

        await step_until(window.app, window.pilot, is_seen)
        await window.press("m")
        assert window.part.pictures[-1] is None and "the class sees" not in window.text
        assert TEXTS("class.bar.shown") not in screen_lines(window.app)[0]
        assert [event.what for event in window.link.roster.journal.events()].count("showed") == 1


async def test_the_words_in_the_top_line_and_the_palette_end_it_too(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        assert "stop_showing" not in window.app.actions.hidden and "see_shown" in window.app.actions.hidden
        await window.press("M")
        assert window.part.pictures[-1] is not None and window.part.pictures[-1].show.full
        window.app.actions["stop_showing"]()
        await window.step()
        assert window.part.pictures[-1] is None and "the class sees" not in window.text


async def test_who_is_watched_is_not_shown_with_the_own_screen(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("enter")
        await window.say("anna", screen=screen_of("secret"))
        assert "secret" in window.text
        await window.press("m")
        await window.step()
        assert "secret" not in window.text and TEXTS("teacher.hidden") in window.text
        assert window.part.asked_of("anna", "watch", "unwatch")[-1].do == "unwatch"
        assert window.part.pictures
        assert not any(each is not None and "secret" in each.screen.ansi for each in window.part.pictures)
        await window.press("t")
        assert not window.part.asked_of("anna", "ask_to_type")
        await window.press("m")
        await window.step()
        assert window.part.asked_of("anna", "watch", "unwatch")[-1].do == "watch"
        window.pane.close()
        await window.step()
        window.link.broadcast.press(OWN, full=False)  # as by a key of the next window
        await window.step()
        assert window.part.pictures[-1] is not None


async def test_the_end_is_told_a_few_times_and_then_nothing(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("m", "m")
        await step_until(window.app, window.pilot, lambda: window.part.pictures[-3:] == [None] * 3)
        count = len(window.part.pictures)
        await window.pilot.pause(2.0)
        await window.step()
        assert len(window.part.pictures) == count


@pytest.mark.parametrize("how", ["key", "click", "left", "taken back", "mine"])
async def test_a_pupils_screen_is_shown_with_a_yes_and_ends(class_of: Class, how: str) -> None:
    async with class_of() as window:
        await window.come("anna", "ben")
        await window.press("r")
        assert TEXTS("teacher.to_show", name="anna") in window.text and not window.part.pictures
        await agree(window, "anna")
        picture = window.part.pictures[-1]
        assert picture is not None and picture.show == ANNA and "anna's 23" in picture.screen.ansi
        assert TEXTS("teacher.shown", name="anna") in window.text
        assert TEXTS("teacher.state.shown") in window.line_with("anna  ")
        if how == "key":
            await window.press("r")
        elif how == "click":
            window.pane._shown()[0].action()
            await window.step()
        elif how == "left":
            await window.leave("anna")
        elif how == "taken back":
            await window.say("anna", shown=False, may_show=False, screen=None)
        else:
            await window.press("m")
            assert window.part.pictures[-1] is not None and window.part.pictures[-1].show == MINE
        assert how == "mine" or window.part.pictures[-1] is None
        assert TEXTS("teacher.shown", name="anna") not in window.text
        assert how == "left" or window.part.asked_of("anna", "show")[-1] == Order("show")


async def test_larger_is_another_number_and_asks_nobody_again(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("r")
        await agree(window, "anna")
        first = window.part.pictures[-1]
        await window.press("R")
        second = window.part.pictures[-1]
        assert first is not None and second is not None and second.show == ANNA._replace(full=True)
        assert second.number != first.number and len(window.part.asked_of("anna", "ask_to_show")) == 1
        await window.press("R")
        assert window.part.pictures[-1] is None


async def test_a_no_is_told(class_of: Class) -> None:
    async with class_of(toasts=True) as window:
        await window.come("anna")
        await window.press("r")
        await window.say("anna", asked_show=True)
        await window.say("anna", asked_show=False, refused="class.refused.no")
        assert TEXTS("class.show.no", name="anna") in window.app.notices.text and not window.part.pictures


async def test_nothing_of_the_own_desktop_is_told_unless_it_is_shown(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        window.app.classroom.observe("keeper", 1)
        window.app.classroom.hear(order(Order("watch", seconds=60)))
        await window.step()
        assert not window.part.pictures


# -- a pupil -----------------------------------------------------------------------------------------------------------


class Pupils:
    """The desktop of the pupil ben."""

    def __init__(self, app: Any, pilot: Any, part: Pupil) -> None:
        self.app, self.pilot, self.part = app, pilot, part

    async def step(self) -> None:
        """What comes is heard, its window opened and then drawn."""
        for _ in range(2):
            await step(self.app, self.pilot)

    async def see(self, number: int = 1, show: Show = MINE, screen: PupilScreen | None = None) -> None:
        self.part.shown(shown.encode(Shown(number, show, screen or screen_of("picture"))))
        await self.step()

    async def end(self) -> None:
        self.part.shown(shown.encode(None))
        await self.step()

    @property
    def text(self) -> str:
        return screen_text(self.app)

    @property
    def pane(self) -> Any:
        return next((pane for pane in self.app.desktop.panes.values() if pane.window.kind == "shown"), None)

    @property
    def terminal(self) -> Any:
        return self.app.terminals.panes[0]


@asynccontextmanager
async def ben(columns: int = 120, rows: int = 40, **options: Any) -> AsyncIterator[Pupils]:
    part = Pupil("ben")
    given = {"lang": "en", "scene": "empty", "part": part, "connect": "tcp/192.0.2.7:7447", **options}
    async with opened(ClassDesk(), columns, rows, **given) as (app, pilot):
        pupil = Pupils(app, pilot, part)
        part.met(True)
        app.desktop.focus_pane(pupil.terminal)
        await pupil.step()
        yield pupil


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_it_is_seen_beside_the_work_which_keeps_the_keyboard(size: tuple[int, int]) -> None:
    async with ben(*size) as pupil:
        await pupil.pilot.press("l")
        await pupil.see()
        assert "The teacher's screen" in pupil.text and "picture" in pupil.text
        await pupil.pilot.press("s")
        assert pupil.app.desktop.focused_pane is pupil.terminal
        assert pupil.terminal.view.terminal.sent == "ls"
        await pupil.see(screen=screen_of("another"))
        assert "another" in pupil.text and "picture" not in pupil.text
        await pupil.end()
        assert pupil.pane is None and TEXTS("shown.over") in pupil.app.notices.text


async def test_what_is_not_for_this_pupil_is_not_seen_nor_the_own_screen() -> None:
    async with ben() as pupil:
        for number, show in enumerate((Show("ben", None, False), Show(OWN, frozenset({"anna"}), False))):
            await pupil.see(number, show)
            assert pupil.pane is None
        await pupil.see(3, ANNA)
        assert "anna's screen" in pupil.text
        await pupil.see(4, Show("ben", None, False))
        assert pupil.pane is None


async def test_full_takes_the_desktop_and_f8_gives_it_back_with_the_keyboard() -> None:
    async with ben() as pupil:
        await pupil.see(1, MINE._replace(full=True))
        assert pupil.app.desktop.enlarged and pupil.app.desktop.focused_pane is pupil.pane
        assert "student@day6" not in pupil.text
        await pupil.pilot.press("x", "enter", "down", "f8")
        await pupil.see(1, MINE._replace(full=True), screen_of("another"))  # which does not make it large again
        assert not pupil.app.desktop.enlarged and pupil.app.desktop.focused_pane is pupil.terminal
        assert pupil.terminal.view.terminal.sent == "" and "another" in pupil.text
        await pupil.see(2, MINE._replace(full=True))
        assert pupil.app.desktop.enlarged
        await pupil.see(3, MINE)
        assert not pupil.app.desktop.enlarged and pupil.app.desktop.focused_pane is pupil.terminal
        await pupil.see(4, MINE._replace(full=True))
        await pupil.end()
        assert pupil.pane is None and not pupil.app.desktop.enlarged
        assert pupil.app.desktop.focused_pane is pupil.terminal
        await pupil.pilot.press("f8", "f8")
        assert pupil.app.desktop.focused_pane is pupil.terminal


async def test_closed_it_stays_so_until_it_is_asked_for_or_shown_anew() -> None:
    async with ben() as pupil:
        await pupil.see()
        pupil.pane.close()
        await pupil.see(screen=screen_of("another"))
        assert pupil.pane is None and TEXTS("class.bar.see") in screen_lines(pupil.app)[0]
        pupil.app.actions["see_shown"]()
        await pupil.step()
        assert "another" in pupil.text and TEXTS("class.bar.see") not in screen_lines(pupil.app)[0]
        pupil.pane.close()
        await pupil.see(2)
        assert pupil.pane is not None
        pupil.pane.close()
        await pupil.end()
        assert TEXTS("class.bar.see") not in screen_lines(pupil.app)[0]
        pupil.app.actions["see_shown"]()
        await pupil.step()
        assert pupil.pane is None and TEXTS("shown.none") in pupil.app.notices.text


async def test_without_pictures_it_waits_and_without_a_teacher_it_ends() -> None:
    async with ben() as pupil:
        await pupil.see()
        assert TEXTS("shown.live") in pupil.text
        move_on(SILENT_SECONDS)
        await pupil.step()
        assert TEXTS("shown.waiting") in pupil.text and "picture" in pupil.text
        await pupil.see()
        assert TEXTS("shown.waiting") not in pupil.text
        pupil.part.met(False)
        await pupil.step()
        assert pupil.pane is None
        pupil.part.met(True)
        await pupil.see()
        assert pupil.pane is not None


async def test_what_ends_at_once_leaves_no_window() -> None:
    async with ben() as pupil:
        pupil.part.shown(shown.encode(Shown(1, MINE, screen_of("picture"))))
        await pupil.pilot.pause()
        pupil.part.shown(shown.encode(None))
        await pupil.pilot.pause()
        await pupil.step()
        assert pupil.pane is None and not pupil.app.machine.desk.display.windows


async def test_what_is_no_picture_changes_nothing() -> None:
    async with ben() as pupil:
        await pupil.see()
        pupil.part.shown(b"none")
        await pupil.step()
        assert "picture" in pupil.text


async def test_a_slow_desktop_looks_at_the_newest_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    async with ben() as pupil:
        read: list[bytes] = []
        decode = shown.decode
        monkeypatch.setattr(shown, "decode", lambda data: read.append(data) or decode(data))
        for number in range(50):
            pupil.part.shown(shown.encode(Shown(1, MINE, screen_of(f"number {number} "))))
        await pupil.step()
        assert len(read) == 1 and "number 49 " in pupil.text


async def test_the_part_in_which_its_owner_works_is_seen_until_somebody_scrolls() -> None:
    async with ben(80, 24) as pupil:
        large = screen_of("line", 200, 100)
        await pupil.see(screen=PupilScreen(200, 100, large.ansi, (0, 60, 40, 30, 88)))
        assert "line88" in pupil.text and "line0." not in pupil.text
        pupil.app.desktop.focus_pane(pupil.pane)
        await pupil.pilot.press("pageup", "pageup", "pageup", *["up"] * 100)
        await pupil.step()
        assert "line0." in pupil.text
        await pupil.see(screen=PupilScreen(200, 100, large.ansi, (0, 61, 40, 30, 90)))
        assert "line0." in pupil.text
        await pupil.pilot.press("home")
        await pupil.step()
        assert "line61" in pupil.text and "line90" not in pupil.text  # a window, in which no line counts


async def test_the_question_for_the_own_screen_is_over_a_large_one() -> None:
    async with ben() as pupil:
        told: list[Note] = []
        pupil.part.tell = lambda note: told.append(notes.decode(note))  # type: ignore[method-assign]
        pupil.part.ordered(order(Order("attend", on=True)))
        await pupil.see(1, MINE._replace(full=True))
        pupil.part.ordered(order(Order("ask_to_show")))
        await pupil.step()
        assert TEXTS("class.consent_show.title") in pupil.text and told[-1].asked_show
        await pupil.see(2, MINE._replace(full=True))
        assert TEXTS("class.consent_show.title") in pupil.text
        move_on(2.0)
        await pupil.pilot.press("y")
        await pupil.step()
        assert told[-1].may_show
        pupil.part.ordered(order(Order("show", on=True)))
        await pupil.step()
        assert told[-1].shown and told[-1].screen is not None
        pupil.part.met(False)  # a teacher who leaves shows nobody
        await pupil.step()
        pupil.part.met(True)
        await pupil.step()
        assert not told[-1].shown and told[-1].screen is None
