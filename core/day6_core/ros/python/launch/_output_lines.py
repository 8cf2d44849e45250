"""Assembles whole lines from the pieces in which a process writes."""

from __future__ import annotations

import codecs
import os


class OutputLines:
    """The output of one stream. With `keep` all of it is kept, for `text`."""

    def __init__(self, keep: bool) -> None:
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._partial = ""
        self._kept: list[str] | None = [] if keep else None

    @property
    def text(self) -> str:
        """All of the output; empty unless it is kept."""
        return "".join(self._kept or ())

    def feed(self, data: bytes) -> list[str]:
        """Take output; returns the lines that are complete now, without their line ends."""
        text = self._decoder.decode(data)
        if self._kept is not None:
            self._kept.append(text)
        *lines, self._partial = (self._partial + text).split("\n")
        return [line[:-1] if os.name == "nt" and line.endswith("\r") else line for line in lines]

    def rest(self) -> str:
        """Return the text after the last newline; the second call returns ''."""
        rest, self._partial = self._partial, ""
        return rest
