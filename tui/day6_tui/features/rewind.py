"""Back in time, in a desktop in virtual time: what was done so far is done again from the start, up to an earlier moment.

With the same keys at the same moments a world is the same again. So the desktop writes down what the person types and clicks, and
keeps the home folder as it was when the world began. To go back it leaves, and this process begins a new world on a copy of that
folder: there the scene is played and the keys are pressed again, as fast as it can, and from the wanted moment on the person goes
on. The person's own folder is left as it is.
"""

from __future__ import annotations

import asyncio
import contextvars
import json
import logging
import math
import os
import shutil
import stat
import threading
from collections.abc import Callable
from contextlib import suppress
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from textual import events
from textual.message import Message

from day6_core.virtual import surroundings
from day6_core.whole_file import replace_file
from day6_tui.actions import Handlers
from day6_tui.bars.notices import HINT_SECONDS, NOTICE_SECONDS
from day6_tui.panes.pane import Piece
from day6_tui.parts import Feature, Parts

if TYPE_CHECKING:
    from day6_core.virtual.surroundings import Pace

BACK_SECONDS = 10.0
MOST_FILES, MOST_BYTES = 5_000, 50_000_000
"""A home folder that is larger isn't copied."""
SETTLE_SECONDS = 0.05
"""Real time in which the picture follows a key that may have changed more of it than a letter; the world waits for it."""
LOOK_NS = 1_000_000_000
"""The world's time between two looks whether the person has stopped it."""
STOPS = ("ctrl+q", "escape")
"""Keys that are heard while the past is played again."""

_log = logging.getLogger(__name__)
_VARIABLE = "DAY6_REWIND"
"""Names the folder that is handed on to the world that begins anew."""
_FOLDER, _FIRST, _COPY, _JOURNAL = "rewind", "first", "home", "journal.json"
_MOUSE = {each.__name__: each for each in (events.MouseDown, events.MouseUp, events.MouseMove)} | {
    each.__name__: each
    for each in (events.MouseScrollUp, events.MouseScrollDown, events.MouseScrollLeft, events.MouseScrollRight)
}


class Past(NamedTuple):
    """What is played again."""

    until: int
    """The moment of the world at which it ends, ns."""
    speed: float
    """At which time goes on after that."""
    paused: bool
    events: list[tuple[int, list[Any]]]
    """What was typed and clicked until then, with the moments of the world."""


# -- before the desktop begins -------------------------------------------------------------------------------------------


def begin(home: Path) -> tuple[Path, Past | None]:
    """Keep the home folder as it is when a world begins; return the folder to work in, and what is to be played again.

    That is a copy if something is to be played again.
    """
    if surroundings.pace is None:
        return home, None
    kept = _kept()
    before = Path(os.environ.pop(_VARIABLE, ""))
    if before.name != _FOLDER or not surroundings.is_left(str(before.parent)):
        kept.mkdir()
        try:
            if _is_small(home):
                _copy(home, kept / _FIRST)
        except OSError as error:  # not all of it may be read
            shutil.rmtree(kept / _FIRST, ignore_errors=True)
            _log.warning("the home folder can't be copied: %s", error)
        return home, None
    os.rename(before, kept)
    with suppress(OSError):
        surroundings.remove(str(before.parent))
    shutil.rmtree(kept / _COPY, ignore_errors=True)
    _copy(kept / _FIRST, kept / _COPY)
    told = json.loads((kept / _JOURNAL).read_text(encoding="utf-8"))
    return kept / _COPY, Past(told["until"], told["speed"], told["paused"], [(at, what) for at, what in told["events"]])


def begin_again(environ: dict[str, str]) -> None:
    """Become the desktop once more, in a world in which the past is played again. Raises OSError."""
    import sys

    surroundings.begin_anew(sys.orig_argv, {**environ, _VARIABLE: str(_kept())}, paced=True)


def _kept() -> Path:
    return Path(os.environ[surroundings.VARIABLE], _FOLDER)


def _is_small(home: Path) -> bool:
    files = size = 0
    for folder, _, names in os.walk(home):
        files += len(names)
        for name in names:
            size += os.lstat(os.path.join(folder, name)).st_size
        if files > MOST_FILES or size > MOST_BYTES:
            return False
    return True


def _copy(source: Path, target: Path) -> None:
    """Copy a folder, links as they are, without what is neither file nor folder; one that isn't there is empty."""
    target.mkdir(exist_ok=True)
    if source.is_dir():
        shutil.copytree(source, target, symlinks=True, ignore=_neither_file_nor_folder, dirs_exist_ok=True)


def _neither_file_nor_folder(folder: str, names: list[str]) -> list[str]:
    modes = ((name, os.lstat(os.path.join(folder, name)).st_mode) for name in names)
    return [name for name, mode in modes if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode) or stat.S_ISLNK(mode))]


# -- on the desktop --------------------------------------------------------------------------------------------------------


class Rewind(Feature):
    """Writes down what the person does, and does it again."""

    def __init__(
        self,
        parts: Parts,
        past: Past | None,
        follow: Callable[[], None],
        rest: Callable[[bool], None],
        leave: Callable[[], object],
    ) -> None:
        super().__init__(parts)
        self._past = past
        self._follow, self._rest, self._leave = follow, rest, leave
        self._events: list[tuple[int, list[Any]]] = [] if past is None else list(past.events)
        self._stopped = False
        self.plays = past is not None
        """Whether the past is being played again."""
        self.is_replay = past is not None
        """Whether this world is one that began anew, on a copy."""
        self.wanted = False
        """Whether the desktop is to begin again when it has been left."""

    @property
    def is_possible(self) -> bool:
        """Whether there is a way back."""
        return surroundings.pace is not None and (_kept() / _FIRST).is_dir()

    def actions(self) -> Handlers:
        return {"back": self.back}

    def pieces(self) -> list[Piece]:
        """What the upper bar says of it."""
        return [Piece(f"{self._look.texts('bar.replay')}   ", self._look.colours.warning)] if self.is_replay else []

    def back(self) -> None:
        """Go back by some seconds of the world."""
        pace = surroundings.pace
        if pace is None or self.plays:
            return
        if not self.is_possible:
            text = self._look.texts("rewind.large", files=MOST_FILES, size=MOST_BYTES // 1_000_000)
            self._notices.show(text, NOTICE_SECONDS)
            return
        until = max(0, pace.now - int(BACK_SECONDS * 1e9))
        told = {
            "until": until,
            "speed": pace.speed,
            "paused": pace.paused,
            "events": [each for each in self._events if each[0] <= until],
        }
        try:
            replace_file(_kept() / _JOURNAL, json.dumps(told).encode(), sync=False)
        except OSError as error:
            from day6_core.reason import reason

            self._notices.show(self._look.texts("rewind.failed", reason=reason(error)), NOTICE_SECONDS)
            return
        self.wanted = True
        self._leave()

    # -- what is typed and clicked -------------------------------------------------------------------------------------------

    def lets_in(self, message: Message) -> bool:
        """Write down what the person does; return whether it is done now. On the thread that reads the terminal."""
        pace = surroundings.pace
        if pace is None:
            return True
        written = _written(message)
        if self.plays:
            if isinstance(message, events.Key) and message.key in STOPS:
                self._stopped = True
                return message.key == "ctrl+q"
            return written is None
        if written is not None:
            self._events.append((pace.now, written))
        return True

    # -- once more -------------------------------------------------------------------------------------------------------------

    def play(self, press: Callable[[Message], None]) -> None:
        """Do it again as fast as it can, if something is to be done again. In the event loop, when the world begins."""
        pace, past = surroundings.pace, self._past
        if pace is None or past is None:
            return
        loop, context = asyncio.get_running_loop(), contextvars.copy_context()
        pace.replays = True
        self._rest(True)
        self._notices.show(self._look.texts("rewind.plays"))

        def soon(function: Callable[..., object], *arguments: object) -> None:
            try:
                loop.call_soon_threadsafe(function, *arguments, context=context)
            except RuntimeError:  # the loop was closed
                self._stopped = True

        def press_again(group: list[list[Any]]) -> None:
            self._follow()
            for written in group:
                press(_read(written))
            if any(written[0] != "Key" or len(written[1]) > 1 for written in group):
                pace.waits = True
                loop.call_later(SETTLE_SECONDS, end_wait)

        def end_wait() -> None:
            pace.waits = False

        def play_on() -> None:
            for at, group in groupby(past.events, lambda each: each[0]):
                while not self._stopped and pace.now < at:
                    pace.sleep_until(min(at, pace.now + LOOK_NS))
                if self._stopped:
                    break
                soon(press_again, [written for _, written in group])
            while not self._stopped and pace.now < past.until:
                pace.sleep_until(min(past.until, pace.now + LOOK_NS))
            soon(self._go_on, pace, past)

        threading.Thread(target=play_on, name="day6-replay", daemon=True).start()

    def _go_on(self, pace: Pace, past: Past) -> None:
        """The wanted moment is there: from now on the person goes on."""
        self.plays = pace.replays = pace.waits = False
        self._events = [each for each in self._events if each[0] <= pace.now]
        pace.set_speed(past.speed)
        (pace.pause if past.paused else pace.resume)()
        self._rest(False)
        self._notices.show(self._look.texts("rewind.there", time=_in_minutes(pace.now)), HINT_SECONDS)


def _in_minutes(ns: int) -> str:
    minutes, seconds = divmod(ns / 1e9, 60)
    return f"{minutes:.0f}:{math.floor(seconds):02}"


def _written(message: Message) -> list[Any] | None:
    """A key or click as it is kept; None for anything else, such as an answer of the terminal."""
    if isinstance(message, events.Key):
        return ["Key", message.key, message.character]
    if isinstance(message, events.Paste):
        return ["Paste", message.text]
    if isinstance(message, events.MouseEvent) and type(message).__name__ in _MOUSE:
        place = (message.x, message.y, message.delta_x, message.delta_y, message.button)
        held = (message.shift, message.meta, message.ctrl)
        return [type(message).__name__, *place, *held, message.screen_x, message.screen_y]
    return None


def _read(written: list[Any]) -> Message:
    kind, *values = written
    if kind == "Key":
        return events.Key(*values)
    return events.Paste(*values) if kind == "Paste" else _MOUSE[kind](None, *values)
