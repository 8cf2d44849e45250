"""Plays a script in a real desktop on a pty, and draws what is seen."""

from __future__ import annotations

import re
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from day6_tui.cast.file import Cast, CastEvent
from day6_tui.cast.film import Film, Rows
from day6_tui.cast.recorder import picture_of
from day6_tui.cast.svg import picture
from tests.e2e.mouse import Mouse
from tests.e2e.place import DAY6, Place
from tests.e2e.terminal import Terminal
from tests.pictures.script import Script, script

Frame = tuple[Rows, float]
"""A screen and how long it is seen, in seconds."""

CALM = 0.4
"""Seconds after which a screen that says nothing more is complete."""

_ASKS, _TELLS = b"\x1b[?2026$p", "\x1b[?2026;2$y"
_WHOLE = b"\x1b[?2026l"


class Camera(Terminal):
    """A terminal that is told where a whole picture ends (mode 2026, synchronized output), and so sees whole ones only."""

    _asked = False

    def _take(self, seconds: float) -> None:
        super()._take(seconds)
        if not self._asked and _ASKS in self.output:
            self._asked = True
            self.send(_TELLS)

    def rows_seen(self) -> Rows:
        """The first whole picture from now on, or the last one if nothing more is written."""
        start = last = len(self.output)
        calm = time.monotonic() + CALM
        while self.output.rfind(_WHOLE) < start and time.monotonic() < calm:
            self.look(0.01)
            if len(self.output) != last:
                last, calm = len(self.output), time.monotonic() + CALM
        whole = bytes(self.output[: self.output.rfind(_WHOLE)]).decode("utf-8", "replace")
        film = Film(Cast((self.columns, self.rows), (CastEvent(0.0, "o", picture_of(whole)),)))
        film.go_to(0.0)
        return film.rows()


def frames_of(told: Script) -> list[Frame]:
    """Play a script to its end, or each of those that a film is made of. Raises AssertionError if it does not get there."""
    if told.films:
        return [frame for name in told.films for frame in frames_of(script(name, told.lang))]
    with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
        place = Place(Path(folder))
        try:
            return list(_played(told, place))
        finally:
            place.close()


def drawn(told: Script, frames: list[Frame]) -> str:
    """The picture as SVG: its last frame alone, if it isn't a film."""
    shown = frames if told.films else frames[-1:]
    return picture([rows for rows, _ in shown], told.size, [seconds for _, seconds in shown], told.title)


def _played(told: Script, place: Place) -> Iterator[Frame]:
    for name, text in told.files:
        path = place.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    command = [*DAY6, "--home", str(place.home), "--lang", told.lang, *told.options]
    variables = place.environment(DAY6_LINK="on")
    with Camera(command, *told.size, cwd=place.work, env=variables) as screen:
        for does, what in told.steps:
            if does == "shot":
                yield screen.rows_seen(), float(what)
            else:
                _do(screen, does, what)
        yield screen.rows_seen(), 0.0
        screen.quit()
        screen.wait_end()


def _do(screen: Terminal, does: str, what: Any) -> None:
    texts = what if isinstance(what, list) else [what]
    if does == "wait":
        screen.wait(*map(_condition, texts))
    elif does == "gone":
        screen.wait_gone(*texts)
    elif does == "moves":
        seen = screen.cells(what)
        screen.wait(lambda _: screen.cells(what) != seen)
    elif does == "click":
        Mouse(screen).click_on(what)
    elif does == "press":
        screen.press(*what.split())
    else:
        screen.send(what + "\r" * (does == "type"))


def _condition(text: str) -> str | Callable[[str], Any]:
    """A text, or a regular expression between slashes."""
    if len(text) > 2 and text[0] == text[-1] == "/":
        return re.compile(text[1:-1]).search
    return text
