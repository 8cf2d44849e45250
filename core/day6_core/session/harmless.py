"""Makes text from outside harmless for a terminal: a file's name, a log line, a robot's joint may contain any character.

Characters that control a terminal, change the direction of a line or are no characters at all are escaped as `cat -v` and
Python's `repr` do: `^[` for ESC, `\\x9b` for a C1 control, `\\u202e` for a reversal. What people write stays as it is,
including joined emoji, Persian and Indic joiners, combining marks and the private use areas that fonts keep their icons in.
"""

from __future__ import annotations

import codecs
import contextlib
import os
import re
import sys
from collections.abc import Mapping
from typing import Any, Protocol, TextIO
from unicodedata import category

_CONTROLS = "\x00-\x1f\x7f-\x9f"
_UNSEEN_BELOW = (
    "\xad\u034f\u061c\u17b4\u17b5\u180e"  # no width, or a soft hyphen
    "\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f"  # directions, lines, invisible operators
    "\ufeff\ufff9-\ufffb"
)
"""Below U+10000."""
_UNSEEN = _UNSEEN_BELOW + (
    "\U0001bca0-\U0001bca3\U0001d173-\U0001d17a"
    "\U000e0000-\U000e00ff\U000e01f0-\U000e0fff"  # tags: a second, invisible text
)
_NO_CHARACTERS_BELOW = "\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff"
_NO_CHARACTERS = _NO_CHARACTERS_BELOW + "".join(
    chr(plane << 16 | 0xFFFE) + chr(plane << 16 | 0xFFFF) for plane in range(1, 16)
)
_LAST_PLANE = "\U00100000-\U0010ffff"
"""A private use area like two others; U+10EEEE in it is the placeholder of a picture in some terminals."""

_HARMFUL = re.compile(f"[{_CONTROLS}{_UNSEEN}{_NO_CHARACTERS}{_LAST_PLANE}]")
_STRANGE = re.compile(f"[{_UNSEEN}{_NO_CHARACTERS}{_LAST_PLANE}]")
_PERHAPS_STRANGE = re.compile(f"[{_UNSEEN_BELOW}{_NO_CHARACTERS_BELOW}\U00010000-\U0010ffff]")
"""Looks at a character in a tenth of the time: a regular expression compares with every range above U+FFFF."""
_IGNORED = bytes(set(range(0x20)) - set(b"\a\b\t\n\v\f\r\x18\x1a\x1b")) + b"\x7f"
"""Control characters that mean nothing to a terminal, wherever they stand."""
_IN_A_STREAM = re.compile(
    r"\x1b\[[0-9;:]{0,64}m|\r\n|[\n\t]|" + f"([{_CONTROLS}{_UNSEEN}{_NO_CHARACTERS}{_LAST_PLANE}])",
)
"""Colours, newlines and tabs pass; the group matches everything that does not."""


_COLOUR = re.compile(r"\x1b\[[0-9;:]{0,64}m")


class Output(Protocol):
    """Anything that knows whether it is a terminal."""

    def isatty(self) -> bool:
        """Return whether it is a terminal."""


def one_line(text: str) -> str:
    """Return `text` as one line of cells: every control character is escaped, including newline and tab."""
    return text if text.isprintable() else _HARMFUL.sub(_written, text)


def in_a_list(name: str, output: Output) -> str:
    """Return `name` as an entry of a list: one line on a terminal, so that it cannot look like several entries."""
    return one_line(name) if output.isatty() else name


def lines(text: str) -> str:
    """Return `text` as lines for a terminal: newlines, tabs and colours stay, everything else as in `one_line`."""
    return (
        text if text.isprintable() else _IN_A_STREAM.sub(lambda found: _written(found) if found[1] else found[0], text)
    )


def quotable(text: str) -> str:
    """Return `text` escaped for a quoted string of graphviz: it ends neither the quotes nor the line."""
    return one_line(text).replace("\\", "\\\\").replace('"', '\\"')


def same_length(text: str, *, pictures: bool) -> str:
    """Return `text` with one cell for every harmful character but tabs, for texts in which positions are counted in characters.

    With `pictures` a control character becomes its Unicode control picture, otherwise a question mark.
    """
    return text if text.isprintable() else _HARMFUL.sub(_picture if pictures else _question, text)


def for_emulation(text: str) -> str:
    """Return `text` with the control characters that a VT emulation understands.

    Those that mean nothing to it, and other harmful characters without width, are left out; the rest of them become U+FFFD.
    """
    if not text.isascii():
        text = _PERHAPS_STRANGE.sub(_stand_in, text)
    data = text.encode()
    read = data.translate(None, _IGNORED)
    return text if len(read) == len(data) else read.decode()


def _picture(found: re.Match[str]) -> str:
    code = ord(found[0])
    if code == 0x09:
        return "\t"
    return chr(0x2400 + code) if code < 0x20 else "\u2421" if code == 0x7F else "\ufffd"


def _question(found: re.Match[str]) -> str:
    return "\t" if found[0] == "\t" else "?"


def _stand_in(found: re.Match[str]) -> str:
    char = found[0]
    if not _STRANGE.match(char):
        return char
    return "" if category(char) in ("Cf", "Mn") else "\ufffd"


def _written(found: re.Match[str]) -> str:
    code = ord(found[0])
    if code < 0x20 or code == 0x7F:
        return "^" + chr(code ^ 0x40)
    if 0xDC80 <= code <= 0xDCFF:  # a byte that is not UTF-8, as Python decodes it (surrogateescape)
        code -= 0xDC00
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


KEEP_BYTES = "day6_keep_bytes"
"""Error handler for pipes and files: a byte that was not UTF-8 is written unchanged; anything else unencodable becomes '?'."""


def _encode_badly(error: UnicodeError) -> tuple[bytes, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    codes = map(ord, error.object[error.start : error.end])
    return bytes(code - 0xDC00 if 0xDC80 <= code <= 0xDCFF else 0x3F for code in codes), error.end


codecs.register_error(KEEP_BYTES, _encode_badly)


def has_colours(environ: Mapping[str, str]) -> bool:
    """Whether the terminal of these variables understands colours at all."""
    return environ.get("TERM") != "dumb"


class TerminalText:
    """A text file that is a terminal: `write` makes its text harmless, `control` is for our own escape sequences.

    Without `colours`, those of both are left out.
    """

    def __init__(self, file: TextIO, *, colours: bool = True) -> None:
        self._file = file
        self._colours = colours

    def write(self, text: str) -> int:
        """Write text from any source; returns its length."""
        self._file.write(lines(self._shown(text)))
        return len(text)

    def control(self, sequence: str) -> None:
        """Write an escape sequence unchanged; never pass text from outside."""
        self._file.write(self._shown(sequence))

    def _shown(self, text: str) -> str:
        return text if self._colours else _COLOUR.sub("", text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)


def guarded(file: TextIO) -> TextIO:
    """Return `file` wrapped for output: a terminal gets no harmful text, pipes and files get every byte."""
    if isinstance(file, TerminalText):
        return file
    terminal = file.isatty()
    with contextlib.suppress(AttributeError, ValueError):  # a test's capture
        file.reconfigure(errors="replace" if terminal else KEEP_BYTES, line_buffering=True)  # type: ignore[attr-defined]
    return TerminalText(file, colours=has_colours(os.environ)) if terminal else file  # type: ignore[return-value]


def guard_standard_streams() -> None:
    """Use `guarded` for everything this process prints, including messages of argparse and of Python itself."""
    for name in ("stdout", "stderr"):
        file = getattr(sys, name)
        if file is not None:
            setattr(sys, name, guarded(file))
