"""Parses what a program writes to a terminal: text, control characters and escape sequences, as xterm reads them.

The states are those of a VT500 (https://vt100.net/emu/dec_ansi_parser), which xterm follows: CAN and SUB end any sequence,
ESC begins a new one, control characters inside a sequence are obeyed at once, and a string (OSC, DCS, APC) goes on until ST.
A text may be cut anywhere; what is kept of an unfinished sequence is bounded.
"""

from __future__ import annotations

import re
from time import perf_counter
from typing import Protocol

MOST_PARAMETERS = 32
"""xterm keeps 30 parameters of a sequence."""

LARGEST_PARAMETER = 9999

LONGEST_SEQUENCE = 512
"""Characters of the parameters of one sequence; a longer one is read to its end and ignored."""

LONGEST_STRING = 1024
"""Characters kept of a string such as a title."""

NEVER = float("inf")

_TOKEN = re.compile(
    r"([^\x00-\x1f\x7f-\x9f]+)"  # 1: text
    r"|(\r\n|[\x08-\x0d\x84\x85\x88\x8d])"  # 2: a control character that does something
    r"|\x1b\[([0-9;]*)m"  # 3: colours
    r"|(?:\x1b\[|\x9b)([0-?]*)([ -/]*)([@-~])"  # 4, 5, 6: any other control sequence
    r"|([\x00-\x07\x0e-\x1a\x1c-\x1f\x7f-\x83\x86\x87\x89-\x8c\x8e\x8f\x91-\x97\x99\x9a\x9c])"  # 7: nothing happens
)
_PARAMETERS = re.compile(r"[0-?]*[ -/]*")
_IGNORED = re.compile(r"[ -?\x7f]*")
_PARTS_OF_ESCAPE = re.compile(r"[ -/]*")
_NOT_IN_A_STRING = re.compile(r"[\x18\x1a\x1b\x9c]")
_NOT_IN_AN_OSC = re.compile(r"[\x07\x18\x1a\x1b\x9c]")
_NOT_IN_A_MESSAGE = re.compile(r"[\r\n\x18\x1a\x1b\x9c]")
"""PM and SOS, unlike xterm's, end with their line. At Ctrl-C a kernel throws away what waits, maybe from the middle of a sequence
on, and echoes ^C: ESC ^ C would hide all that comes until the next sequence, a traceback for instance."""

_STRINGS = {
    "]": "]",
    "\x9d": "]",
    "P": "P",
    "\x90": "P",
    "X": "X",
    "\x98": "X",
    "^": "^",
    "\x9e": "^",
    "_": "_",
    "\x9f": "_",
}
"""What begins a string: OSC, DCS, SOS, PM, APC."""

_PATTERNS = {"]": _NOT_IN_AN_OSC, "X": _NOT_IN_A_MESSAGE, "^": _NOT_IN_A_MESSAGE}
"""What may end it."""


class Listener(Protocol):
    """Receives what a parser has read."""

    def draw(self, data: str) -> None:
        """Characters to be shown."""

    def control(self, char: str) -> None:
        r"""A control character that moves the cursor, or '\r\n'."""

    def colour(self, parameters: str) -> None:
        """The parameters of SGR as they were written."""

    def sequence(self, private: str, parameters: list[int], final: str) -> None:
        """A control sequence (CSI) without intermediate characters; `private` is '', '?', '>', '<' or '='."""

    def escape(self, parts: str, final: str) -> None:
        """An escape sequence such as ESC 7 or ESC # 8."""

    def set_title(self, param: str) -> None:
        """OSC 0 and 2."""

    def rush(self, text: str, start: int) -> int:
        """Asked between sequences: take as much as can be taken at once; returns where it stopped."""


class SequenceParser:
    """Parses what a program writes, and calls its listener. Never raises for any text; takes time linear in its length."""

    def __init__(self, listener: Listener) -> None:
        self._listener = listener
        self._rest = ""
        """The beginning of a sequence whose end has not come yet."""
        self._ignoring = False
        """Inside a control sequence that is not understood."""
        self._string = ""
        """Inside a string: what began it."""
        self._kept: list[str] = []
        self._kept_size = 0

    def feed(self, text: str, until: float = NEVER) -> str:
        """Read a text, or as much of it as there is time for until `until` (perf_counter); returns the rest."""
        text, self._rest = self._rest + text, ""
        at, end = 0, len(text)
        while at < end:
            if self._string:
                at = self._read_string(text, at)
            elif self._ignoring:
                at = self._ignore(text, at)
            elif (after := self._listener.rush(text, at)) > at:
                at = after
            else:
                at = self._read_tokens(text, at, until)
            if perf_counter() > until:
                break
        return text[at:]

    def _read_tokens(self, text: str, at: int, until: float) -> int:
        """Read text and whole sequences; stops at the end of a line, after what needs more care, or when the time is over."""
        listener = self._listener
        draw, colour, control = listener.draw, listener.colour, listener.control
        match = _TOKEN.match
        while token := match(text, at):
            at = token.end()
            kind = token.lastindex
            if kind == 1:
                draw(token[1])
            elif kind == 2:
                control(token[2])
                if token[2] == "\r\n":
                    return at
            elif kind == 3:
                colour(token[3])
            elif kind == 6:
                self._dispatch(token[4], token[5], token[6])
            else:
                continue
            if kind != 3 and perf_counter() > until:
                return at
        if at < len(text):
            return self._read_odd(text, at)
        return at

    def _read_odd(self, text: str, at: int) -> int:
        """A sequence that is unfinished, mixed with control characters, or not a control sequence."""
        char = text[at]
        if char in _STRINGS:
            return self._begin_string(char, at + 1)
        if char == "\x9b":
            return self._read_sequence(text, at + 1, "")
        at += 1  # ESC
        parts = ""
        while at < len(text):
            found = _PARTS_OF_ESCAPE.match(text, at)
            assert found is not None
            parts = (parts + found[0])[:2]
            at = found.end()
            if at == len(text):
                break
            char = text[at]
            if not parts and char == "[":
                return self._read_sequence(text, at + 1, "")
            if not parts and char in _STRINGS and char < "\x80":
                return self._begin_string(char, at + 1)
            if "0" <= char <= "~":
                self._listener.escape(parts, char)
                return at + 1
            if not self._obey_inside(char):
                return at + (char in "\x18\x1a")
            at += 1
        self._rest = "\x1b" + parts
        return at

    def _read_sequence(self, text: str, at: int, read: str) -> int:
        """The rest of a control sequence, of which `read` is known."""
        while True:
            found = _PARAMETERS.match(text, at)
            assert found is not None
            at = found.end()
            read += found[0]
            if len(read) > LONGEST_SEQUENCE:
                self._ignoring = True
                return at
            if at == len(text):
                self._rest = "\x1b[" + read
                return at
            char = text[at]
            if "@" <= char <= "~":
                parameters = read.rstrip(" !\"#$%&'()*+,-./")
                self._dispatch(parameters, read[len(parameters) :], char)
                return at + 1
            if " " <= char <= "?":
                self._ignoring = True  # a parameter after what ends the parameters
                return at
            if not self._obey_inside(char):
                return at + (char in "\x18\x1a")
            at += 1

    def _obey_inside(self, char: str) -> bool:
        """A character that does not belong into a sequence; False if it ends it."""
        if char in "\x18\x1a\x1b" or char >= "\x80":
            return False
        if "\x08" <= char <= "\x0d":
            self._listener.control(char)
        return True

    def _ignore(self, text: str, at: int) -> int:
        while at < len(text):
            found = _IGNORED.match(text, at)
            assert found is not None
            at = found.end()
            if at == len(text):
                break
            char = text[at]
            if "@" <= char <= "~":
                self._ignoring = False
                return at + 1
            if not self._obey_inside(char):
                self._ignoring = False
                return at + (char in "\x18\x1a")
            at += 1
        return at

    def _dispatch(self, parameters: str, parts: str, final: str) -> None:
        if parts or len(parameters) > LONGEST_SEQUENCE:
            return
        private = ""
        if parameters[:1] in ("?", ">", "<", "="):
            private, parameters = parameters[0], parameters[1:]
        if final == "m" and not private:
            self._listener.colour(parameters)
            return
        numbers = [_number(one) for one in parameters.split(";", MOST_PARAMETERS)[:MOST_PARAMETERS]]
        self._listener.sequence(private, numbers, final)

    # -- strings -------------------------------------------------------------------------------------------------------

    def _begin_string(self, char: str, at: int) -> int:
        self._string = _STRINGS[char]
        self._kept.clear()
        self._kept_size = 0
        return at

    def _read_string(self, text: str, at: int) -> int:
        pattern = _PATTERNS.get(self._string, _NOT_IN_A_STRING)
        found = pattern.search(text, at)
        stop = len(text) if found is None else found.start()
        if self._string == "]" and self._kept_size < LONGEST_STRING:
            self._kept.append(text[at : min(stop, at + LONGEST_STRING - self._kept_size)])
            self._kept_size += stop - at
        if found is None:
            return stop
        if text[stop] == "\x1b":
            if stop + 1 == len(text):
                self._rest = "\x1b"  # may be the first half of ST
                return stop + 1
            if text[stop + 1] != "\\":
                self._string = ""  # another sequence begins
                return stop
            stop += 1
        elif text[stop] in "\r\n":
            self._string = ""
            return stop
        elif text[stop] in "\x18\x1a":
            self._string = ""
            return stop + 1
        self._finish_string()
        return stop + 1

    def _finish_string(self) -> None:
        kind, self._string = self._string, ""
        code, _, title = "".join(self._kept).partition(";")
        self._kept.clear()
        if kind == "]" and code in ("0", "2"):
            self._listener.set_title(title)


def _number(text: str) -> int:
    """A parameter; 0 if it is empty or no plain number."""
    if len(text) > 9:
        return LARGEST_PARAMETER
    return min(int(text), LARGEST_PARAMETER) if text.isdigit() else 0


def colour_numbers(parameters: str) -> list[int]:
    """The parameters of SGR as numbers. Groups with colons (ITU T.416: 4:3, 38:2::1:2:3) become what the older way says."""
    if ":" not in parameters:
        return [min(_number(one), 255) for one in parameters.split(";", MOST_PARAMETERS)[:MOST_PARAMETERS]]
    numbers: list[int] = []
    for group in parameters.split(";", MOST_PARAMETERS)[:MOST_PARAMETERS]:
        first, *others = [min(_number(one), 255) for one in group.split(":", 8)[:8]]
        if first in (38, 48) and others[:1] == [2] and len(others) >= 4:
            numbers += [first, 2, *(others[2:5] if len(others) >= 5 else others[1:4])]
        elif first in (38, 48) and others[:1] == [5] and len(others) >= 2:
            numbers += [first, 5, others[1]]
        elif first == 4 and others[:1] == [0]:
            numbers.append(24)
        elif first not in (38, 48):
            numbers.append(first)
    return numbers
