"""What is shown to a class: when it begins and ends, and how a picture goes to all pupils of a network."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable
from typing import Any

import pytest

from day6_core.classroom import shown
from day6_core.classroom.note import LONGEST, Note, PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster
from day6_core.classroom.show import OWN, WANTED_SECONDS, Show, Stage
from day6_core.classroom.shown import AGAIN_SECONDS, EVERY_SECONDS, Pace, Shown, ShownError

SCREEN = PupilScreen(20, 3, "one\ntwo\nthree", (0, 1, 20, 2, 2))
ANNA, MINE = Show("anna", None, False), Show(OWN, None, False)
SHOWN = Note(attended=True, may_show=True, shown=True, screen=SCREEN)


class Hall:
    """The projector of a stage: keeps what it is told."""

    def __init__(self) -> None:
        self.away: set[str] = set()
        self.sent: list[tuple[str, Order]] = []
        self.said: list[tuple[str, str]] = []
        self.drawn: list[PupilScreen] = []
        self.timers: list[tuple[float, Callable[[], None]]] = []
        self.roster = Roster()
        self.roster.attend(True)
        self.stage = Stage(self.roster, self, lambda *what: self.timers.append(what))

    def send(self, name: str, order: Order) -> bool:
        self.sent.append((name, order))
        return name not in self.away

    def say(self, key: str, name: str) -> None:
        self.said.append((key, name))

    def changed(self) -> None:
        pass

    def project(self, screen: PupilScreen) -> None:
        self.drawn.append(screen)

    def agree(self, name: str) -> None:
        for note in (Note(asked_show=True), Note(may_show=True), SHOWN):
            self.stage.noted(name, note)


def test_a_pupil_is_asked_and_the_own_desktop_is_not() -> None:
    hall = Hall()
    hall.stage.start(ANNA)
    assert hall.sent == [("anna", Order("ask_to_show"))] and hall.stage.on is None
    hall.agree("anna")
    assert hall.stage.on == ANNA and hall.drawn == [SCREEN] and ("anna", Order("show", on=True)) in hall.sent
    hall.stage.start(MINE)
    assert hall.sent[-1] == (OWN, Order("show", on=True)) and hall.stage.on == ANNA  # until the other one is there
    hall.stage.noted(OWN, Note(shown=True, screen=SCREEN))
    assert hall.stage.on == MINE and hall.sent[-1] == ("anna", Order("show"))
    assert [(event.what, event.name) for event in hall.roster.journal.events()][-2:] == [
        ("showed", "anna"),
        ("showed", OWN),
    ]


@pytest.mark.parametrize(
    ("answers", "why"),
    [
        ([Note(asked_show=True), Note(refused="class.refused.no")], "no"),
        ([Note(refused="class.refused.busy")], "busy"),
        ([None], "gone"),
        ([], "silent"),
    ],
)
def test_without_a_yes_nothing_is_shown(answers: list[Note | None], why: str) -> None:
    hall = Hall()
    hall.stage.start(ANNA)
    for answer in answers:
        hall.stage.noted("anna", answer)
    (seconds, give_up), *_ = hall.timers
    assert seconds == WANTED_SECONDS
    give_up()
    assert hall.said == [(why, "anna")] and hall.stage.wanted is None and hall.stage.on is None
    hall.stage.noted("anna", SHOWN)  # a yes that comes late
    assert hall.drawn == []


def test_who_cannot_be_reached_is_not_wanted() -> None:
    hall = Hall()
    hall.away.add("anna")
    hall.stage.start(ANNA)
    assert hall.said == [("gone", "anna")] and hall.stage.wanted is None and not hall.timers


@pytest.mark.parametrize("how", ["stop", "taken back", "gone", "no teacher"])
def test_it_ends(how: str) -> None:
    hall = Hall()
    hall.stage.start(ANNA)
    hall.agree("anna")
    if how == "stop":
        hall.stage.stop()
    elif how == "no teacher":
        hall.roster.attend(False)
        hall.stage.look_for_teacher()
    else:
        hall.stage.noted("anna", None if how == "gone" else Note(attended=True))
    assert hall.stage.on is None and hall.sent[-1] == ("anna", Order("show"))
    assert hall.said == ([("over", "anna")] if how in ("taken back", "gone") else [])


def test_larger_and_for_others_asks_nobody_again() -> None:
    hall = Hall()
    hall.stage.start(ANNA)
    hall.agree("anna")
    before = len(hall.sent)
    hall.stage.start(ANNA._replace(full=True))
    assert hall.stage.on == ANNA._replace(full=True)
    hall.stage.again(full=False)
    assert hall.stage.on == ANNA and len(hall.sent) == before


# -- on the wire -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("names", [None, frozenset({"anna", "ben"})])
def test_a_picture_comes_as_it_went(names: frozenset[str] | None) -> None:
    picture = Shown(7, Show("carl", names, full=True), SCREEN)
    assert shown.decode(shown.encode(picture)) == picture
    assert shown.decode(shown.encode(None)) is None


@pytest.mark.parametrize(
    ("show", "name", "sees"),
    [
        (MINE, "anna", True),
        (ANNA, "anna", False),
        (ANNA, "ben", True),
        (Show(OWN, frozenset({"ben"}), False), "anna", False),
        (Show(OWN, frozenset({"ben"}), False), "ben", True),
    ],
)
def test_for_whom_it_is(show: Show, name: str, sees: bool) -> None:
    assert show.is_for(name) is sees


def changed(**what: Any) -> bytes:
    found = json.loads(zlib.decompress(shown.encode(Shown(7, ANNA, SCREEN))))
    return zlib.compress(json.dumps(found | what).encode())


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"no zlib",
        shown.encode(Shown(7, ANNA, SCREEN))[:-9],
        zlib.compress(b"\0" * (50 * LONGEST)),  # a few thousand bytes
        zlib.compress(b"[" * 100_000),
        zlib.compress(b"[1]"),
        zlib.compress(b"7"),
        changed(number="7"),
        changed(number=True),
        changed(number=-1),
        changed(names=7),
        changed(screen=None),
        changed(screen={"columns": 10**9, "rows": 1, "ansi": ""}),
        changed(screen={"columns": 20, "rows": 3, "ansi": ["a"]}),
    ],
)
def test_what_is_no_picture_is_refused(data: bytes) -> None:
    with pytest.raises(ShownError):
        shown.decode(data)


def test_a_bomb_is_not_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    bomb, longest = zlib.compress(b" " * (100 * LONGEST)), 0

    class Unpacking:
        def __init__(self) -> None:
            self._real = zlib.decompressobj()

        @property
        def eof(self) -> bool:
            return self._real.eof

        def decompress(self, data: bytes, most: int) -> bytes:
            nonlocal longest
            text = self._real.decompress(data, most)
            longest = len(text)
            return text

    monkeypatch.setattr(shown, "zlib", type("Zlib", (), {"decompressobj": Unpacking, "error": zlib.error}))
    with pytest.raises(ShownError):
        shown.decode(bomb)
    assert 0 < longest <= LONGEST


def test_nothing_but_text_and_colours_is_left_of_a_picture() -> None:
    evil = "\x1b[31mred\x1b[0m \x1b]52;c;cm0=\x07\x1b]8;;http://evil/\x1b\\link\x1b]8;;\x1b\\\x9b6n\x1b[6n\x1bc\x1b[2J\u202eesrever\r\x08\x00"
    found = shown.decode(
        changed(screen={"columns": 80, "rows": 1, "ansi": evil}, source="an\x1b[2Jna", names=["\x1b]0;x\x07"])
    )
    assert found is not None and found.show.names is not None
    for text in (found.screen.ansi, found.show.source, *found.show.names):
        left = text.replace("\x1b[31m", "").replace("\x1b[0m", "")
        assert "\x1b" not in left and left.isprintable()


def test_a_picture_that_is_too_long_is_not_sent() -> None:
    with pytest.raises(ShownError):
        shown.encode(Shown(7, ANNA, PupilScreen(500, 200, "a" * LONGEST)))


def test_a_picture_goes_out_when_something_changed_but_not_too_often_and_again_now_and_then() -> None:
    pace, other = Pace(), PupilScreen(20, 3, "another")
    assert pace.is_due(SCREEN, 100.0) and not pace.is_due(SCREEN, 101.0)
    assert pace.is_due(other, 101.0)
    assert not pace.is_due(SCREEN, 101.0 + EVERY_SECONDS / 2)
    assert pace.is_due(SCREEN, 101.0 + EVERY_SECONDS)
    assert not pace.is_due(SCREEN, 102.9) and pace.is_due(SCREEN, 101.0 + EVERY_SECONDS + AGAIN_SECONDS)
