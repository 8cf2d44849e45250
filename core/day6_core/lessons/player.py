"""Performs actions one after the other where people can read along: types, waits, pauses, steered by whoever looks on."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Protocol

from day6_core.speeds import changed

KEYS_PER_SECOND = 40.0
"""Characters that are typed in a second: slow enough to read along."""

RETURN_TAKES = 10.0
"""The Return of a line comes after the time of so many characters."""

LOOK = 0.02
"""Seconds between two looks."""


class StageError(Exception):
    """An action could not be performed."""


class Clock(Protocol):
    """Time that goes on while actions are performed."""

    async def sleep(self, seconds: float, /) -> None: ...

    async def until(self, holds: Callable[[], object], seconds: float, every: float, /) -> bool:
        """Wait for something to hold; False if it does not within so many seconds."""


class Keyboard(Protocol):
    """What is typed into."""

    def send(self, text: str, /) -> None: ...


class Steering:
    """How fast is typed (all at once where it is not `seen`), and whether it stands: whoever looks on may hold it."""

    def __init__(self, *, seen: bool = False, speed: float = 1.0) -> None:
        self.seen = seen
        self.speed = speed
        """One of `speeds.SPEEDS`."""
        self.held = False
        self._by_command = False
        """Whether it holds before the next command."""

    @property
    def pace(self) -> float:
        """Characters a second; 0: all at once."""
        return KEYS_PER_SECOND * self.speed if self.seen else 0.0

    def hold(self) -> None:
        """Hold, or go on."""
        self.held = not self.held

    def change_speed(self, step: int) -> None:
        """Faster (1) or slower (-1)."""
        self.speed = changed(self.speed, step)

    def step(self) -> None:
        """Go on up to the next command, and hold before it."""
        self.held, self._by_command = False, True

    def hurry(self) -> None:
        """Type the rest at once."""
        self.seen = self._by_command = False

    def meet_command(self) -> None:
        """Hold here, where a command begins, if the step was to end here."""
        if self._by_command:
            self.held, self._by_command = True, False


class Player(ABC):
    """Performs actions; the methods `_do_<name>` of subclasses say where."""

    def __init__(self, clock: Clock) -> None:
        self.steering = Steering()
        self._clock = clock

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

    async def _type(self, keyboard: Keyboard, line: str) -> None:
        """Type a line and Return, at the pace of the steering."""
        self.steering.meet_command()
        await self._while_held()
        if not self.steering.seen:
            keyboard.send(f"{line}\r")
            return
        for char in line:
            await self._while_held()
            keyboard.send(char)
            await self._rest(1.0)
        await self._rest(RETURN_TAKES)
        await self._while_held()
        keyboard.send("\r")

    async def _rest(self, characters: float) -> None:
        """Let the time go by in which so many characters are typed."""
        if pace := self.steering.pace:
            await self._clock.sleep(characters / pace)

    async def _while_held(self) -> None:
        while self.steering.held:
            await self._clock.sleep(LOOK)

    async def _do_pause(self, seconds: float) -> None:
        await self._clock.sleep(float(seconds))
