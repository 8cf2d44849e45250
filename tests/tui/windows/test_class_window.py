"""The teacher's window of a class on a network, as a teacher meets it."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.classroom.handed import LARGEST
from day6_core.classroom.note import LessonPlace, Reply, Trouble
from day6_core.classroom.order import Order
from day6_core.link.state import DoorState
from day6_tui.classes import link
from day6_tui.locale import Texts
from day6_tui.windows.classroom.table import places_for
from tests.tui.class_of_pupils import OPEN, ClassWindow, in_class, screen_of
from tests.tui.screens import step_until

Class = Callable[..., AbstractAsyncContextManager[ClassWindow]]

END_TYPING = "ctrl+right_square_bracket"


@pytest.fixture
def class_of(monkeypatch: pytest.MonkeyPatch) -> Class:
    """Open a teacher's desktop of so many columns and rows."""
    return partial(in_class, monkeypatch)


# -- typing for a pupil ------------------------------------------------------------------------------------------------


async def type_for(window: ClassWindow, name: str) -> None:
    """As if this pupil were chosen, was asked and has agreed."""
    await window.press("t")
    await window.say(name, asked=True)
    await window.say(name, asked=False, may_type=True)


async def test_typing_begins_with_the_yes_of_the_pupil(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("t")
        assert "waiting for permission to type; it starts" in window.text
        await window.say("anna", asked=True)
        await window.say("anna", asked=False, may_type=True)
        assert "you type for anna" in window.text
        await window.press("l", "s", "enter", "f", "escape")
        assert window.part.typed_to("anna") == "ls\rf\x1b"
        assert not window.link.roster.is_frozen
        await window.press(END_TYPING)
        assert "you type for anna" not in window.text and window.part.asked_of("anna", "stop_typing")
        await window.press("f")
        assert window.link.roster.is_frozen


async def test_a_yes_begins_nothing_where_the_teacher_has_gone_on_to_something_else(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben")
        await window.press("t")
        await window.say("anna", asked=True)
        await window.press("escape", "down")
        await window.say("anna", asked=False, may_type=True)
        assert "you type for" not in window.text
        assert "you may type: t" in window.line_with("anna  ")
        await window.press("up", "t")
        assert "you type for anna" in window.text


async def test_a_yes_begins_nothing_while_the_teacher_writes_a_message(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("t")
        await window.say("anna", asked=True)
        await window.press("s", "w", "a")
        await window.say("anna", asked=False, may_type=True)
        await window.press("i", "t", "enter")
        assert [order.text for order in window.part.asked_of("anna", "say")] == ["wait"]
        assert "you type for" not in window.text and "you may type: t" in window.text


async def test_a_yes_begins_nothing_while_the_keyboard_is_in_a_terminal(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("t")
        await window.say("anna", asked=True)
        window.app.desktop.toggle_enlarged()
        window.app.desktop.focus_pane(window.app.terminals.panes[0])
        await window.step()
        await window.say("anna", asked=False, may_type=True)
        assert "permission to type" not in window.text and "you type for" not in window.text


@pytest.mark.parametrize("how", ["taken back", "taken back while keys were on their way", "gone"])
async def test_keys_do_nothing_after_typing_was_cut_short_until_the_teacher_has_seen_it(
    class_of: Class, how: str
) -> None:
    async with class_of() as window:
        await window.come("anna", "ben")
        await type_for(window, "anna")
        if how == "gone":
            await window.leave("anna")
            told = "anna has left"
        else:
            why = "class.refused.taken_back" if how == "taken back" else "class.refused.type"
            await window.say("anna", may_type=False, refused=why)
            told = "anna has withdrawn permission"
        assert told in window.text
        sent = len(window.part.sent)
        await window.press("f", "x", "S", "enter", "e")
        assert told in window.text and window.app.desktop.overlay is None and not window.link.roster.is_frozen
        assert {order.do for _, order in window.part.sent[sent:]} <= {"watch"}
        await window.press("escape")
        assert told not in window.text
        await window.press("f")
        assert window.link.roster.is_frozen


async def test_f_keys_stay_the_teachers_while_typing(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await type_for(window, "anna")
        await window.press("f1")
        assert window.app.desktop.overlay is not None
        await window.press("escape")
        await window.press("a")
        assert window.part.typed_to("anna") == "a"


async def test_what_came_of_the_question_is_told_and_goes_away_with_its_reason(class_of: Class) -> None:
    texts = Texts("en")
    async with class_of() as window:
        await window.come("anna")
        await window.press("t")
        await window.say("anna", asked=True)
        await window.say("anna", asked=False, refused="class.refused.no")
        assert texts("class.refused.no") in window.text and "permission to type" not in window.text
        await window.press("escape")
        assert texts("class.refused.no") in window.line_with("anna")
        await window.say("anna", refused="")
        assert texts("class.refused.no") not in window.text
        await window.press("t")
        await window.say("anna", refused="class.refused.busy")
        assert texts("class.refused.busy") in window.text
        await window.say("anna", refused="")
        assert texts("class.refused.busy") not in window.text and "permission to type" not in window.text


async def test_after_a_no_a_second_question_may_have_a_yes(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.say("anna", refused="class.refused.no")
        await window.press("t")
        await window.say("anna", asked=True, refused="")
        await window.say("anna", asked=False, may_type=True)
        assert "you type for anna" in window.text


async def test_keys_that_go_nowhere_are_told_while_typing(class_of: Class) -> None:
    text = Texts("en")("class.refused.place")
    async with class_of() as window:
        await window.come("anna")
        await type_for(window, "anna")
        await window.press("a")
        await window.say("anna", refused="class.refused.place")
        assert text in window.text and "you type for anna" in window.text
        await window.say("anna", refused="")
        assert text not in window.text


async def test_an_old_yes_is_none_after_the_end_of_typing(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await type_for(window, "anna")
        await window.press(END_TYPING, "t")
        assert "you type for anna" not in window.text
        assert len(window.part.asked_of("anna", "ask_to_type")) == 2


async def test_who_closes_the_window_types_no_longer(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await type_for(window, "anna")
        window.pane.close()
        await window.step()
        assert window.part.asked_of("anna", "stop_typing")


# -- watching ----------------------------------------------------------------------------------------------------------


def is_watched(window: ClassWindow, name: str) -> bool:
    orders = window.part.asked_of(name, "watch", "unwatch")
    return bool(orders) and orders[-1].do == "watch"


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (160, 60)])
async def test_nobody_is_watched_before_the_teacher_asks(class_of: Class, size: tuple[int, int]) -> None:
    async with class_of(*size) as window:
        await window.come("anna", "ben")
        await window.press("down", "up")
        window.pane._tick()
        await window.step()
        assert not is_watched(window, "anna") and "waiting for the screen" not in window.text
        await window.press("enter")
        assert is_watched(window, "anna") and not is_watched(window, "ben")
        await window.say("anna", screen=screen_of("line"))
        assert "line7" in window.text
        await window.press("n")
        assert is_watched(window, "ben") and not is_watched(window, "anna")
        await window.press("escape")
        assert not is_watched(window, "ben")


async def test_a_preview_is_switched_on_and_off(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben")
        await window.press("v")
        assert is_watched(window, "anna") and "waiting for the screen" in window.text
        await window.say("anna", screen=screen_of("line"))
        assert "line3" in window.text
        await window.press("down")
        assert is_watched(window, "ben") and not is_watched(window, "anna") and "line3" not in window.text
        await window.press("v")
        assert not is_watched(window, "ben") and "waiting for the screen" not in window.text


async def test_a_preview_without_room_says_so_and_watches_nobody(class_of: Class) -> None:
    async with class_of(80, 12) as window:
        await window.come(*(f"pupil{number}" for number in range(6)))
        await window.press("v")
        assert "no room for a preview" in window.text and not is_watched(window, "pupil0")


async def test_who_is_not_on_the_screen_is_not_watched_by_a_hidden_window(
    class_of: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("enter")
        assert is_watched(window, "anna")
        window.app.desktop.focus_pane(window.app.terminals.panes[0])
        window.app.desktop.toggle_enlarged()
        await window.step()
        monkeypatch.setattr("day6_tui.windows.classroom.classroom.HIDDEN_SECONDS", -1.0)
        window.pane._tick()
        assert not is_watched(window, "anna")


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_a_narrow_or_low_window_takes_the_whole_desktop_for_a_screen(
    class_of: Class, size: tuple[int, int]
) -> None:
    async with class_of(*size) as window:
        await window.come("anna")
        before = window.pane.size
        assert before != window.app.desktop.size
        await window.press("enter")
        assert window.pane.size == window.app.desktop.size
        await window.press("escape")
        assert window.pane.size == before


async def test_a_large_screen_is_scrolled_both_ways(class_of: Class) -> None:
    async with class_of(80, 24) as window:
        await window.come("anna")
        await window.press("enter")
        await window.say("anna", screen=screen_of("line", 120, 40))
        assert "line0." in window.text and "!" not in window.text and "↓→" in window.text
        await window.press(*["right"] * 9)
        assert "!" in window.text and "line0" not in window.text and "←↓" in window.text
        await window.press("end")
        assert "line39." in window.text and "↑→" in window.text
        await window.press("home", "pagedown", "pagedown")
        assert "line20." not in window.text and "line21." in window.text and "line39." in window.text
        await window.press("up")
        assert "line20." in window.text and "line39." not in window.text


async def test_two_screens_are_compared_from_their_beginning_and_scrolled_together(class_of: Class) -> None:
    async with class_of(100, 24) as window:
        await window.come("anna", "ben")
        await window.press("enter")
        await window.say("anna", screen=screen_of("a", 80, 24))
        await window.press("end")
        assert "a0." not in window.text
        await window.press("c")
        await window.say("ben", screen=screen_of("b", 80, 60))
        assert "a0." in window.text and "b0." in window.text
        await window.press(*["pagedown"] * 4)
        assert "b59." in window.text and "a23." in window.text


async def test_the_next_and_the_previous_pupil_are_a_key_away(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben", "carl", "dora")
        await window.leave("carl")
        await window.press("enter")
        seen = []
        for key in ("n", "n", "n", "p", "p", "p"):
            await window.press(key)
            seen.append(next(name for name in ("anna", "ben", "dora") if is_watched(window, name)))
        assert seen == ["ben", "dora", "dora", "ben", "anna", "anna"]


# -- the frozen class --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_frozen_class_is_seen_at_80_columns_and_released_by_a_new_window(class_of: Class, lang: str) -> None:
    texts = Texts(lang)
    async with class_of(80, 24, lang=lang) as window:
        await window.come("anna")
        await window.press("f")
        lines = window.text.split("\n")
        assert texts("teacher.head.frozen") in window.text  # the table
        assert any(texts("teacher.frozen") in line for line in lines[-3:])  # the edge
        assert f"f {texts('teacher.key.thaw')}" in lines[-1]
        await window.say("anna", frozen=True)
        await window.press("enter")
        assert texts("teacher.frozen") in window.text
        window.pane.close()
        await window.step()
        window.app.show_class()
        await window.step()
        await window.press("f")
        assert [order.on for order in window.part.asked_of("anna", "freeze")] == [True, False]
        assert texts("teacher.frozen") not in window.text


# -- how to join -------------------------------------------------------------------------------------------------------

COMMAND = "day6-tui class --join 192.0.2.7 --name anna --secret FILE"


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_the_command_to_join_is_always_at_hand(class_of: Class, size: tuple[int, int]) -> None:
    async with class_of(*size) as window:
        assert COMMAND in window.text
        await window.come("anna")
        assert COMMAND in window.text
        await window.press("enter", "i")
        assert COMMAND in window.text
        await window.press("enter")
        assert window.app.clipboard == COMMAND


async def test_a_long_command_to_join_is_wrapped_not_cut(class_of: Class) -> None:
    async with class_of(80, 24) as window:
        window.link._listen = "tcp/a-rather-long-name-of-a-machine.school.example:17447"
        window.app.frames.wake()
        await window.come("anna")
        assert "--secret FILE" in window.text and "…" not in window.text


@pytest.mark.parametrize(("lang", "told"), [("en", "Nobody can join: another program"), ("zh", "没有人能加入")])
async def test_a_shut_door_invites_nobody(class_of: Class, lang: str, told: str) -> None:
    shut = OPEN._replace(state=DoorState.IN_USE)
    async with class_of(80, 24, door=shut, lang=lang) as window:
        assert told in window.text and "7447" in window.text and "--join" not in window.text
        await window.press("i")
        assert window.app.desktop.overlay is None


async def test_those_who_were_turned_away_are_told_of(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        window.part.turned_away("anna", "taken")
        window.part.turned_away("ben", "full")
        await window.step()
        assert "anna is taken: another computer is asking for this name" in window.text
        assert "ben cannot join: the class is full" in window.text
        await window.come("ben")
        above_the_notice = window.text.rpartition("\n")[0]
        assert "ben cannot join" not in above_the_notice and "anna is taken" in above_the_notice


async def test_a_taken_name_is_told_of_as_long_as_somebody_asks_for_it_and_once_as_a_notice(
    class_of: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken, now = "anna is taken", time.monotonic()
    async with class_of() as window:
        await window.come("anna")
        notices = []
        monkeypatch.setattr(window.app.notices, "show", lambda text, seconds: notices.append(text))
        with monkeypatch.context() as passing:  # undone before the clock is that it stands on
            for passed in range(0, 40, 2):  # every second or so
                passing.setattr(link.time, "monotonic", lambda at=now + passed: at)
                window.part.turned_away("anna", "taken")
                await window.step()
                assert taken in window.text
            assert len(notices) == 1
            passing.setattr(link.time, "monotonic", lambda: now + 60)  # another name was chosen
            await window.step()
            assert taken not in window.text


# -- the table ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("columns", [80, 120])
async def test_a_long_name_is_not_cut_where_there_is_room(class_of: Class, columns: int) -> None:
    name = "a_name_of_thirty_two_characters_"
    async with class_of(columns, 24) as window:
        await window.come(name, "ben")
        assert f"{name} " in window.text


TROUBLE = Trouble({"en": "The package was not found", "zh": "找不到这个包"}, "Package 'x' not found")


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_hand_hides_no_error(class_of: Class, lang: str) -> None:
    async with class_of(80, 24, lang=lang) as window:
        await window.come("anna")
        await window.say("anna", hand=True, trouble=TROUBLE)
        line = window.line_with("anna   ")
        assert TROUBLE.title[lang] in line and Texts(lang)("teacher.state.hand_now") in line


async def test_the_minutes_of_a_hand_are_never_what_is_cut(class_of: Class, monkeypatch: pytest.MonkeyPatch) -> None:
    async with class_of(60, 24) as window:
        roster = window.link.roster
        await window.come("a_name_of_thirty_two_characters_")
        await window.say(
            "a_name_of_thirty_two_characters_",
            hand=True,
            trouble=TROUBLE,
            lesson=LessonPlace("day3", {"en": "Day 3"}, 11, 12),
        )
        assert "hand up" in window.text and "0 min" not in window.text
        later = roster.now + 12 * 60 + 1
        monkeypatch.setattr(roster, "_clock", lambda: later)
        await window.step()
        assert "hand 12 min" in window.text


async def test_a_hand_is_up_for_so_long_and_on_this_step_for_so_long(
    class_of: Class, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with class_of(100, 24) as window:
        roster, clock = window.link.roster, window.link.roster._clock
        monkeypatch.setattr(roster, "_clock", lambda: clock() - 6 * 60)
        await window.come("anna", "ben")
        await window.say("anna", lesson=LessonPlace("day1", {"en": "Day 1"}, 3, 12))
        await window.say("anna", lesson=LessonPlace("day1", {"en": "Day 1"}, 3, 12, solved=True))
        monkeypatch.setattr(roster, "_clock", lambda: clock() - 2 * 60)
        await window.say("anna", hand=True)
        await window.say("ben", hand=True, lesson=LessonPlace("day1", {"en": "Day 1"}, 5, 12))
        monkeypatch.setattr(roster, "_clock", clock)
        await window.step()
        assert "hand 2 min  step 6 min" in window.line_with("anna   ")
        assert "hand 2 min  step 2 min" in window.line_with("ben   ")


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_question_is_asked_and_its_answers_are_counted(class_of: Class, lang: str) -> None:
    texts = Texts(lang)
    async with class_of(80, 24, lang=lang) as window:
        await window.come("anna", "ben", "carl")
        await window.press("A", *("D", "o", "n", "e", "?"), "enter")
        (question,) = window.link.roster.questions.open
        assert (
            window.part.asked_of("ben")[-1].number == question.number
            and texts("teacher.sent.all", count=3) in window.text
        )
        await window.say("anna", replies=(Reply(question.number, "yes"),))
        await window.say("ben", replies=(Reply(question.number, "words", "\x1b[31mal\u202emost"),))
        counts = window.line_with("Done?")
        for what in ("yes", "words"):
            assert f"{texts(f'class.reply.{what}')} 1" in counts
        assert counts.rstrip(" │┃").endswith(texts("teacher.reply.silent", count=1))
        assert texts("class.reply.yes") in window.line_with("anna   ")
        assert "most" in window.line_with("ben   ") and "\x1b" not in window.text and "\u202e" not in window.text
        assert texts("teacher.reply.none") in window.line_with("carl   ")
        await window.press("w")
        assert "Done?" not in window.text and window.part.asked_of("carl", "settle")
        assert not window.part.asked_of("anna", "settle")


async def test_a_link_is_handed_over_and_nothing_else(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("l", *["backspace"] * 8, *"file:/x", "enter")
        assert "a link begins with" in window.text and window.part.asked_of("anna", "link") == []
        await window.press(*["backspace"] * 7, *"https://a.b/c", "enter")
        assert window.part.asked_of("anna", "link") == [Order("link", text="https://a.b/c")]


async def test_one_hand_is_one_hand(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben")
        await window.say("anna", hand=True)
        assert "1 hand up" in window.text and "1 hands" not in window.text
        await window.say("ben", hand=True)
        assert "2 hands up" in window.text


async def test_many_rows_say_where_there_are_more_and_do_not_go_round(class_of: Class) -> None:
    names = [f"p{number:02}" for number in range(30)]
    async with class_of(80, 24) as window:
        await window.come(*names)
        await window.press("up")
        assert "p00" in window.text and "↓" in window.text and "↑" not in window.line_with("more")
        await window.press("end", "down")
        assert "p29" in window.text and "p00" not in window.text and "↑" in window.line_with("more")
        await window.press("pageup")
        assert "↑" in window.line_with("more") and "↓" in window.line_with("more")
        await window.press("home")
        assert "▸ p00" in window.text
        pane = window.pane
        await window.pilot._post_mouse_events([_wheel()], pane, (10, 4))
        await window.step()
        assert "p00" not in window.text
        await window.press("down")
        assert "▸ p01" in window.text


def _wheel() -> Any:
    from textual import events

    return events.MouseScrollDown


async def test_in_a_room_only_a_pupils_own_nodes_are_shown(class_of: Class) -> None:
    nodes = ("/anna/turtlesim", "/ben/teleop_turtle", "/ben_2/talker")
    async with class_of(room=True) as window:
        await window.come("anna", "ben")
        await window.say("anna", nodes=nodes)
        await window.say("ben", nodes=nodes)
        assert "/anna/turtlesim" in window.line_with("anna   ") and "/ben" not in window.line_with("anna   ")
        assert "/ben/teleop_turtle" in window.line_with("ben   ") and "/ben_2" not in window.text


async def test_the_row_of_who_is_gone_can_be_removed_and_no_other(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben", "carl")
        await window.press("d")
        assert "only pupils who have left" in window.text and "anna  " in window.text
        await window.leave("ben")
        await window.press("end", "delete")
        assert "ben" not in window.text and "▸ carl" in window.text


@pytest.mark.parametrize("preview", [False, True])
def test_every_line_of_the_window_has_a_use(preview: bool) -> None:
    for rows in range(1, 40):
        for told in range(4):
            for height in range(5, 50):
                place = places_for(rows, told, height, preview=preview)
                assert min(4, rows + 1) <= place.table <= rows + 1 and place.told <= told
                assert place.preview == 0 or place.preview >= 8
                used = place.table + place.preview + place.told
                assert used == height if place.preview else used == min(height, rows + 1 + told)


# -- orders ------------------------------------------------------------------------------------------------------------


async def test_it_is_told_whom_an_order_has_reached(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna", "ben", "carl")
        await window.press("s", "h", "i", "enter")
        assert "sent to anna" in window.text
        await window.leave("anna")
        await window.press("S", "h", "i", "enter")
        assert "sent to 2; not reached: anna (away)" in window.text
        await window.press("end", "o", "enter")
        assert "not reached: anna (away)" in window.text and "sent to" not in window.text


async def test_the_question_before_the_end_names_the_pupils_desktop(class_of: Class) -> None:
    async with class_of() as window:
        await window.come("anna")
        await window.press("x")
        assert "End the desktop of anna?" in window.text
        await window.press("y")
        assert window.part.asked_of("anna", "end")


async def test_the_report_and_the_log_are_written_and_nothing_is_overwritten(class_of: Class, tmp_path: Any) -> None:
    async with class_of() as window:
        window.link.home = tmp_path
        await window.come("anna")
        await window.press("e")
        await window.press(*["backspace"] * 30, *"~/lesson.csv", "enter")
        assert "written: lesson.csv, lesson-log.csv" in window.text
        assert sorted(path.name for path in tmp_path.iterdir()) == ["lesson-log.csv", "lesson.csv"]
        assert "anna,came" in (tmp_path / "lesson-log.csv").read_text(encoding="utf-8-sig")
        (tmp_path / "lesson.csv").unlink()
        await window.press("e")
        await window.press(*["backspace"] * 30, *"lesson.csv", "enter")
        assert "lesson-log.csv already exists" in window.text and not (tmp_path / "lesson.csv").exists()


async def test_the_log_goes_on_where_a_desktop_that_was_killed_left_it(class_of: Class, tmp_path: Any) -> None:
    for number in (1, 2):
        async with class_of(home=tmp_path) as window:
            await window.come("anna")
            await window.press("s", *f"round {number}", "enter", "e")
            await window.press(*["backspace"] * 30, *f"{number}.csv", "enter")
    rows = [line.split(",", 1)[1] for line in (tmp_path / "2-log.csv").read_text(encoding="utf-8-sig").splitlines()]
    assert rows[1:5] == [
        "teacher,all,opened the class,",
        "pupil,anna,came,",
        "teacher,anna,said,round 1",
        "teacher,all,opened the class,",
    ]
    assert rows[-1] == "teacher,anna,said,round 2"


# -- the rest of the desktop -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_a_hand_is_seen_in_the_top_line_and_a_click_brings_the_class(class_of: Class, lang: str) -> None:
    texts = Texts(lang)
    async with class_of(lang=lang) as window:
        await window.come("anna", "ben")
        window.app.desktop.focus_pane(window.app.terminals.panes[0])
        window.app.desktop.toggle_enlarged()
        await window.step()
        await window.say("anna", hand=True)
        lines = window.text.split("\n")
        assert texts("teacher.bar.hand") in lines[0] and texts("teacher.raised", name="anna") in lines[-1]
        await window.say("ben", hand=True)
        text = texts("teacher.bar.hands", count=2)
        lines = window.text.split("\n")
        assert text in lines[0]
        await window.pilot.click(offset=(cell_len(lines[0][: lines[0].index(text)]) + 1, 0))
        await window.step()
        assert window.app.desktop.focused_pane is window.pane and "ben" in window.text


async def test_the_action_of_the_class_brings_the_window_to_the_front_and_never_closes_it(class_of: Class) -> None:
    async with class_of() as window:
        window.app.desktop.focus_pane(window.app.terminals.panes[0])
        await window.step()
        for _ in range(2):
            window.app.show_class()
            await window.step()
            assert window.app.desktop.focused_pane is window.pane


@pytest.mark.parametrize(
    ("names", "told"), [(["anna"], "1 pupil is connected"), (["anna", "ben"], "2 pupils are connected")]
)
async def test_leaving_asks_while_pupils_are_joined(class_of: Class, names: list[str], told: str) -> None:
    async with class_of() as window:
        left: list[object] = []
        window.app.exit = lambda *result, **more: left.append(more)  # type: ignore[method-assign]
        await window.come(*names)
        await window.press("ctrl+q")
        assert told in window.text and left == []
        await window.press("escape")
        await window.press("ctrl+q", "ctrl+q")
        assert left == [{}]


async def test_leaving_an_empty_class_asks_nothing(class_of: Class) -> None:
    async with class_of() as window:
        left: list[object] = []
        window.app.exit = lambda *result, **more: left.append(more)  # type: ignore[method-assign]
        await window.press("ctrl+q")
        assert left == [{}]


@pytest.mark.parametrize("lang", ["en", "zh"])
async def test_at_80_columns_the_keys_used_most_are_on_the_key_line_and_all_in_the_help(
    class_of: Class, lang: str
) -> None:
    texts = Texts(lang)
    async with class_of(80, 24, lang=lang) as window:
        await window.come("anna")
        last = window.text.split("\n")[-1]
        for what in ("large", "say", "freeze", "type"):
            assert texts(f"teacher.key.{what}") in last
        await window.press("f1")
        manual = window.app.desktop.overlay
        page = manual.markdown()  # type: ignore[union-attr]
        keys = "Enter Esc n p s S O o f t c v i h a A w l L d e x ^] Home PgUp ↑"
        for key in keys.split():
            assert key in page
        assert texts("teacher.key.end") in page


@pytest.mark.long
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("word", ["hand", "teacher"])
async def test_the_manual_has_a_page_for_the_pupils_of_a_class(class_of: Class, word: str, lang: str) -> None:
    async with class_of(lang=lang) as window:
        await window.press("f1")
        await window.press(*word)
        assert Texts(lang)("manual.classroom_pupil") in window.text


# -- files -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("key", ["g", "G"])
async def test_a_file_is_handed_out_and_it_is_told_who_has_it_and_why_somebody_has_not(
    class_of: Class, tmp_path: Path, key: str
) -> None:
    (tmp_path / "talker.py").write_bytes(b"print()\n")
    async with class_of(200, 40, home=tmp_path) as window:
        await window.come("anna", "ben", "carl", "dora")
        await window.leave("dora")
        full = "No space left on device"
        window.part.answers = {
            name: json.dumps({"path": path, "why": why}).encode()
            for name, path, why in (("anna", "handed/talker_2.py", ""), ("ben", "", full))
        }
        await window.press(key)
        for letter in "talker.py":
            await window.pilot.press("full_stop" if letter == "." else letter)
        await window.press("enter")
        told = f"talker.py: 1 of {1 if key == 'g' else 4} have it"
        await step_until(window.app, window.pilot, lambda: told in window.text)
        assert window.part.asked_of("anna", "file") == [Order("file", text="handed/talker_2.py")]
        if key == "G":
            await step_until(window.app, window.pilot, lambda: "carl (no answer)" in window.text)
            assert f"ben ({full})" in window.text and "dora (away)" in window.text
            assert sorted(name for name, _ in window.part.handed) == ["anna", "ben", "carl"]
        assert {message for _, message in window.part.handed} == {b'"talker.py"\nprint()\n'}


@pytest.mark.parametrize(("path", "told"), [("none.py", "No such file"), ("", "directory"), ("large", "too large")])
async def test_what_cannot_be_handed_out_is_told_in_the_prompt(
    class_of: Class, tmp_path: Path, path: str, told: str
) -> None:
    (tmp_path / "large").write_bytes(b"a" * (LARGEST + 1))
    async with class_of(home=tmp_path) as window:
        await window.come("anna")
        await window.press("g")
        for letter in path:
            await window.pilot.press("full_stop" if letter == "." else letter)
        await window.press("enter")
        assert told in window.text and not window.part.handed
