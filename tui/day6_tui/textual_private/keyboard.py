"""Turns what a real terminal sends into events; no byte sequence can end the desktop.

Textual's own reader fails on a byte that is not UTF-8, on a key report whose number isn't a character and on a mouse report
for a window without a size; and it processes a paste character by character.
"""

from __future__ import annotations

import codecs
import logging
import re
from collections.abc import Iterable
from typing import cast

from textual import constants, events
from textual._ansi_sequences import ANSI_SEQUENCES_KEYS
from textual._parser import ParseTimeout
from textual._time import get_time
from textual._xterm_parser import BRACKETED_PASTE_END, BRACKETED_PASTE_START, XTermParser
from textual.driver import Driver
from textual.message import Message

from day6_tui.pixels import ask

LARGEST_WINDOW = 4096
"""More columns or rows than this in a report of the terminal are nonsense."""

SILENCE = 1.0
"""Seconds without a byte after which a paste without an end mark is delivered, and a single key is a key again."""

_log = logging.getLogger(__name__)
_ENDLESS = re.compile(r"\x1b\[[0-?]{32,}")
"""Longer than any control sequence; Textual would type it as text."""

_REST_OF_IT = re.compile(r"[0-?]*[ -/]*[@-~]?")
_ALT_KEY = re.compile(r"\x1b[^\x00-\x20\x7fNOPX\[\\\]^_]")
"""Alt and a character that begins no longer sequence."""

_HIGH = re.compile(rb"[\x80-\xff]+")


for _key in "1234567890-=":
    # Textual types what macOS's keyboard has there (£ for Alt+3), also where Alt is Alt; here these keys go to panes.
    cast("dict[str, object]", ANSI_SEQUENCES_KEYS).pop(f"\x1b{_key}", None)


def sturdy(driver: type[Driver]) -> type[Driver]:
    """Return the driver that survives bad input, in place of Textual's own on Linux and macOS."""
    if driver.__name__ != "LinuxDriver":
        return driver
    from day6_tui.textual_private.driver import TerminalDriver

    return TerminalDriver


class InputDecoder:
    """Decodes a terminal's bytes across reads; what is not UTF-8 becomes U+FFFD."""

    def __init__(self) -> None:
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self.fault = ""
        """What was not UTF-8 in the last text: 'gbk' if it looks like Chinese in that encoding, 'other', or ''."""

    def decode(self, data: bytes) -> str:
        """Return the text that is complete so far."""
        pending = self._decoder.getstate()[0]
        text = self._decoder.decode(data)
        self.fault = _fault(pending + data) if "\ufffd" in text else ""
        return text


def _fault(data: bytes) -> str:
    """Classify the runs of non-ASCII bytes: pairs that are common Chinese characters are hardly anything else."""
    fault = ""
    for run in _HIGH.findall(data):
        try:
            run.decode("utf-8")
        except UnicodeDecodeError:
            fault = fault or "other"
            if len(run) % 2 == 0 and all(0xB0 <= byte <= 0xF7 for byte in run[::2]) and _is(run, "gbk"):
                fault = "gbk"
    return fault


def _is(data: bytes, encoding: str) -> bool:
    try:
        return any("\u4e00" <= char <= "\u9fff" for char in data.decode(encoding))
    except UnicodeDecodeError:
        return False


class KeyboardParser(XTermParser):
    """Textual's parser, made to survive nonsense and to take a paste in one piece."""

    def __init__(self, debug: bool = False) -> None:
        super().__init__(debug)
        self._paste: list[str] | None = None
        """The parts of the paste that has begun."""
        self._held = ""
        """The end of the input so far, while it may be the beginning of a mark."""
        self._fed = 0.0
        """When the last input arrived."""
        self._in_endless = False
        """Whether the input continues an overlong control sequence."""

    def feed(self, data: str) -> Iterable[Message]:
        """Yield the events in `data`. '' is the end of the input."""
        if not data:
            yield from super().feed(data)
            return
        silent = get_time() - self._fed > SILENCE
        self._fed = get_time()
        if self._paste is not None and silent and len(data) == 1 and data < " ":
            yield from self._end_paste()  # a key in a paste whose end was lost
        data, self._held = self._held + data, ""
        while data:
            mark = BRACKETED_PASTE_START if self._paste is None else BRACKETED_PASTE_END
            before, found, rest = data.partition(mark)
            if not found:
                before, self._held = _without_beginning_of(mark, before)
            if not found and self._paste is None:
                whole = before + self._held
                end = min(len(before), ask.beginning(whole))
                before, self._held = whole[:end], whole[end:]
            if self._paste is not None:
                self._paste.append(before)
                if found:
                    yield from self._end_paste()
            else:
                for answer in ask.ANSWER.findall(before):
                    yield ask.Answered(answer)
                before = self._without_endless(ask.ANSWER.sub("", before))
                if before:
                    yield from super().feed(before)
                if found:
                    yield from self._finish_key()
                    self._paste = []
            data = rest

    def _without_endless(self, text: str) -> str:
        kept = []
        while text:
            if self._in_endless:
                rest = _REST_OF_IT.match(text)
                end = rest.end() if rest else 0
                self._in_endless = end == len(text) and not "@" <= text[-1] <= "~"
                text = text[end:]
                continue
            begin = _ENDLESS.search(text)
            if begin is None:
                kept.append(text)
                break
            kept.append(text[: begin.start()])
            text = text[begin.end() :]
            self._in_endless = True
        return "".join(kept)

    def tick(self) -> Iterable[Message]:
        """Yield the events that a pause in the input decides."""
        waited = get_time() - self._fed
        if self._paste is not None:
            if self._paste and waited > SILENCE:
                parts, self._paste = self._paste, []
                yield events.Paste("".join(parts).replace("\x00", ""))
            return
        if ask.is_certain(self._held):
            if waited > SILENCE:
                self._held = ""  # the rest of an answer was lost, and it is not a key
        elif self._held and waited > constants.ESCAPE_DELAY:
            held, self._held = self._held, ""
            yield from super().feed(held)
            yield from self._finish_key()
        yield from super().tick()

    def _end_paste(self) -> Iterable[Message]:
        parts, self._paste = self._paste or [], None
        if parts:
            yield events.Paste("".join(parts).replace("\x00", ""))

    def _finish_key(self) -> Iterable[Message]:
        """Nothing more belongs to the key that was being read."""
        if self._timeout_time is not None:
            self._timeout_time = None
            self._awaiting = self._gen.throw(ParseTimeout())
        while self._tokens:
            yield self._tokens.popleft()

    def parse_mouse_code(self, code: str) -> Message | None:
        try:
            event = super().parse_mouse_code(code)
        except (ValueError, OverflowError, ZeroDivisionError):
            return None
        inside = isinstance(event, events.MouseEvent) and max(event.x, event.y) <= LARGEST_WINDOW
        return event if inside else None

    def _sequence_to_key_events(self, sequence: str, alt: bool = False) -> Iterable[events.Key]:
        try:
            found = list(super()._sequence_to_key_events(sequence, alt))
            if not found and _ALT_KEY.fullmatch(sequence):
                # At once: followed by another key's ESC, Textual would type ^ and the character.
                alt, found = True, list(super()._sequence_to_key_events(sequence[1:], True))
        except (ValueError, OverflowError):  # a number that is no character
            return []
        # Textual forgets Alt with signs: Alt+. would type a full stop.
        return [
            events.Key(f"alt+{each.key}", each.character)
            if alt and each.is_printable and "alt" not in each.key.split("+")
            else each
            for each in found
        ]


def _without_beginning_of(mark: str, text: str) -> tuple[str, str]:
    """Divide `text` before what may be the beginning of `mark` at its end."""
    for size in range(min(len(mark) - 1, len(text)), 0, -1):
        if text.endswith(mark[:size]):
            return text[:-size], mark[:size]
    return text, ""


def is_possible(event: events.Resize) -> bool:
    """Whether the size that the terminal reports is possible."""
    return 1 <= event.size.width <= LARGEST_WINDOW and 1 <= event.size.height <= LARGEST_WINDOW


def keys_in(text: str) -> list[events.Key]:
    """Return the keys for which a terminal sends this text."""
    parser = KeyboardParser()
    found = [*parser.feed(text), *parser._finish_key()]
    return [each for each in found if isinstance(each, events.Key)]
