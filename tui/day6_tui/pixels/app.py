"""Base of the applications whose panes may draw with pixels: asks the terminal after the first frame, writes after Textual."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from textual import events

from day6_core.parts import has_part
from day6_tui.appearance.glyphs import CANVASES, GLYPH_SETS, PIXELS, terminal_environ
from day6_tui.pixels.ask import SIXEL, WINDOWS_TERMINAL_CELL, Ability, Answered, may_be_asked
from day6_tui.pixels.pictures import Pictures
from day6_tui.screen.trouble import TerminalTrouble
from day6_tui.textual_private.access import driver_of, is_leaving
from day6_tui.textual_private.hooks import HookedApp

if TYPE_CHECKING:
    from rich.console import RenderableType

    from day6_tui.appearance.look import Look

_log = logging.getLogger(__name__)

WINDOWS_CHUNK = 8192
"""The console of Windows loses parts of longer writes (textual/app.py has the same)."""


class PictureApp(HookedApp):
    """An application with `look.pictures`."""

    look: Look

    def begin_pictures(self, glyphs: str | None, environ: Mapping[str, str] | None = None) -> None:
        """Find out whether the terminal shows pixels; `glyphs` is what the user chose. `environ` tells of another terminal."""
        look, environ = self.look, terminal_environ() if environ is None else environ
        if self.is_headless or look.colours.colourless or look.glyphs.name not in (PIXELS, *CANVASES[:2]):
            return
        if not has_part("PIL"):
            if glyphs == PIXELS:
                self.post_message(TerminalTrouble("pixels.missing"))
            return
        look.pictures = pictures = Pictures(
            look, environ, self._write_picture, changed=self._pictures_changed, given_up=self._too_slow
        )
        pictures.wanted = glyphs in (None, "", "auto", PIXELS)
        if sys.platform != "win32":
            if may_be_asked(environ):
                self.call_after_refresh(self._ask)
        elif glyphs == PIXELS:  # Textual's reader there would take the answers for keys
            pictures.use(Ability(SIXEL, WINDOWS_TERMINAL_CELL))

    def exit(self, result: None = None, return_code: int = 0, message: RenderableType | None = None) -> None:
        """Leave the application. Nothing is written but what removes the pictures: so no picture is forgotten before."""
        if self.look.pictures is not None:
            self.look.pictures.stopped = True
        super().exit(result, return_code, message)

    def _ask(self) -> None:
        if self.look.pictures is not None:
            self.look.pictures.ask((self.size.width, self.size.height), _pixels_of_screen())

    def on_resize(self, event: events.Resize) -> None:
        """The terminal may show anything now, and its letters may have another size."""
        self.drawing.shown.forget()
        pictures = self.look.pictures
        if pictures is not None and pictures.ability is not None and sys.platform != "win32":
            self.call_after_refresh(self._ask)

    def on_answered(self, event: Answered) -> None:
        """The terminal answered."""
        if (pictures := self.look.pictures) is not None:
            self._surviving(lambda: pictures.take(event.text))

    def displayed(self, renderable: RenderableType | None) -> None:
        if (pictures := self.look.pixels) is not None and renderable is not None:
            self._surviving(lambda: pictures.displayed(renderable))

    def send_pictures(self) -> None:
        """At the end of a frame: write what is new, after its text."""
        if (pictures := self.look.pictures) is not None and pictures.any:
            self.call_after_refresh(self._surviving, pictures.send)

    def _surviving(self, draw: Callable[[], object]) -> None:
        """A picture that cannot be drawn must not take the application with it: characters can."""
        try:
            draw()
        except Exception:
            if self.is_headless:
                raise
            _log.exception("drawing with pixels failed")
            if self.look.pictures is not None:
                self._write_picture(self.look.pictures.farewell())
            self.look.pictures, self.look.glyphs = None, GLYPH_SETS[CANVASES[0]]
            self._pictures_changed()

    def _write_picture(self, text: str) -> None:
        driver = driver_of(self)
        if driver is None or is_leaving(self):
            return
        if self.look.pictures is not None and self.look.pictures.ability is not None:
            self.drawing.shown.begin(erases=False)  # cells below a picture are not what was written there
        size = WINDOWS_CHUNK if sys.platform == "win32" else len(text)
        for start in range(0, len(text), size):
            driver.write(text[start : start + size])
        driver.flush()

    def _too_slow(self) -> None:
        self.post_message(TerminalTrouble("pixels.slow"))

    def _pictures_changed(self) -> None:
        from day6_tui.appearance.changing import redraw

        redraw(self, self.look)


def _pixels_of_screen() -> tuple[int, int]:
    """Width and height of the terminal in pixels, 0 where it does not say."""
    if sys.platform == "win32" or sys.__stdin__ is None:
        return 0, 0
    import fcntl
    import struct
    import termios

    try:
        _, _, width, height = struct.unpack("HHHH", fcntl.ioctl(sys.__stdin__.fileno(), termios.TIOCGWINSZ, b"\0" * 8))
    except (OSError, ValueError):
        return 0, 0
    return width, height
