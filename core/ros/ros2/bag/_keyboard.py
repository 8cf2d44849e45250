"""Keys for a running recorder or player."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

NO_TERMINAL = "stdin is not a terminal device. Keyboard handling disabled."


def keyboard(session: Session, *, disabled: bool) -> AbstractContextManager[None]:
    """Inside, keys come one by one. Where there is no keyboard, says so, as the real one does."""
    if disabled:
        return nullcontext()
    if not session.stdin.isatty():
        session.print(NO_TERMINAL)
        return nullcontext()
    return session.stdin.raw()


async def listen(session: Session, press: Callable[[str], None]) -> None:
    """Hand every key to `press` until there are no more."""
    while key := await session.stdin.read_key():
        press(key)
