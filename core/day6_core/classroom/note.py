"""What a pupil's desktop says of itself."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Annotated, Any, get_type_hints

from day6_core.classroom.order import LARGEST_NUMBER
from day6_core.language import LANGUAGES
from day6_core.session.harmless import lines, one_line

VERSION = 1
LONGEST = 256 << 10
"""Bytes of one note."""
LONGEST_TEXT = 200
MOST_NAMES = 64
COLUMNS, ROWS = (1, 500), (1, 200)
WORK = 5
"""Numbers in `PupilScreen.work`."""
MOST_STEPS = 10_000
MOST_REPLIES = 8
MOST_OPENED = 16
LONGEST_REPLY = 80
REPLIES = ("yes", "no", "done", "words")
"""What can be answered to a saying: `words` are the pupil's own."""
REFUSALS = tuple(f"class.refused.{why}" for why in ("busy", "type", "no", "taken_back", "place", "unknown", "full"))
"""Why an order was not followed: keys of the catalogue."""


class NoteError(ValueError):
    """It is no note; the message says why."""


@dataclass(frozen=True)
class LessonPlace:
    """Where the pupil is in a lesson. `step` counts from 1; `hints` is how many of the step's were asked for."""

    name: str
    title: Mapping[str, str]
    step: int
    all: int
    solved: bool = False
    hints: int = 0


@dataclass(frozen=True)
class Trouble:
    """The card that fits what a terminal said last (`day6_core/advice`): its title in each language, and the line itself."""

    title: Mapping[str, str]
    line: str


@dataclass(frozen=True)
class Reply:
    """The answer to the saying with this number: one of REPLIES, and the text of `words`."""

    number: int
    kind: str
    text: str = ""


@dataclass(frozen=True)
class PupilScreen:
    """The pupil's screen: lines of text with colours (SGR) and no other sequences."""

    columns: int
    rows: int
    ansi: str
    work: tuple[int, ...] | None = None
    """What the pupil works in: column, line, columns and lines of the pane, and the line of the screen that counts in it."""


@dataclass(frozen=True)
class Note:
    """One pupil now. `idle` is the seconds since the last key or click when this was said.

    Beside the kind of each field stands what reads it from outside.
    """

    lesson: Annotated[LessonPlace | None, _lesson] = None
    trouble: Annotated[Trouble | None, _trouble] = None
    nodes: Annotated[tuple[str, ...], _names] = ()
    programs: Annotated[tuple[str, ...], _names] = ()
    hand: Annotated[bool, _flag] = False
    idle: Annotated[float, _seconds] = 0.0
    attended: Annotated[bool, _flag] = False
    """Whether it knows of a teacher who is there."""
    watched: Annotated[bool, _flag] = False
    seen: Annotated[bool, _flag] = False
    """Whether it knows of somebody who looks by a link that only watches."""
    frozen: Annotated[bool, _flag] = False
    asked: Annotated[bool, _flag] = False
    """Whether the question is open whether the teacher may type."""
    may_type: Annotated[bool, _flag] = False
    """Whether the pupil lets the teacher type."""
    asked_show: Annotated[bool, _flag] = False
    """Whether the question is open whether this screen may be shown to the class."""
    may_show: Annotated[bool, _flag] = False
    """Whether the pupil lets it be shown."""
    shown: Annotated[bool, _flag] = False
    """Whether it knows that its screen is shown."""
    refused: Annotated[str, _refusal] = ""
    """Why an order was not followed, if the last one was not: one of REFUSALS, or ''."""
    replies: Annotated[tuple[Reply, ...], _replies] = ()
    """To the last sayings that asked for one."""
    opened: Annotated[tuple[int, ...], _numbers] = ()
    """What was opened last of what the teacher handed out with these numbers; of nothing else it is told."""
    screen: Annotated[PupilScreen | None, screen_of] = None
    """Only while the pupil is watched or shown."""


def encode(note: Note) -> bytes:
    """Return a note as it is sent; without its screen if that makes it too long."""
    found: dict[str, Any] = {"v": VERSION, **asdict(note)}
    data = json.dumps(found, ensure_ascii=False).encode(errors="replace")
    if len(data) > LONGEST and note.screen is not None:
        found["screen"] = None
        data = json.dumps(found, ensure_ascii=False).encode(errors="replace")
    return data


def decode(data: bytes) -> Note:
    """Read a note from outside: every text is clipped and harmless on a terminal. Raises NoteError."""
    if len(data) > LONGEST:
        raise NoteError(f"{len(data)} bytes")
    try:
        found = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise NoteError(str(error)) from None
    if not isinstance(found, dict) or found.get("v") != VERSION:
        raise NoteError("not a note of this version")
    try:
        return Note(**{name: read(found.get(name)) for name, read in _READERS.items()})
    except (TypeError, ValueError, KeyError, OverflowError) as error:
        raise NoteError(str(error)) from None


def _text(found: object) -> str:
    return one_line(found[:LONGEST_TEXT]) if isinstance(found, str) else ""


def _names(found: object) -> tuple[str, ...]:
    if not isinstance(found, list):
        return ()
    return tuple(text for text in map(_text, found[:MOST_NAMES]) if text)


def _title(found: object) -> dict[str, str]:
    return {each: _text(found.get(each)) for each in LANGUAGES} if isinstance(found, dict) else {}


def _seconds(found: object) -> float:
    if isinstance(found, bool) or not isinstance(found, (int, float)):
        return 0.0
    return float(found) if 0 <= found < 1e9 else 0.0


def _count(found: object, low: int, high: int) -> int:
    if isinstance(found, bool) or not isinstance(found, int) or not low <= found <= high:
        raise ValueError(f"{one_line(str(found))[:40]} is not a number from {low} to {high}")
    return found


def _lesson(found: object) -> LessonPlace | None:
    if not isinstance(found, dict):
        return None
    steps = _count(found["all"], 1, MOST_STEPS)
    return LessonPlace(
        name=_text(found["name"]),
        title=_title(found["title"]),
        step=_count(found["step"], 1, steps),
        all=steps,
        solved=found.get("solved") is True,
        hints=_count(found.get("hints", 0), 0, 100),
    )


def _trouble(found: object) -> Trouble | None:
    return Trouble(_title(found.get("title")), _text(found.get("line"))) if isinstance(found, dict) else None


def _replies(found: object) -> tuple[Reply, ...]:
    if not isinstance(found, list):
        return ()
    return tuple(reply for each in found[-MOST_REPLIES:] if (reply := _reply(each)) is not None)


def _reply(found: object) -> Reply | None:
    if not isinstance(found, dict) or (kind := found.get("kind")) not in REPLIES:
        return None
    text = _text(found.get("text"))[:LONGEST_REPLY].strip() if kind == "words" else ""
    is_said = text or kind != "words"
    return Reply(_count(found.get("number"), 1, LARGEST_NUMBER), kind, text) if is_said else None


def _numbers(found: object) -> tuple[int, ...]:
    return tuple(_count(each, 1, LARGEST_NUMBER) for each in found[-MOST_OPENED:]) if isinstance(found, list) else ()


def screen_of(found: object) -> PupilScreen | None:
    """Read a screen from outside: what is drawn of it, and nothing else. Raises ValueError, TypeError, KeyError."""
    if not isinstance(found, dict):
        return None
    columns, rows, ansi = _count(found["columns"], *COLUMNS), _count(found["rows"], *ROWS), found["ansi"]
    if not isinstance(ansi, str):
        raise TypeError("a screen is text")
    return PupilScreen(
        columns, rows, "\n".join(lines(ansi).split("\n")[:rows]), _work(found.get("work"), columns, rows)
    )


def _work(found: object, columns: int, rows: int) -> tuple[int, ...] | None:
    if not isinstance(found, list) or len(found) != WORK:
        return None
    x, y, across, down, line = (_count(each, 0, COLUMNS[1]) for each in found)
    is_there = across and down and x + across <= columns and y + down <= rows and y <= line < y + down
    return (x, y, across, down, line) if is_there else None


def _flag(found: object) -> bool:
    return found is True


def _refusal(found: object) -> str:
    return found if isinstance(found, str) and found in REFUSALS else ""


_READERS = {name: kind.__metadata__[0] for name, kind in get_type_hints(Note, include_extras=True).items()}
