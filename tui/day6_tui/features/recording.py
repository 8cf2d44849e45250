"""Recording the desktop's screen: begin, end, and what the user is told of it. `cast/recorder.py` writes the file."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.reason import reason
from day6_core.session.harmless import one_line
from day6_tui.actions import Handlers
from day6_tui.appearance.changing import Looks
from day6_tui.appearance.glyphs import GLYPH_SETS
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.parts import Feature, Parts
from day6_tui.terminal_app import TerminalApp
from day6_tui.textual_private.access import driver_of

if TYPE_CHECKING:
    from textual.timer import Timer

    from day6_tui.cast.recorder import Recorder


SECONDS = 1.0
"""Between two times that the upper line shows."""


class Recording(Feature):
    """At most one recording at a time."""

    def __init__(self, parts: Parts, app: TerminalApp, looks: Looks, asks: Callable[[], bool]) -> None:
        super().__init__(parts)
        self._app = app
        self._looks = looks
        self._asks = asks
        """Whether the user is being asked if the desktop shall end."""
        self._recorder: Recorder | None = None
        self._seconds: Timer | None = None
        self._pixels = ""
        """The set of characters to go back to: pictures of real pixels are in no cast."""

    def actions(self) -> Handlers:
        return {"record": self.toggle}

    @property
    def running(self) -> bool:
        return self._recorder is not None

    def words(self) -> str:
        """What the upper line says while a recording runs, '' otherwise."""
        if self._recorder is None:
            return ""
        seconds = int(self._recorder.seconds)
        return self._look.texts("record.running", time=f"{seconds // 60}:{seconds % 60:02}")

    def toggle(self) -> None:
        """End the recording that runs, or ask into which file to record."""
        if self.running:
            self.end()
            return
        from day6_tui.overlays.prompt import Prompt, before_replacing

        texts = self._look.texts

        def taken(text: str) -> str | None:
            if not text.strip():
                return texts("record.no_name")
            return self._try(self._path(text), replace=True)

        name = time.strftime("day6-%Y%m%d-%H%M%S.cast")
        sure = before_replacing(self._look, self._path, taken)
        self._desktop.open_overlay(Prompt(self._look, texts("record.file"), name, sure, note=texts("record.note")))

    def _path(self, text: str) -> Path:
        """The file that a user of the desktop means: in the home folder of its terminals."""
        home = self._machine.desk.home if self._machine.desk is not None else Path.cwd()
        name = text.strip()
        return home / (name[2:] if name.startswith("~/") else name)

    def begin(self, path: Path) -> None:
        """Record into a new file; what does not work is told."""
        if complaint := self._try(path, replace=False):
            self._notices.show(f"{one_line(str(path))}: {complaint}", NOTICE_SECONDS)

    def _try(self, path: Path, *, replace: bool) -> str | None:
        """Begin; return what is wrong, or None."""
        from day6_tui.cast.recorder import Recorder

        app, texts = self._app, self._look.texts
        driver = driver_of(app)
        if driver is None or not hasattr(driver, "recorder"):
            return texts("record.not_here")
        try:
            recorder = Recorder(
                path,
                lambda: (app.size.width, app.size.height),
                replace=replace,
                failed=self._look.wake,
                asks=self._asks,
            )
        except OSError as error:
            return one_line(reason(error))
        if self._look.pixels is not None:
            self._pixels, self._look.glyphs = self._look.glyphs.name, GLYPH_SETS["half"]
        self._recorder = driver.recorder = recorder
        self._seconds = app.set_interval(SECONDS, self._look.wake)
        self._looks.redraw()
        app.draw_anew()
        return None

    def advance(self) -> bool:
        """Tell of a recording that has ended by itself; True while one runs, whose time is shown."""
        recorder = self._recorder
        if recorder is not None and recorder.fault:
            self._leave()
            text = self._look.texts("record.broken", file=recorder.path.name, reason=recorder.fault)
            self._notices.show(one_line(text), NOTICE_SECONDS)
        return self.running

    def end(self) -> None:
        """End the recording, if one runs."""
        recorder = self._recorder
        if recorder is None:
            return
        self._leave()
        recorder.stop()
        if not recorder.fault:
            self._notices.show(
                one_line(self._look.texts("record.done", file=self._shown(recorder.path))), NOTICE_SECONDS
            )

    def _shown(self, path: Path) -> str:
        home = self._machine.desk.home if self._machine.desk is not None else None
        return f"~/{path.relative_to(home)}" if home is not None and path.is_relative_to(home) else str(path)

    def _leave(self) -> None:
        driver = driver_of(self._app)
        if driver is not None and hasattr(driver, "recorder"):
            driver.recorder = None
        self._recorder = None
        if self._seconds is not None:
            self._seconds.stop()
            self._seconds = None
        if self._pixels:
            self._look.glyphs, self._pixels = GLYPH_SETS[self._pixels], ""
            self._looks.redraw()
