"""The class as a table: which rows are seen, how wide the columns are, and which of the words of a pupil have room."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from rich.segment import Segment

from day6_core.classroom.asked import Questions
from day6_core.classroom.roster import PupilRow
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit
from day6_tui.windows.classroom.words import ColouredWords, words_of

STATE_LEAST = 20
"""Cells of what is said of a pupil that are not given up for a column."""
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


def lesson_of(row: PupilRow) -> str:
    """The lesson a pupil is in, and the step."""
    lesson = row.note.lesson if row.note is not None else None
    return f"{lesson.name} {lesson.step}/{lesson.all}" if lesson is not None else ""


class Column(NamedTuple):
    """A column before what is said of a pupil; `teacher.head.<name>` stands above it."""

    name: str
    text: Callable[[PupilRow], str]
    least: int
    """Cells that are not given up for another column."""
    good: int
    """Cells in which it does not jump when somebody opens a lesson."""


COLUMNS = (Column("name", lambda row: row.name, least=12, good=12), Column("lesson", lesson_of, least=9, good=14))


def widths_for(lines: Sequence[Sequence[str]], width: int) -> list[int]:
    """As wide as the longest text of each column in these lines; where that is too much, the last one gives way first."""
    widths = [
        max(column.good, *map(cell_len, texts)) for column, texts in zip(COLUMNS, zip(*lines, strict=True), strict=True)
    ]
    over = sum(widths) + len(widths) + STATE_LEAST + MARK - width
    for at in reversed(range(len(widths))):
        given = max(0, min(over, widths[at] - COLUMNS[at].least))
        widths[at] -= given
        over -= given
    return widths


def with_room(words: Sequence[ColouredWords], room: int, look: Look) -> list[Segment]:
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

    def __init__(self, look: Look, questions: Questions, *, is_room: bool) -> None:
        self._look = look
        self._questions = questions
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
        self, rows: Sequence[PupilRow], chosen: str, width: int, height: int, now: float, *, is_frozen: bool
    ) -> list[list[Segment]]:
        """Return at most `height` lines for a class that is not empty; `now` is the roster's time."""
        room = max(1, height - 1)
        if len(rows) > room:
            room = max(1, room - 1)  # a line says how many there are above and below
        at = next((at for at, row in enumerate(rows) if row.name == chosen), 0)
        if self._reveals:
            self.top = max(at - room + 1, min(self.top, at))
        self.top, self.page = max(0, min(self.top, len(rows) - room)), room
        heads = [self._look.texts(f"teacher.head.{column.name}") for column in COLUMNS]
        widths = widths_for([heads, *([column.text(row) for column in COLUMNS] for row in rows)], width)
        lines = [self._head(heads, widths, width, is_frozen=is_frozen)]
        self.row_at = {}
        for row in rows[self.top : self.top + room]:
            self.row_at[len(lines)] = row.name
            lines.append(self._line(row, now, widths, width, is_chosen=row.name == chosen))
        if len(rows) > room:
            lines.append(self._rest(len(rows) - room - self.top, width))
        return lines

    def _head(self, heads: Sequence[str], widths: Sequence[int], width: int, *, is_frozen: bool) -> list[Segment]:
        texts, colours = self._look.texts, self._look.colours
        left = " " * MARK + "".join(f"{fit(head, cells)} " for head, cells in zip(heads, widths, strict=True))
        rest = max(0, width - cell_len(left))
        state = texts("teacher.head.frozen" if is_frozen else "teacher.head.state")
        return [Segment(left, colours.muted), Segment(fit(state, rest), colours.hint if is_frozen else colours.muted)]

    def _line(self, row: PupilRow, now: float, widths: Sequence[int], width: int, *, is_chosen: bool) -> list[Segment]:
        look, colours, ellipsis = self._look, self._look.colours, self._look.glyphs.ellipsis
        base = colours.choice if is_chosen else colours.text if row.is_here else colours.muted
        left = fit(look.glyphs.chevron if is_chosen else "", MARK)
        left += "".join(f"{fit(each.text(row), cells, ellipsis)} " for each, cells in zip(COLUMNS, widths, strict=True))
        words = list(words_of(row, now, look, is_room=self._is_room, asked=self._questions.latest(row.name)))
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
