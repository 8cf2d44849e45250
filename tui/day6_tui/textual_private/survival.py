"""If handling a key, a click or a paste fails, it is lost and the error is shown; programs and unsaved texts survive.

Textual ends the whole application at the first exception in a handler, and with it everything that students have open.
"""

from __future__ import annotations

import logging
from collections.abc import Awaitable
from typing import Any

from textual import events
from textual.app import App
from textual.message import Message
from textual.message_pump import MessagePump

from day6_tui.textual_private.access import is_leaving

_log = logging.getLogger(__name__)

TYPED = (events.InputEvent, events.Paste)
"""Input events: keys, the mouse, pasted text."""


class PersonMessage(Message):
    """Base of a pane's messages about user input."""


async def survive(app: App[Any], event: Message, handling: Awaitable[None], *, typed: bool = False) -> None:
    """Await the `handling` of an event; pass an exception caused by user input to the application's `frame_failed`.

    `typed` says that the event was user input, although its type does not. Every other exception propagates, and without a
    terminal (tests) all of them do.
    """
    try:
        await handling
    except Exception as error:
        if is_leaving(app):
            _log.debug("a key or a click came too late", exc_info=error)  # for a pane that is gone
            return
        failed = getattr(app, "frame_failed", None)
        if failed is None or app.is_headless or not (typed or isinstance(event, (*TYPED, PersonMessage))):
            raise
        failed(error)


class Surviving(MessagePump):
    """Base of what handles keys, the mouse and messages about them: a handler that fails costs that one event."""

    messages_are_typed = False
    """Whether all messages that come here are somebody's doing, whatever their types say."""

    async def on_event(self, event: events.Event) -> None:
        await survive(self.app, event, super().on_event(event))

    async def _on_message(self, message: Message) -> None:
        await survive(self.app, message, super()._on_message(message), typed=self.messages_are_typed)
