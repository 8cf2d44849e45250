"""Performs actions one after the other where people can read along: types, waits, pauses, steered by whoever looks on."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Awaitable, Callable, Iterable, Mapping
from typing import Any

from day6_core import speeds

KEYS_PER_SECOND = 40.0
"""Characters that are typed in a second: slow enough to read along."""

RETURN_TAKES = 10.0
"""The Return of a line comes after the time of so many characters."""

LOOK = 0.02
"""Seconds between two looks."""

LONGEST_WAIT = 40.0
"""Seconds that `type` waits for its prompt and `wait` for its check."""


class StageError(Exception):
    """An action could not be performed."""


class Steering:
    """How fast is typed (all at once where it is not `seen`), and whether it stands: whoever looks on may hold it."""

    def __init__(self, *, seen: bool = False, changed: Callable[[], object] = lambda: None) -> None:
        self.speed = 1.0
        """One of `speeds.SPEEDS`."""
        self._changed = changed
        """Called when somebody has steered."""
        self.begin(seen=seen)

    def begin(self, *, seen: bool) -> None:
        """Something else is performed, as fast as what was before."""
        self.seen = seen
        self.held = False
        self._by_command = False
        """Whether it holds before the next command."""

    def hold(self) -> None:
        """Hold, or go on."""
        self.held = not self.held
        self._changed()

    def change_speed(self, step: int) -> None:
        """Faster (1) or slower (-1)."""
        self.speed = speeds.changed(self.speed, step)
        self._changed()

    def step(self) -> None:
        """Go on up to the next command, and hold before it."""
        self.held, self._by_command = False, True
        self._changed()

    def hurry(self) -> None:
        """Type the rest at once."""
        self.seen = self._by_command = False

    def meet_command(self) -> None:
        """Hold here, where a command begins, if the step was to end here."""
        if self._by_command:
            self.held, self._by_command = True, False


class Player(ABC):
    """Performs actions; the methods `_do_<name>` of subclasses say where, `sleep` in which time."""

    def __init__(self, sleep: Callable[[float], Awaitable[None]]) -> None:
        self.steering = Steering()
        self._sleep = sleep

    async def perform(self, actions: Iterable[Mapping[str, Any]]) -> None:
        """Perform them one after the other. Raises StageError."""
        for action in actions:
            (name, value), *_ = action.items()
            await getattr(self, f"_do_{name}")(value)

    async def _do_type(self, lines: str) -> None:
        for line in lines.strip("\n").split("\n"):
            await self._do_line(line)

    @abstractmethod
    async def _do_line(self, line: str) -> None:
        """Type a line and Return where a command is awaited."""

    async def _type(self, send: Callable[[str], None], line: str) -> None:
        """Type a line and Return, as it is steered."""
        self.steering.meet_command()
        await self._while_held()
        if not self.steering.seen:
            send(f"{line}\r")
            return
        for char in line:
            await self._while_held()
            send(char)
            await self._rest(1.0)
        await self._rest(RETURN_TAKES)
        await self._while_held()
        send("\r")

    async def _rest(self, characters: float) -> None:
        """Let the time go by in which so many characters are typed."""
        if self.steering.seen:
            await self._sleep(characters / KEYS_PER_SECOND / self.steering.speed)

    async def _while_held(self) -> None:
        while self.steering.held:
            await self._sleep(LOOK)

    async def _do_pause(self, seconds: float) -> None:
        await self._sleep(float(seconds))
