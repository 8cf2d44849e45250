"""How an application on the terminal ends and is stopped: at any moment, in bounded time, with the terminal given back.

`core.session.ending` knows when; here is what that means for Textual. The order at the end is: the application leaves and gives
the terminal back, then the programs end (`Desk.close`). What takes too long is hurried, and at last ended by force.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_tui.core.session.ending import Ending, Step
from day6_tui.tui import output

if TYPE_CHECKING:
    from day6_tui.tui.app import Day6App

LEAVE_SECONDS = 6.0
"""For the screen's own way out, the programs' (`Desk.close`) and the link's; on a machine that has other work too."""
HURRY_SECONDS = 1.5
"""For the same once the user has said it twice."""

GIVE_BACK = "".join(
    (
        "\x1b[?2026l",  # what is drawn is shown at once
        "\x1b[?1000l\x1b[?1003l\x1b[?1015l\x1b[?1006l\x1b[?1016l",  # the mouse
        "\x1b[?2004l\x1b[?2048l\x1b[?1004l",  # marks around what is pasted, reports of the size and of the focus
        "\x1b[?7h\x1b[<u",  # long lines wrap; the keyboard sends what it always did
        "\x1b[?1049l\x1b[?25h\x1b[0m",  # the shell's screen, the cursor, plain text
    )
)
"""Takes back all that Textual turns on."""


def ending_of(app: Day6App) -> Ending:
    """Return the end of the desktop; it listens to nothing yet."""
    ending = Ending(Step(lambda: _leave(app), LEAVE_SECONDS), Step(app.machine.hurry, HURRY_SECONDS))
    ending.give_back = lambda: give_back(app)
    return ending


def _leave(app: Day6App) -> None:
    output.let_go()
    if app.leave_soon is not None:
        app.leave_soon()


def give_back(app: Any) -> None:
    """Give the terminal back although the application cannot: its settings, its screen, its modes. May block.

    It may have done so already, all or in part (a slow terminal has not taken it yet); twice does no harm.
    """
    driver = app._driver
    before = getattr(driver, "attrs_before", None)
    if sys.platform != "win32" and before is not None:
        import termios

        with contextlib.suppress(termios.error):
            termios.tcsetattr(driver.fileno, termios.TCSANOW, before)
            termios.tcflush(driver.fileno, termios.TCOFLUSH)
    if driver is not None:
        with contextlib.suppress(OSError):
            os.write(2, GIVE_BACK.encode())


def attend_stops(app: Any, soon: Callable[[Callable[[], object]], object]) -> None:
    """Have the terminal taken again after any stop, and after none of our own (SIGSTOP, a stray SIGCONT) too; POSIX only.

    Textual starts a second time where it was not told to suspend: it then forgets what the terminal's settings were, and the
    first of its two input threads never ends. `soon` runs a function in the application: there, one signal cannot come in the
    middle of what another one asked for. While the application leaves, nothing is taken again.
    """
    driver = app._driver
    if sys.platform == "win32" or not hasattr(driver, "_sigcont_application"):
        return  # headless, or Windows
    here = os.getpid()

    def suspend() -> None:
        if not app._exit:
            driver._sigtstp_application()

    def resume() -> None:
        if app._exit:
            return
        if not driver._must_signal_resume:
            driver.suspend_application_mode()
            driver._must_signal_resume = True
        driver._sigcont_application()

    def stop(number: int, frame: object) -> None:
        if not app._exit:
            soon(suspend)
        elif _has_job_control():
            os.kill(here, signal.SIGSTOP)

    signal.signal(signal.SIGTSTP, stop)
    signal.signal(signal.SIGCONT, lambda number, frame: soon(resume))


def _has_job_control() -> bool:
    """Whether a shell of this session started us, who will let us go on; the kernel does not stop a program without one."""
    if sys.platform == "win32":
        return False
    try:
        return os.getsid(os.getppid()) == os.getsid(0)
    except OSError:
        return False
