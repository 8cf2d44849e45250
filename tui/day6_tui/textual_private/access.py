"""What Textual's applications and widgets keep to themselves, as functions."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Any

from textual._ansi_sequences import SYNC_END as SYNC_END
from textual._ansi_sequences import SYNC_START as SYNC_START
from textual._context import visible_screen_stack

from day6_core.reason import fault

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from textual.app import App
    from textual.driver import Driver
    from textual.notifications import Notification
    from textual.screen import Screen
    from textual.strip import Strip

_log = logging.getLogger(__name__)


def driver_of(app: App[Any]) -> Driver | None:
    """Return what reads and writes the terminal; None before the application runs."""
    return app._driver


def is_leaving(app: App[Any]) -> bool:
    """Whether the application ends: nothing more is drawn, and no key matters."""
    return app._exit


def waiting_writes(app: App[Any]) -> int:
    """Return how many writes the terminal has not taken yet."""
    writer = getattr(app._driver, "_writer_thread", None)
    return writer._queue.qsize() if writer is not None else 0


def ask_terminal(app: App[Any]) -> None:
    """Ask how far the terminal has read, where the driver can."""
    if (ask := getattr(app._driver, "ask", None)) is not None:
        ask()


def lines_of(app: App[Any]) -> list[Strip]:
    """Return the lines of the screen, with what is seen behind an overlay."""
    # Textual's box over the desktop asks here for what is behind it. Without an answer it would remember that nothing is.
    visible_screen_stack.set(app._background_screens)
    return app.screen._compositor.render_strips()


def draw_rest(screen: Screen[Any]) -> None:
    """Draw what has changed or was left over, now."""
    if screen._compositor._dirty_regions:
        screen._compositor_refresh()


def within(app: App[Any]) -> AbstractContextManager[None]:
    """Have what runs inside belong to an application, outside of its own tasks."""
    return app._context()


def forget_terminal(app: App[Any]) -> None:
    """Forget that the terminal draws a frame in one piece: it is another one, and asked anew."""
    app._sync_available = False


async def run_binding(app: App[Any], key: str) -> None:
    """Do what a key is bound to."""
    await app._check_bindings(key)


def fail(app: App[Any], error: Exception) -> None:
    """End the application as Textual does after an error, with one line instead of a traceback."""
    from rich.text import Text

    _log.error("the application failed", exc_info=error)
    app._return_code = 1
    app._exit_renderables.append(Text(f"day6-tui: {fault(error)}"))
    app._close_messages_no_wait()


def put_up(app: App[Any], box: Notification, *, instead_of: Notification | None = None) -> None:
    """Show a notification at once, on all screens."""
    if instead_of is not None:
        del app._notifications[instead_of]
    app._notifications.add(box)
    show_boxes(app)


def take_down(app: App[Any], box: Notification) -> None:
    """Show a notification no more, on no screen."""
    del app._notifications[box]
    show_boxes(app)


def show_boxes(app: App[Any]) -> None:
    """Show the notifications there are. Textual does that on the screen in front alone, and others are seen around it."""
    from textual.widgets._toast import ToastRack

    for screen in app.screen_stack:
        for rack in screen.children:
            if isinstance(rack, ToastRack):
                rack.call_later(rack.show, app._notifications)
