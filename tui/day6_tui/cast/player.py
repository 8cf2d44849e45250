"""Plays a cast in a terminal: a few keys, and only rows that have changed are drawn."""

from __future__ import annotations

import os
import re
import select
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, NoReturn

from day6_core.session.harmless import one_line
from day6_core.shell.screen.rows import Run, Style
from day6_core.speeds import changed, in_words
from day6_core.width import char_width
from day6_tui.appearance.glyphs import is_colourless
from day6_tui.cast.film import Film
from day6_tui.locale import Texts
from day6_tui.panes.cells import clip, fit

assert not TYPE_CHECKING or sys.platform != "win32"  # `command` says so

FRAME_SECONDS = 1 / 30
JUMP_SECONDS = 5.0
IDLE_SECONDS = 0.5
"""Between two looks at the size of the terminal while nothing is played."""

_NAMES = ("black", "red", "green", "brown", "blue", "magenta", "cyan", "white")
_KEYS = {
    b" ": "pause", b"q": "quit", b"\x03": "quit", b"\x1b": "quit", b"+": "faster", b"=": "faster", b"-": "slower",
    b"\x1b[C": "on", b"\x1bOC": "on", b"\x1b[D": "back", b"\x1bOD": "back", b"\x1b[H": "begin", b"\x1b[1~": "begin",
    b"0": "begin", b".": "frame",
}  # fmt: skip


_KEY = re.compile(rb"\x1b(?:\[[0-?]*[ -/]*[@-~]|O[@-~])|.", re.DOTALL)


class Clock:
    """Where a film is played: time that goes at a speed, stands, and jumps. `now` are seconds of a monotonic clock."""

    def __init__(self, now: float, end: float) -> None:
        self._end = end
        self._at = 0.0
        self._since = now
        self.speed = 1.0
        self.paused = False

    def seconds(self, now: float) -> float:
        """Seconds since the beginning of the film."""
        gone = 0.0 if self.paused else (now - self._since) * self.speed
        return max(0.0, min(self._end, self._at + gone))

    def _keep(self, now: float) -> None:
        self._at, self._since = self.seconds(now), now

    def toggle(self, now: float) -> None:
        """Pause, or go on; at the end it begins again."""
        self._keep(now)
        if not self.paused and self._at >= self._end:
            self._at = 0.0
            return
        self.paused = not self.paused

    def change_speed(self, now: float, step: int) -> None:
        """The next speed up or down."""
        self._keep(now)
        self.speed = changed(self.speed, step)

    def jump(self, now: float, seconds: float) -> None:
        """Go forwards or back."""
        self._keep(now)
        self._at = max(0.0, min(self._end, self._at + seconds))


class Painter:
    """Draws rows on a terminal of a size, as texts that a terminal understands."""

    def __init__(self, environ: Mapping[str, str]) -> None:
        self._colours = "" if is_colourless(environ) else environ.get("COLORTERM", "") or "256"
        self._shown: dict[int, tuple[Run, ...]] = {}
        self._size = (0, 0)

    def paint(self, film: Film, columns: int, lines: int, status: str) -> str:
        """What has to be sent to show the film's picture, and the status in the last line."""
        texts = []
        size = (columns, lines)
        if size != self._size:
            self._size, self._shown = size, {}
            texts.append("\x1b[0m\x1b[2J")
        rows = film.rows()
        for y in range(lines - 1):
            row = rows[y] if y < len(rows) else ()
            if self._shown.get(y, ()) != row or y not in self._shown:
                self._shown[y] = row
                texts.append(f"\x1b[{y + 1};1H{self._line(row, columns)}\x1b[0m\x1b[K")
        texts.append(f"\x1b[{lines};1H\x1b[0;7m{fit(status, columns)}\x1b[0m")
        return "".join(texts)

    def _line(self, row: tuple[Run, ...], columns: int) -> str:
        texts, room = [], columns
        for text, style in row:
            kept, used = "", 0
            for char in one_line(text):
                width = char_width(char)
                if used + width > room:
                    break
                kept += char
                used += width
            texts.append(f"\x1b[{self._sgr(style)}m{kept}")
            room -= used
            if kept != text:
                break
        return "".join(texts)

    def _sgr(self, style: Style) -> str:
        marks = (style.bold, 1), (style.italics, 3), (style.underscore, 4), (style.reverse, 7), (style.strikethrough, 9)
        codes = ["0", *(str(code) for on, code in marks if on)]
        if self._colours:
            codes += [code for colour, base in ((style.fg, 30), (style.bg, 40)) if (code := self._colour(colour, base))]
        return ";".join(codes)

    def _colour(self, name: str, base: int) -> str:
        if name in _NAMES:
            return str(base + _NAMES.index(name))
        plain = name.removeprefix("bright").replace("yellow", "brown")
        if plain in _NAMES:
            return str(base + 60 + _NAMES.index(plain))
        try:
            rgb = int(name, 16) if len(name) == 6 else -1
        except ValueError:
            rgb = -1
        if rgb < 0:
            return ""
        red, green, blue = rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255
        if self._colours in ("truecolor", "24bit"):
            return f"{base + 8};2;{red};{green};{blue}"
        return f"{base + 8};5;{16 + 36 * round(red / 51) + 6 * round(green / 51) + round(blue / 51)}"


def play(film: Film, texts: Texts, environ: Mapping[str, str] = os.environ) -> int:
    """Play until the user leaves; returns the exit status. Needs a terminal."""
    clock, painter = Clock(time.monotonic(), film.cast.seconds), Painter(environ)
    with _raw_terminal():
        while True:
            now = time.monotonic()
            at = clock.seconds(now)
            film.go_to(at)
            columns, lines = shutil.get_terminal_size()
            _send(painter.paint(film, columns, lines, _status(film, clock, at, texts, (columns, lines))))
            stands = clock.paused or at >= film.cast.seconds
            upcoming = film.next_time
            wait = IDLE_SECONDS
            if not stands and upcoming is not None:
                wait = max(FRAME_SECONDS, min(wait, (upcoming - at) / clock.speed))
            if not all(_obey(does, clock, film) for does in _keys(wait)):
                return 0


def _obey(does: str, clock: Clock, film: Film) -> bool:
    """Do what a key means; False to leave."""
    now = time.monotonic()
    if does == "pause":
        clock.toggle(now)
    elif does in ("faster", "slower"):
        clock.change_speed(now, 1 if does == "faster" else -1)
    elif does in ("on", "back", "begin"):
        clock.jump(now, {"on": JUMP_SECONDS, "back": -JUMP_SECONDS, "begin": -film.cast.seconds}[does])
    elif does == "frame" and clock.paused and (upcoming := film.next_time) is not None:
        clock.jump(now, upcoming - clock.seconds(now) + 1e-6)
    return does != "quit"


def _status(film: Film, clock: Clock, at: float, texts: Texts, terminal: tuple[int, int]) -> str:
    unicode = not texts.plain
    stands = clock.paused or at >= film.cast.seconds
    mark = ("‖" if unicode else "=") if stands else ("►" if unicode else ">")
    words = f" {mark} {_time(at)} / {_time(film.cast.seconds)}  {in_words(clock.speed, unicode=unicode)}  "
    columns, lines = film.size
    if columns > terminal[0] or lines > terminal[1] - 1:
        words += texts("cast.larger", columns=columns, lines=lines) + "  "
    return clip(words + texts("cast.keys"), terminal[0])


def _time(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def _keys(wait: float) -> list[str]:
    """What the next keys mean, in their order; none if none comes within `wait` seconds."""
    try:
        if not select.select([0], [], [], wait)[0]:
            return []
        data = os.read(0, 1024)
    except OSError:
        return ["quit"]
    return [_KEYS.get(key, "") for key in _KEY.findall(data)] if data else ["quit"]


def _send(text: str) -> None:
    data = memoryview(text.encode(sys.stdout.encoding or "utf-8", "replace"))
    while data:
        data = data[os.write(1, data) :]


@contextmanager
def _raw_terminal() -> Iterator[None]:
    """Keys come one by one, and the terminal is given back as it was, also on a signal."""
    import termios
    import tty

    before = termios.tcgetattr(0)
    handlers: dict[int, object] = {}

    def leave(number: int, frame: FrameType | None) -> NoReturn:
        raise SystemExit(128 + number)

    restore: list[Callable[[], object]] = []
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        handlers[number] = signal.signal(number, leave)
    try:
        tty.setraw(0, termios.TCSADRAIN)
        restore.append(lambda: termios.tcsetattr(0, termios.TCSADRAIN, before))
        _send("\x1b[?1049h\x1b[?25l\x1b[?7l")
        restore.append(lambda: _send("\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l"))
        yield
    finally:
        for each in reversed(restore):
            try:
                each()
            except (OSError, termios.error):
                continue  # the terminal is gone
