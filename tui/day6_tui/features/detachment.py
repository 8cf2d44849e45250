"""The desktop's part of `--detach`: it leaves its terminal, goes on without one, and takes the next one.

While it is away nothing is drawn and nothing is written. What the keeper says and hears is in `day6_tui/detached/wire.py`.
"""

from __future__ import annotations

import json
import socket
from collections.abc import Mapping
from typing import TYPE_CHECKING

from day6_tui.appearance.glyphs import terminal_environ
from day6_tui.detached import wire
from day6_tui.detached.loop_line import LoopLine
from day6_tui.textual_private.access import driver_of, forget_terminal, is_leaving, within

if TYPE_CHECKING:
    from day6_tui.app import Day6App
    from day6_tui.screen.adaptation import Adaptation


class Detachment:
    """Whether the desktop has a terminal; without a keeper it always has its own."""

    def __init__(self, app: Day6App, descriptor: int | None) -> None:
        self._app = app
        self._adaptation: Adaptation | None = None
        self._line = None if descriptor is None else LoopLine(socket.socket(fileno=descriptor))
        self.away = False
        """Whether there is no terminal."""
        self.is_in_page = _is_page(terminal_environ())
        """Whether the terminal is our page in a browser."""
        if descriptor is not None:
            from day6_tui.screen.adaptation import Adaptation

            self._adaptation = Adaptation(app)
            self._adaptation.begin()

    @property
    def is_possible(self) -> bool:
        return self._line is not None

    def begin(self) -> None:
        """Listen to the keeper; call it in the event loop, when the simulated machine runs."""
        if self._line is not None:
            self._line.on_readable(self._hear)
            self._line.send(wire.HERE)

    def tell(self, note: bytes) -> None:
        """Say something to those who observe the desktop."""
        if self._line is not None and not self._line.closed:
            self._line.send(wire.NOTE, note)

    def detach(self) -> None:
        """Leave the terminal. `day6-tui attach` comes back."""
        from day6_tui.textual_private.driver import TerminalDriver

        app, driver = self._app, driver_of(self._app)
        if self._line is None or self.away or is_leaving(app) or not isinstance(driver, TerminalDriver):
            return
        driver.leave_terminal()
        self.away = True
        app.leaving.lost()  # windows keep what they can now: while nothing is drawn they don't look
        app.frames.rest(True)
        self._line.send(wire.GONE)

    def _come(self, environ: Mapping[str, str]) -> None:
        from day6_tui.textual_private.driver import TerminalDriver

        app, driver = self._app, driver_of(self._app)
        if self._adaptation is None or not self.away or is_leaving(app) or not isinstance(driver, TerminalDriver):
            return
        self.away, self.is_in_page = False, _is_page(environ)
        forget_terminal(app)
        try:
            self._adaptation.fit(environ)
        except Exception as error:
            app.frame_failed(error)  # a desktop that looks wrong is better than none
        driver.take_terminal(environ)
        app.screen.refresh(layout=True)
        app.frames.rest(False)

    def _hear(self) -> None:
        assert self._line is not None
        for kind, data in self._line.receive():
            with within(self._app):
                if kind == wire.AWAY:
                    self.detach()  # once away, it has told that already
                elif kind == wire.COME:
                    self._come(json.loads(data))
                    self._line.send(wire.HERE)
                elif kind == wire.OBSERVERS:
                    self._app.classroom.observe("keeper", int(data))
                elif kind == wire.ORDER:
                    self._app.classroom.hear(data)
        if self._line.closed:  # the keeper was killed, and the terminal hangs up
            self._line.let_go()


def _is_page(environ: Mapping[str, str]) -> bool:
    return environ.get("TERM_PROGRAM") == wire.PAGE
