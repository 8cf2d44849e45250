"""Keys for a running recorder or player."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

NO_TERMINAL = "stdin is not a terminal device. Keyboard handling disabled."


def keyboard(session: Session, *, disabled: bool) -> AbstractContextManager[None]:
    """Return a context in which keys arrive one by one. Without a keyboard it prints so, as the real one does."""
    if disabled:
        return nullcontext()
    if not session.stdin.isatty():
        session.print(NO_TERMINAL)
        return nullcontext()
    return session.stdin.raw()


async def listen(session: Session, press: Callable[[str], None]) -> None:
    """Call `press` with every key until the input ends."""
    while key := await session.stdin.read_key():
        press(key)
