"""A kept desktop that a teacher observes: what it tells, and what its pupil sees of that."""

from __future__ import annotations

import select
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.note import Note
from day6_core.classroom.order import Order
from day6_tui.classes.modals import GRACE_SECONDS
from day6_tui.locale import Texts
from tests.e2e.test_detach import end_all, sockets
from tests.support.waiting import Deadline, until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

from day6_tui.detached import wire

pytestmark = pytest.mark.person

PROMPT = "student@day6:~$"


class Observer:
    """A teacher's end of the line to one desktop."""

    def __init__(self, path: str) -> None:
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        connection.connect(path)
        self.line = wire.Connection(connection)
        self.line.send(wire.WATCH)
        self.notes: list[Note] = []
        self.ended = False

    def order(self, do: str, **words: object) -> None:
        self.line.send(wire.ORDER, orders.encode(Order(do, **words)))  # type: ignore[arg-type]

    def send(self, data: bytes) -> None:
        self.line.send(wire.ORDER, data)

    def hear(self, seconds: float) -> None:
        if select.select([self.line], [], [], seconds)[0]:
            for kind, data in self.line.receive():
                if kind == wire.NOTE:
                    self.notes.append(notes.decode(data))
                self.ended = self.ended or kind == wire.END

    def wait(self, condition: Callable[[Note], object]) -> Note:
        """The first note, from the last one on, of which this is true."""
        deadline, at = Deadline(), max(0, len(self.notes) - 1)
        while True:
            for note in self.notes[at:]:
                if condition(note):
                    return note
            at = len(self.notes)
            assert not deadline.is_over(), self.notes[-1:]
            self.hear(0.2)


@contextmanager
def observer(place: Place) -> Iterator[Observer]:
    until(lambda: sockets(place))
    found = Observer(str(sockets(place)[0]))
    try:
        yield found
    finally:
        found.line.close()


def choose(screen: Terminal, name: str) -> None:
    """Do something by the palette."""
    screen.press("F7")
    screen.wait("Alt+-")
    screen.send(name)
    screen.wait(f"▸ {name}", lambda seen: "Alt+-" not in seen)
    screen.press("Enter")


def answer_consent(screen: Terminal, key: str) -> None:
    """Answer the question whether the teacher may type, until it is gone: what comes too early is no answer."""
    texts = Texts("en")
    screen.wait(texts("class.consent.yes"))

    def answered() -> bool:
        screen.look(1.2 * GRACE_SECONDS)
        return texts("class.consent.yes") not in screen.look()

    until(answered, every=0.0, meanwhile=lambda: screen.press(key))
    screen.press("Ctrl-C")  # if it was answered by the key before the last one
    screen.line("echo answ''ered")
    screen.wait_lines("answered")


@pytest.mark.parametrize(("lang", "size"), [("en", (120, 40)), ("zh", (80, 24))])
def test_the_teacher_hears_and_the_pupil_sees_that_somebody_does(
    place: Place, lang: str, size: tuple[int, int]
) -> None:
    texts = Texts(lang)
    with place.desktop("--detach", "--scene", "empty", columns=size[0], rows=size[1], lang=lang) as screen:
        screen.wait(PROMPT)
        with observer(place) as teacher:
            teacher.wait(lambda note: not note.hand and not note.watched and note.screen is None)
            assert texts("class.bar.raise") not in screen.look()  # a server looks on, and no teacher
            teacher.order("attend", on=True)
            teacher.wait(lambda note: note.attended)
            screen.line("ros2 run turtlesin turtlesim_node")
            note = teacher.wait(lambda note: note.trouble is not None)
            assert note.trouble is not None and "turtlesin" in note.trouble.line and note.trouble.title["zh"]
            screen.line("true")
            teacher.wait(lambda note: note.trouble is None)
            choose(screen, texts("action.hand"))
            teacher.wait(lambda note: note.hand)
            screen.wait(texts("class.bar.hand"))
            teacher.order("lower_hand")
            teacher.wait(lambda note: not note.hand)

            teacher.order("watch", seconds=60)
            screen.wait(texts("class.bar.watched"))
            screen.line("echo seen-$((40 + 2))")
            note = teacher.wait(lambda note: note.screen is not None and "seen-42" in note.screen.ansi)
            assert note.watched and note.screen is not None
            assert (note.screen.columns, note.screen.rows) == size
            teacher.order("unwatch")
            teacher.wait(lambda note: not note.watched and note.screen is None)
            screen.wait_gone(texts("class.bar.watched"))

            teacher.order("say", text="look \x1b]0;at\x07 me")
            screen.wait("look ^[]0;at^G me")
        screen.quit()
        screen.wait_end()


def test_a_frozen_screen_takes_no_keys_and_is_free_again_when_the_teacher_goes(place: Place) -> None:
    texts = Texts("en")
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        with observer(place) as teacher:
            teacher.order("attend", on=True)
            teacher.order("freeze", on=True)
            screen.wait(texts("class.frozen.title"))
            teacher.wait(lambda note: note.frozen)
            screen.press("Esc", "Ctrl-C", "x", "F2")
            teacher.order("freeze")
            screen.wait_gone(texts("class.frozen.title"))
            screen.line("echo free")
            screen.wait_lines("free")
            screen.press("F7")
            screen.wait("Alt+-")
            screen.send("half a wo")
            screen.wait("half a wo")
            teacher.order("freeze", on=True)
            screen.wait(texts("class.frozen.title"))
            teacher.order("attend", on=False)
            screen.wait_gone(texts("class.frozen.title"))
            teacher.order("attend", on=True)
            teacher.order("freeze", on=True)
            screen.wait(texts("class.frozen.title"))
        screen.wait_gone(texts("class.frozen.title"))
        screen.wait("half a wo")  # what was being filled in is still there
        screen.press("Esc")
        screen.wait_gone("half a wo")
        screen.quit()
        screen.wait_end()


def test_the_teacher_types_after_consent_and_not_before_or_after(place: Place) -> None:
    texts = Texts("en")
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        with observer(place) as teacher:
            teacher.order("attend", on=True)
            teacher.order("type", text="echo early\r")
            teacher.wait(lambda note: note.refused == "class.refused.type")
            teacher.order("ask_to_type")
            teacher.wait(lambda note: note.asked)
            answer_consent(screen, "\x1b")
            teacher.wait(lambda note: not note.asked and note.refused == "class.refused.no")
            teacher.order("ask_to_type")
            answer_consent(screen, "y")
            teacher.wait(lambda note: note.may_type)
            screen.wait(texts("class.bar.types.short"), lambda seen: texts("class.consent.title") not in seen)
            teacher.order("type", text="echo by-$((1 + 1))\r")
            screen.wait_lines("by-2")
            choose(screen, texts("action.take_back"))
            teacher.wait(lambda note: not note.may_type and note.refused == "class.refused.taken_back")
            teacher.order("type", text="echo late\r")
            teacher.wait(lambda note: note.refused == "class.refused.type")
            assert "late" not in screen.look() and "early" not in screen.look()
        screen.quit()
        screen.wait_end()


def test_scenes_lessons_and_nonsense(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty", columns=120, rows=40) as screen:
        screen.wait(PROMPT)
        with observer(place) as teacher:
            for nonsense in (b"", b"\xff", b'{"do": "rm"}', b'{"do": "watch", "seconds": -1}', b"x" * 100_000):
                teacher.send(nonsense)
            teacher.order("lesson", text="day1")
            note = teacher.wait(lambda note: note.lesson is not None)
            assert note.lesson is not None and (note.lesson.name, note.lesson.step) == ("day1", 1)
            teacher.order("lesson", text="no such lesson")
            teacher.wait(lambda note: note.refused == "class.refused.unknown")
            teacher.order("scene", text="turtle")
            teacher.wait(lambda note: "/turtlesim" in note.nodes)
            screen.wait("┏ 4 ~ ")  # a prompt to the right, at which the cursor is
            teacher.order("end")
            until(lambda: teacher.hear(0.2) or teacher.ended)
        screen.wait("Your teacher has ended this desktop. Your files are kept.")
        screen.wait_end()


def test_observers_that_take_nothing_or_come_in_crowds_harm_nobody(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        until(lambda: sockets(place))
        crowd = [Observer(str(sockets(place)[0])) for _ in range(40)]
        for each in crowd:
            each.order("watch", seconds=60)
        screen.line("for n in $(seq 300); do echo $n; done")
        screen.wait_lines("300")
        with observer(place) as last:
            last.hear(0.5)
        for each in crowd:
            each.line.close()
        screen.line("echo still")
        screen.wait_lines("still")
        screen.quit()
        screen.wait_end()
    if sockets(place):
        end_all(place)
