"""What a terminal shows after a program's bytes: every sequence at several places, colours, wide characters, sizes.

The pictures are in `pictures.jsonl`. `python -m tests.shell.screen.test_pictures` draws them all anew; look at the difference
before you keep it (they were compared with plain pyte's where that knows the sequence).
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from day6_core.shell.screen.rows import PLAIN_STYLE, Row
from day6_core.shell.screen.screen import Screen

PICTURES = Path(__file__).parent / "pictures.jsonl"


FILLED = "abcdefghij\r\nklmno\r\n你好世界吗\r\nqr\x1b[31mst\x1b[0muvwx\r\nyz"
"""What `FILLED` in the file stands for."""


class Picture(NamedTuple):
    """A screen of so many columns and lines, what is written there in turn (two numbers: a new size), and what is seen then."""

    size: list[int]
    parts: list[str | list[int]]
    rows: list[str]
    cursor: list[int]
    above: list[str]
    """The scrollback."""
    more: str
    """Modes, answers, and how many lines ever left, where there are any."""


USUAL: dict[str, Any] = {"above": [], "more": ""}


def read() -> list[Picture]:
    return [
        Picture(**{**USUAL, **json.loads(line)}) for line in PICTURES.read_text(encoding="utf-8").split("\n") if line
    ]


def line_of(picture: Picture) -> str:
    """A picture as a line of the file, which leaves out what is as usual."""
    told = {name: value for name, value in picture._asdict().items() if USUAL.get(name) != value}
    return json.dumps(told, ensure_ascii=False) + "\n"


def written(row: Row) -> str:
    """A row with its styles in braces."""
    if isinstance(row, str):
        return row
    return "".join(text if style == PLAIN_STYLE else f"{{{_named(style)}:{text}}}" for text, style in row)


def _named(style: Any) -> str:
    plain = PLAIN_STYLE._asdict()
    return ",".join(str(value) if name == "fg" else name if value is True else f"{name}={value}"
                    for name, value in style._asdict().items() if value != plain[name])  # fmt: skip


def drawn(picture: Picture, *, in_pieces: bool) -> Picture:
    screen = Screen(*picture.size)
    for part in picture.parts:
        if not isinstance(part, str):
            screen.resize(part[1], part[0])
        else:
            text = part.replace("FILLED", FILLED)
            for piece in text if in_pieces else [text]:
                screen.feed(piece)
    more = [name for name in ("alternate", "bracketed_paste", "application_cursor_keys") if getattr(screen, name)]
    more += [repr(answer) for answer in screen.answers]
    more += ["hidden"] if screen.cursor.hidden else []
    more += [f"scrolled {screen.scrolled}"] if screen.scrolled else []
    return picture._replace(
        rows=[written(screen.row(y)) for y in range(screen.lines)],
        cursor=[screen.cursor.x, screen.cursor.y],
        above=[written(row) for row in screen.scrollback],
        more=" ".join(more),
    )


@pytest.mark.parametrize("in_pieces", [False, True], ids=["at once", "in pieces"])
def test_every_picture_is_as_recorded(in_pieces: bool) -> None:
    wrong = [(picture, now) for picture in read() if (now := drawn(picture, in_pieces=in_pieces)) != picture]
    assert wrong == []


if __name__ == "__main__":
    pictures = [drawn(picture, in_pieces=False) for picture in read()]
    PICTURES.write_text("".join(map(line_of, pictures)), encoding="utf-8")
