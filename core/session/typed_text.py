"""Text that was typed and not yet read, taken key by key, line by line or up to a mark, each in time of its own length."""

from __future__ import annotations

import re

from day6_tui.core.session.keys import key_end

END_OF_FILE = "\x04"
_PLAIN = re.compile(r"[^\x00-\x1f\x7f-\x9f]+")
_LINE_END = re.compile(r"[\r\n\x04]")


class TypedText:
    """A queue of characters. Taking n of them costs n, however many wait behind."""

    def __init__(self, text: str = "") -> None:
        self._text = text
        self._at = 0
        """Where the part of `_text` begins that was not taken."""
        self._new: list[str] = []
        """What was added since; joined when it is looked at."""
        self._size = len(text)

    def __len__(self) -> int:
        return self._size

    def add(self, text: str) -> None:
        """Put text behind the rest."""
        if text:
            self._new.append(text)
            self._size += len(text)

    def take_all(self) -> str:
        """Remove and return everything."""
        return self._take(self._look() + self._size)

    def take_key(self) -> str | None:
        """Remove and return the first key, None if there is none."""
        at = self._look()
        return self._take(key_end(self._text, at)) if self._size else None

    def take_plain(self) -> str:
        """Remove and return the characters at the front that are no keys with a meaning of their own."""
        start = self._look()
        match = _PLAIN.match(self._text, start)
        return self._take(match.end()) if match else ""

    def take_line(self) -> str | None:
        """Remove and return the first line with its newline (without, where Ctrl-D ended it); None if it is not complete."""
        start = self._look()
        match = _LINE_END.search(self._text, start)
        if match is None:
            return None
        line = self._take(match.end())[:-1]
        return line if match[0] == END_OF_FILE else line + "\n"

    def take_unfinished(self) -> str:
        """Remove and return what stands behind the last end of a line."""
        start = self._look()
        cut = max(start, *(self._text.rfind(char, start) + 1 for char in ("\n", "\r", END_OF_FILE)))
        unfinished, self._text = self._text[cut:], self._text[:cut]
        self._size -= len(unfinished)
        return unfinished

    def take_up_to(self, mark: str) -> tuple[str, bool]:
        """Remove and return what stands before `mark`, and the mark; if it has not come, what is surely no part of it."""
        start = self._look()
        found = self._text.find(mark, start)
        if found >= 0:
            text = self._take(found)
            self._take(found + len(mark))
            return text, True
        kept = next(size for size in range(len(mark), -1, -1) if self._text.endswith(mark[:size], start))
        return self._take(len(self._text) - kept), False

    def _look(self) -> int:
        """Make `_text` hold everything; returns where the rest begins in it."""
        if self._new:
            self._text = "".join([self._text[self._at :], *self._new])
            self._at = 0
            self._new = []
        return self._at

    def _take(self, end: int) -> str:
        taken = self._text[self._at : end]
        self._at = end
        self._size -= len(taken)
        if not self._size:
            self._text, self._at = "", 0
        return taken
