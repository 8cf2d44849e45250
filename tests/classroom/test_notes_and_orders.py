"""What pupils tell and teachers ask, on the way from one machine to another."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.note import LessonPlace, Note, NoteError, PupilScreen, Reply, Trouble
from day6_core.classroom.order import Order, OrderError

FULL = Note(
    lesson=LessonPlace("day3", {"zh": "第三天", "en": "Day 3"}, 4, 12, True, 2),
    trouble=Trouble({"zh": "找不到", "en": "Not found"}, "Package 'turtlesin' not found"),
    nodes=("/turtlesim", "/teleop_turtle"),
    programs=("turtlesim_node",),
    hand=True,
    idle=12.5,
    watched=True,
    frozen=True,
    may_type=True,
    asked_show=True,
    may_show=True,
    shown=True,
    refused="class.refused.type",
    replies=(Reply(1, "yes"), Reply(2, "words", "快好了")),
    opened=(3, 1 << 41),
    screen=PupilScreen(80, 2, "\x1b[1mone\x1b[0m\ntwo", (40, 0, 40, 2, 1)),
)


@pytest.mark.parametrize("note", [FULL, Note()])
def test_a_note_arrives_as_it_was_sent(note: Note) -> None:
    assert notes.decode(notes.encode(note)) == note


def test_nothing_a_pupil_writes_controls_the_teachers_terminal() -> None:
    found = json.loads(notes.encode(FULL))
    evil = "\x1b]0;owned\x07\u202e" + "x" * 5000
    found["nodes"] = [evil, 3, None] + ["n"] * 500
    found["trouble"]["line"] = evil
    found["screen"]["ansi"] = "\x1b[31mred\x1b[0m\x1b]52;c;AAAA\x07\x1bPq\x1b\\\x1b[2J" + "\nline" * 500
    note = notes.decode(json.dumps(found).encode())
    assert note.trouble is not None and note.screen is not None
    for text in (*note.nodes, note.trouble.line, note.screen.ansi.replace("\x1b[31m", "").replace("\x1b[0m", "")):
        assert "\x1b" not in text and "\x07" not in text and "\u202e" not in text
    assert len(note.nodes) <= notes.MOST_NAMES and len(note.trouble.line) < 1000
    assert "\x1b[31m" in note.screen.ansi and note.screen.ansi.count("\n") < 2


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff\xfe",
        b"[]",
        b'{"v": 2}',
        b'{"v": 1, "lesson": {"name": "a", "title": {}, "step": 9, "all": 3}}',
        b'{"v": 1, "screen": {"columns": 100000, "rows": 2, "ansi": ""}}',
        b'{"v": 1, "opened": [1, 2.5]}',
        b"[" * 100_000,
        b"x" * (notes.LONGEST + 1),
    ],
)
def test_what_is_no_note_is_refused(data: bytes) -> None:
    with pytest.raises(NoteError):
        notes.decode(data)


FIELDS = (
    "v",
    "lesson",
    "name",
    "title",
    "step",
    "all",
    "nodes",
    "screen",
    "columns",
    "rows",
    "ansi",
    "idle",
    "asked",
    "on",
    "do",
    "text",
    "replies",
    "opened",
    "number",
    "kind",
)
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inside: st.lists(inside, max_size=4) | st.dictionaries(st.sampled_from(FIELDS), inside, max_size=6),
    max_leaves=20,
)


@given(st.dictionaries(st.sampled_from(FIELDS), JSON))
def test_any_json_is_a_note_or_an_order_or_is_refused(found: dict[str, object]) -> None:
    for read, refusal in ((notes.decode, NoteError), (orders.decode, OrderError)):
        try:
            read(json.dumps({"v": 1, **found}).encode())
        except refusal:
            continue


@pytest.mark.parametrize(
    ("work", "taken"),
    [
        ([0, 0, 80, 24, 23], True),
        ([70, 1, 10, 5, 5], True),
        *(
            (each, False)
            for each in (None, "x", [0, 0, 80, 24], [0, 0, 81, 24, 3], [0, 20, 80, 5, 21], [0, 0, 80, 10, 10])
        ),
        *((each, False) for each in ([0, 0, 0, 24, 3], [0, 5, 80, 5, 4])),
    ],
)
def test_where_a_pupil_works_is_on_the_screen_or_left_out(work: object, taken: bool) -> None:
    data = json.dumps({"v": 1, "screen": {"columns": 80, "rows": 24, "ansi": "", "work": work}}).encode()
    screen = notes.decode(data).screen
    assert screen is not None and (screen.work is not None) is taken


def test_a_screen_too_large_stays_behind_and_the_rest_goes() -> None:
    sent = Note(hand=True, screen=PupilScreen(500, 200, "\x1b[38;2;1;2;3mx" * 20_000))
    assert notes.decode(notes.encode(sent)) == Note(hand=True)


@pytest.mark.parametrize(
    "order",
    [
        *(
            Order("say", text="看黑板"),
            Order("scene", text="turtle"),
            Order("lesson", text="day3"),
            Order("type", text="\r"),
        ),
        *(
            Order("say", text="?", number=1 << 53),
            Order("settle", number=3),
            Order("file", text="handed/地图.py", number=4),
        ),
        *(Order("link", text="http://[::1]:8000/a%20b?c=d#e"), Order("link", text="https://docs.ros.org")),
        *(Order("freeze", on=True), Order("freeze"), Order("watch", seconds=10.0), Order("tell"), Order("end")),
    ],
)
def test_an_order_arrives_as_it_was_sent(order: Order) -> None:
    assert orders.decode(orders.encode(order)) == order


@pytest.mark.parametrize(
    "data",
    [
        b"{}",
        b'{"do": "rm -rf"}',
        b'{"do": "say"}',
        b'{"do": "say", "text": ""}',
        b'{"do": "say", "text": "?", "number": -1}',
        b'{"do": "say", "text": "?", "number": 1e3}',
        b'{"do": "link", "text": "javascript://x/%0aalert(1)"}',
        b'{"do": "link", "text": "https://user@bank.example/"}',
        b'{"do": "link", "text": "http://[::1"}',
        b'{"do": "link", "text": "http://a:99999/"}',
        b'{"do": "link", "text": "http://a/\\u202e"}',
        b'{"do": "file", "text": "../x"}',
        b'{"do": "file", "text": "a/../../x"}',
        b'{"do": "file", "text": "/etc/passwd"}',
        b'{"do": "file", "text": "."}',
        b'{"do": "watch", "seconds": 1e9}',
        b'{"do": "watch", "seconds": true}',
        b'{"do": "say", "text": "' + b"a" * orders.LONGEST + b'"}',
        b"\x00",
    ],
)
def test_what_is_no_order_is_refused(data: bytes) -> None:
    with pytest.raises(OrderError):
        orders.decode(data)
