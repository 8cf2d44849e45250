"""A line being edited and readline's commands on it: moving, deleting, killing and yanking. Independent of screen and history."""

from __future__ import annotations

import re
from collections.abc import Callable

_WORD = re.compile(r"\w+")


class EditLine:
    """Some text and a cursor in it. The last killed text is kept for the next line."""

    def __init__(self) -> None:
        self.text = ""
        self.at = 0
        """Position of the cursor, in characters."""
        self.killed = ""

    def set(self, text: str) -> None:
        """Begin with `text`, the cursor at its end."""
        self.text, self.at = text, len(text)

    @property
    def before(self) -> str:
        """The text in front of the cursor."""
        return self.text[: self.at]

    def insert(self, text: str) -> None:
        """Insert `text` at the cursor."""
        self.text = self.text[: self.at] + text + self.text[self.at :]
        self.at += len(text)

    def cut(self, start: int, end: int, *, keep: bool = True) -> None:
        """Delete the text between two positions; it can be yanked unless `keep` is off."""
        if keep and start < end:
            self.killed = self.text[start:end]
        self.text = self.text[:start] + self.text[end:]
        self.at = start

    def backspace(self) -> None:
        """Delete the character before the cursor."""
        if self.at:
            self.cut(self.at - 1, self.at, keep=False)

    def delete(self) -> None:
        """Delete the character under the cursor."""
        self.cut(self.at, min(self.at + 1, len(self.text)), keep=False)

    def home(self) -> None:
        """Go to the beginning."""
        self.at = 0

    def end(self) -> None:
        """Go to the end."""
        self.at = len(self.text)

    def left(self) -> None:
        """Go one character back."""
        self.at = max(self.at - 1, 0)

    def right(self) -> None:
        """Go one character on."""
        self.at = min(self.at + 1, len(self.text))

    def word_start(self) -> int:
        """Where the word before the cursor begins."""
        starts = [match.start() for match in _WORD.finditer(self.text) if match.start() < self.at]
        return starts[-1] if starts else 0

    def word_end(self) -> int:
        """Where the word after the cursor ends."""
        return next((match.end() for match in _WORD.finditer(self.text) if match.end() > self.at), len(self.text))

    def word_left(self) -> None:
        """Go to the beginning of the word (Alt-B)."""
        self.at = self.word_start()

    def word_right(self) -> None:
        """Go to the end of the word (Alt-F)."""
        self.at = self.word_end()

    def kill_to_end(self) -> None:
        """Ctrl-K."""
        self.cut(self.at, len(self.text))

    def kill_to_start(self) -> None:
        """Ctrl-U."""
        self.cut(0, self.at)

    def kill_word_right(self) -> None:
        """Alt-D."""
        self.cut(self.at, self.word_end())

    def kill_word_left(self) -> None:
        """Alt-Backspace: a word of letters and digits."""
        self.cut(self.word_start(), self.at)

    def kill_blank_word(self) -> None:
        """Ctrl-W: everything back to the last blank."""
        head = self.before.rstrip()
        self.cut(len(head.rpartition(" ")[0]) + (1 if " " in head else 0), self.at)

    def yank(self) -> None:
        """Ctrl-Y: insert the last killed text."""
        self.insert(self.killed)

    def transpose(self) -> None:
        """Ctrl-T: exchange the two characters around the cursor."""
        at = min(self.at, len(self.text) - 1)
        if at >= 1:
            self.text = self.text[: at - 1] + self.text[at] + self.text[at - 1] + self.text[at + 1 :]
            self.at = at + 1


KEYS: dict[str, Callable[[EditLine], None]] = {
    "\x7f": EditLine.backspace,
    "\b": EditLine.backspace,
    "\x04": EditLine.delete,
    "\x1b[3~": EditLine.delete,
    "\x01": EditLine.home,
    "\x1b[H": EditLine.home,
    "\x1bOH": EditLine.home,
    "\x1b[1~": EditLine.home,
    "\x05": EditLine.end,
    "\x1b[F": EditLine.end,
    "\x1bOF": EditLine.end,
    "\x1b[4~": EditLine.end,
    "\x02": EditLine.left,
    "\x1b[D": EditLine.left,
    "\x1bOD": EditLine.left,
    "\x06": EditLine.right,
    "\x1b[C": EditLine.right,
    "\x1bOC": EditLine.right,
    "\x1b[1;5D": EditLine.word_left,
    "\x1b[1;3D": EditLine.word_left,
    "\x1bb": EditLine.word_left,
    "\x1b[1;5C": EditLine.word_right,
    "\x1b[1;3C": EditLine.word_right,
    "\x1bf": EditLine.word_right,
    "\x0b": EditLine.kill_to_end,
    "\x15": EditLine.kill_to_start,
    "\x17": EditLine.kill_blank_word,
    "\x1bd": EditLine.kill_word_right,
    "\x1b\x7f": EditLine.kill_word_left,
    "\x19": EditLine.yank,
    "\x14": EditLine.transpose,
}
"""Key -> command on the line."""
