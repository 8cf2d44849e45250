"""A key, a click or a paste that something fails of is lost, and told; terminals, programs and unsaved texts go on.

Textual ends the whole application with the first exception of a handler, and with it everything that pupils have open.
"""

from __future__ import annotations

import logging
from collections.abc import Awaitable
from typing import Any

from textual import events
from textual.app import App

_log = logging.getLogger(__name__)

TYPED = (events.InputEvent, events.Paste)
"""What a person does: keys, the mouse, what is pasted."""


async def survive(app: App[Any], event: events.Event, handling: Awaitable[None]) -> None:
    """Wait for the `handling` of an event. The exception of what a person did goes to the application's `frame_failed`.

    Every other exception comes out, and so do all without a terminal (tests).
    """
    try:
        await handling
    except Exception as error:
        if app._exit:
            _log.debug("a key or a click came too late", exc_info=error)  # for a pane that is gone
            return
        failed = getattr(app, "frame_failed", None)
        if failed is None or app.is_headless or not isinstance(event, TYPED):
            raise
        failed(error)
