"""The class as a table: which rows are seen, how wide the columns are, and which of the words of a pupil have room."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from rich.segment import Segment

from day6_core.classroom.roster import Row
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit
from day6_tui.windows.classroom.words import Words, words_of

NAME_LEAST, LESSON_LEAST, STATE_LEAST = 12, 9, 20
"""Cells of the columns that are not given up for another one."""
LESSON_GOOD = 14
"""Cells of a column that does not jump when somebody opens a lesson."""
MARK = 2
"""Cells before the name, for the mark of the chosen row."""
CUT_LEAST = 10
"""Cells in which the beginning of some words still says something."""
TABLE_ROWS = 4
"""Lines that the table keeps beside a preview or what is told below it."""
PREVIEW_ROWS = 8
"""Lines that a screen below the table needs at least, with the line between."""


class Places(NamedTuple):
    """Lines of the table, of a screen below it (0: there is none), and of what is told at the lower end."""

    table: int
    preview: int
    told: int


def places_for(rows: int, told: int, height: int, *, preview: bool) -> Places:
    """Share `height` lines: the table comes first, then a preview that is wanted and has room, then what is told."""
    wanted = rows + 1
    least = min(TABLE_ROWS, wanted)
    if preview and height - least >= PREVIEW_ROWS:
        told = min(told, height - least - PREVIEW_ROWS)
        table = min(wanted, max(least, (height - told) // 2), height - told - PREVIEW_ROWS)
        return Places(table, height - told - table, told)
    told = max(0, min(told, height - least))
    return Places(min(wanted, height - told), 0, told)


class Columns(NamedTuple):
    """Cells of the columns; the last has what is left."""

    name: int
    lesson: int


def columns_for(names: Iterable[str], lessons: Iterable[str], width: int) -> Columns:
    """As wide as the longest name and lesson; where that is too much, the lesson gives way first, then the name."""
    name = max(NAME_LEAST, *map(cell_len, names))
    lesson = max(LESSON_GOOD, *map(cell_len, lessons))
    over = name + lesson + STATE_LEAST + MARK + 2 - width
    given = max(0, min(over, lesson - LESSON_LEAST))
    return Columns(name - max(0, min(over - given, name - NAME_LEAST)), lesson - given)


def with_room(words: Sequence[Words], room: int, look: Look) -> list[Segment]:
    """Exactly `room` cells with the words that fit, two blanks apart; in their short form where not all long ones do."""
    is_short = sum(cell_len(each.text) + 2 for each in words) - 2 > room
    segments: list[Segment] = []
    for each in words:
        gap = 2 if segments else 0
        text = (is_short and each.short) or each.text
        if segments and room - gap < min(CUT_LEAST, cell_len(text)):
            break
        segments += [
            Segment(" " * gap, look.colours.text),
            Segment(clip(text, room - gap, look.glyphs.ellipsis), each.style),
        ]
        room -= gap + cell_len(segments[-1].text)
    return [*segments, Segment(" " * room, look.colours.text)]


class ClassTable:
    """Draws the rows from `top` on."""

    def __init__(self, look: Look, *, is_room: bool) -> None:
        self._look = look
        self._is_room = is_room
        self.top = 0
        self.page = 1
        """Rows that were seen."""
        self.row_at: dict[int, str] = {}
        """Whose row stands in a line."""
        self._reveals = True
        """Whether the chosen row has to be seen."""

    @property
    def position(self) -> tuple[int, bool]:
        """What changes where it is scrolled; draw it anew then."""
        return self.top, self._reveals

    def reveal(self) -> None:
        """Have the chosen row in sight again."""
        self._reveals = True

    def scroll(self, rows: int) -> None:
        """Look further up or down; the choice stays."""
        self.top, self._reveals = max(0, self.top + rows), False

    def draw(
        self, rows: Sequence[Row], chosen: str, width: int, height: int, now: float, *, is_frozen: bool
    ) -> list[list[Segment]]:
        """Return at most `height` lines for a class that is not empty; `now` is the roster's time."""
        room = max(1, height - 1)
        if len(rows) > room:
            room = max(1, room - 1)  # a line says how many there are above and below
        at = next((at for at, row in enumerate(rows) if row.name == chosen), 0)
        if self._reveals:
            self.top = max(at - room + 1, min(self.top, at))
        self.top, self.page = max(0, min(self.top, len(rows) - room)), room
        texts = self._look.texts
        lessons = [lesson_of(row) for row in rows]
        columns = columns_for(
            [texts("teacher.head.name"), *(row.name for row in rows)], [texts("teacher.head.lesson"), *lessons], width
        )
        lines = [self._head(columns, width, is_frozen=is_frozen)]
        self.row_at = {}
        for row in rows[self.top : self.top + room]:
            self.row_at[len(lines)] = row.name
            lines.append(self._line(row, now, columns, width, is_chosen=row.name == chosen))
        if len(rows) > room:
            lines.append(self._rest(len(rows) - room - self.top, width))
        return lines

    def _head(self, columns: Columns, width: int, *, is_frozen: bool) -> list[Segment]:
        texts, colours = self._look.texts, self._look.colours
        left = f"{' ' * MARK}{fit(texts('teacher.head.name'), columns.name)} "
        left += f"{fit(texts('teacher.head.lesson'), columns.lesson)} "
        rest = max(0, width - cell_len(left))
        state = texts("teacher.head.frozen" if is_frozen else "teacher.head.state")
        return [Segment(left, colours.muted), Segment(fit(state, rest), colours.hint if is_frozen else colours.muted)]

    def _line(self, row: Row, now: float, columns: Columns, width: int, *, is_chosen: bool) -> list[Segment]:
        look, colours, ellipsis = self._look, self._look.colours, self._look.glyphs.ellipsis
        base = colours.choice if is_chosen else colours.text if row.is_here else colours.muted
        name, lesson = fit(row.name, columns.name, ellipsis), fit(lesson_of(row), columns.lesson, ellipsis)
        left = f"{fit(look.glyphs.chevron if is_chosen else '', MARK)}{name} {lesson} "
        words = list(words_of(row, now, look, is_room=self._is_room))
        return [Segment(left, base), *with_room(words, max(0, width - cell_len(left)), look)]

    def _rest(self, below: int, width: int) -> list[Segment]:
        """How many rows there are above and below those that are seen."""
        text = "   ".join(self._more(below))
        return [Segment(fit(f"{' ' * MARK}{text}", width), self._look.colours.hint)]

    def _more(self, below: int) -> Iterator[str]:
        if self.top:
            yield self._look.texts("teacher.above", count=self.top)
        if below:
            yield self._look.texts("teacher.below", count=below)


def lesson_of(row: Row) -> str:
    """The lesson a pupil is in, and the step."""
    lesson = row.note.lesson if row.note is not None else None
    return f"{lesson.name} {lesson.step}/{lesson.all}" if lesson is not None else ""
