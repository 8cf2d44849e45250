"""Typed text that has not been read yet, taken key by key, line by line or up to a marker, in time linear in the part taken."""

from __future__ import annotations

import re

from day6_core.session.keys import key_end

END_OF_FILE = "\x04"
_PLAIN = re.compile(r"[^\x00-\x1f\x7f-\x9f]+")
_LINE_END = re.compile(r"[\r\n\x04]")


class TypedText:
    """A queue of characters. Taking n of them takes O(n), however many are left."""

    def __init__(self, text: str = "") -> None:
        self._text = text
        self._at = 0
        """Index in `_text` of the first character that was not taken."""
        self._new: list[str] = []
        """Texts added since; joined before the next reading."""
        self._size = len(text)

    def __len__(self) -> int:
        return self._size

    def add(self, text: str) -> None:
        """Append text."""
        if text:
            self._new.append(text)
            self._size += len(text)

    def take_all(self) -> str:
        """Remove and return everything."""
        return self._take(self._merge() + self._size)

    def take_key(self) -> str | None:
        """Remove and return the first key, None if there is none."""
        at = self._merge()
        return self._take(key_end(self._text, at)) if self._size else None

    def take_plain(self) -> str:
        """Remove and return the printable characters at the front."""
        start = self._merge()
        match = _PLAIN.match(self._text, start)
        return self._take(match.end()) if match else ""

    def take_line(self) -> str | None:
        """Remove and return the first line with its newline (without one if Ctrl-D ended it); None if it is not complete."""
        start = self._merge()
        match = _LINE_END.search(self._text, start)
        if match is None:
            return None
        line = self._take(match.end())[:-1]
        return line if match[0] == END_OF_FILE else line + "\n"

    def take_unfinished(self) -> str:
        """Remove and return the text after the last end of a line."""
        start = self._merge()
        cut = max(start, *(self._text.rfind(char, start) + 1 for char in ("\n", "\r", END_OF_FILE)))
        unfinished, self._text = self._text[cut:], self._text[:cut]
        self._size -= len(unfinished)
        return unfinished

    def take_up_to(self, mark: str) -> tuple[str, bool]:
        """Remove the text up to and including `mark`; return the text before it and whether the mark was there.

        Without the mark, a possible beginning of it at the end stays in the queue.
        """
        start = self._merge()
        found = self._text.find(mark, start)
        if found >= 0:
            text = self._take(found)
            self._take(found + len(mark))
            return text, True
        kept = next(size for size in range(len(mark), -1, -1) if self._text.endswith(mark[:size], start))
        return self._take(len(self._text) - kept), False

    def _merge(self) -> int:
        """Join everything into `_text`; return the index where the rest begins in it."""
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
