"""The layout of a line being edited: the cell of each character, and which part of a long line is shown."""

from __future__ import annotations

from typing import NamedTuple

from day6_core.width import char_width


class Layout(NamedTuple):
    """A text laid out in rows, which are counted from the one with its first character."""

    starts: list[int]
    """Index of the first character of each row."""
    row: int
    """Of the cursor."""
    column: int
    end_column: int
    """The position after the text; the row is the last one."""


class ShownLine(NamedTuple):
    """What stands on the screen of a line being edited: the prompt without colours, the text, the cursor's place in it."""

    prompt: str = ""
    text: str = ""
    at: int = 0

    def row(self, columns: int) -> int:
        """The row of the cursor, counted from the first one, in a window of that width."""
        above = lay_out(self.prompt, len(self.prompt), columns)
        return above.row + lay_out(self.text, self.at, columns, indent=above.column).row

    def longer(self, text: str) -> ShownLine:
        """What is shown after a text was typed at its end."""
        return ShownLine(self.prompt, self.text + text, self.at + len(text))


def shown_char(char: str) -> str:
    """A character as it is drawn in the line: control characters as ^X, a newline of a pasted text as itself."""
    return char if char >= " " or char == "\n" else "^" + chr(ord(char) + 64)


def shown(text: str) -> str:
    """A text as it is drawn in the line."""
    return text if text.isprintable() else "".join(map(shown_char, text))


def near(text: str, at: int, rows: int) -> tuple[int, int]:
    """Return the start and end of the visible part of `text` for a cursor `at`: whole lines, `rows` on both sides."""
    start, end = at, at
    for _ in range(rows + 1):
        start = text.rfind("\n", 0, max(start, 0))
    for _ in range(rows + 1):
        found = text.find("\n", end)
        end = len(text) if found < 0 else found + 1
    return start + 1, end


def lay_out(text: str, at: int, columns: int, *, indent: int = 0) -> Layout:
    """Lay out `text`, its first character in column `indent`, with the cursor before the character `at`."""
    starts, row, column = [0], 0, indent
    place = (0, indent) if at == 0 else None
    begin = 0
    while True:
        newline = text.find("\n", begin)
        end = len(text) if newline < 0 else newline
        line = text[begin:end]
        if line.isascii() and line.isprintable():
            in_first = columns - column
            starts.extend(range(begin + in_first, end + 1, columns))
            cells = column + len(line)
            if place is None and at <= end:
                place = (row + (column + at - begin) // columns, (column + at - begin) % columns)
            row, column = row + cells // columns, cells % columns
        else:
            for index in range(begin, end):
                char = text[index]
                control = char < " "
                width = 2 if control else char_width(char)
                if column + width > columns and not control:
                    row, column = row + 1, 0
                    starts.append(index)
                if place is None and index >= at:
                    place = (row, column)
                column += width
                if column >= columns:  # the two characters of a control character may be in different rows
                    row, column = row + 1, column - columns
                    starts.append(index + 1)
            if place is None and at <= end:
                place = (row, column)
        if newline < 0:
            break
        if end > begin and column == 0 and starts[-1] == end:
            starts[-1] = (
                newline + 1
            )  # the line filled its row: a terminal that has not wrapped yet just goes to the next one
        else:
            row, column = row + 1, 0
            starts.append(newline + 1)
        begin = newline + 1
    assert place is not None
    return Layout(starts, *place, column)
