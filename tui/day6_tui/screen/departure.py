"""How an application on the terminal is ended or suspended: at any moment, in bounded time, restoring the terminal.

`day6_core.session.ending` knows when; this module does it for Textual. The order is: the application exits and restores the
terminal, then the programs end (`Desk.close`). Whatever takes too long is hurried, and finally ended by force.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.session.ending import Ending, EndingStep
from day6_tui.pixels.app import PictureApp
from day6_tui.screen.modes import GIVE_BACK
from day6_tui.textual_private import output
from day6_tui.textual_private.access import driver_of, is_leaving

if TYPE_CHECKING:
    from textual.app import App

    from day6_tui.app import Day6App

LEAVE_SECONDS = 6.0
"""Seconds for the screen, the programs (`Desk.close`) and the link to end, on a machine that is busy with other work too."""
HURRY_SECONDS = 1.5
"""Seconds that are left once the user has asked a second time."""


def ending_of(app: Day6App) -> Ending:
    """Return the object that ends the desktop; it handles no signal yet."""
    ending = Ending(EndingStep(lambda: _leave(app), LEAVE_SECONDS), EndingStep(app.machine.hurry, HURRY_SECONDS))
    ending.restore_terminal = lambda: give_back(app)
    return ending


def _leave(app: Day6App) -> None:
    output.let_go()
    if app.leave_soon is not None:
        app.leave_soon()


def give_back(app: App[None]) -> None:
    """Restore the terminal when the application cannot: its settings, its screen, its modes. May block.

    The application may have done so already, fully or in part (a slow terminal); doing it twice is harmless.
    """
    driver = driver_of(app)
    if sys.platform != "win32":
        import termios

        from textual.drivers.linux_driver import LinuxDriver

        if isinstance(driver, LinuxDriver) and driver.attrs_before is not None:
            with contextlib.suppress(termios.error):
                termios.tcsetattr(driver.fileno, termios.TCSANOW, driver.attrs_before)
                termios.tcflush(driver.fileno, termios.TCOFLUSH)
    if driver is not None:
        with contextlib.suppress(OSError):
            pictures = app.look.pictures if isinstance(app, PictureApp) else None
            os.write(2, ((pictures.farewell() if pictures is not None else "") + GIVE_BACK).encode())


def attend_stops(app: App[None], soon: Callable[[Callable[[], object]], object]) -> None:
    """Take over the terminal again after any suspension, even one we did not start (SIGSTOP, a stray SIGCONT). POSIX only.

    Textual starts a second time where it was not told to suspend: it then forgets what the terminal's settings were, and the
    first of its two input threads never ends. `soon` runs a function in the application: there, one signal cannot come in the
    middle of what another one asked for. While the application leaves, nothing is taken again.
    """
    if sys.platform == "win32":
        return
    from day6_tui.textual_private.driver import TerminalDriver

    driver = driver_of(app)
    if not isinstance(driver, TerminalDriver):
        return  # headless
    here = os.getpid()

    def suspend() -> None:
        if not is_leaving(app):
            driver.suspend_job()

    def resume() -> None:
        if not is_leaving(app):
            driver.resume_job()

    def stop(number: int, frame: object) -> None:
        if not is_leaving(app):
            soon(suspend)
        elif _has_job_control():
            os.kill(here, signal.SIGSTOP)

    signal.signal(signal.SIGTSTP, stop)
    signal.signal(signal.SIGCONT, lambda number, frame: soon(resume))


def _has_job_control() -> bool:
    """Whether a shell of this session started us and can resume us; the kernel does not stop a program without one."""
    if sys.platform == "win32":
        return False
    try:
        return os.getsid(os.getppid()) == os.getsid(0)
    except OSError:
        return False
