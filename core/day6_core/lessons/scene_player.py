"""Performs a scene between the frames of a screen, on whatever has terminals. A command that fails ends it."""

from __future__ import annotations

import types
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import suppress
from typing import Any, Protocol

from day6_core.lessons.checks import Condition, condition_of
from day6_core.lessons.player import LOOK, Player, StageError, Steering
from day6_core.width import text_width

WORDS_SECONDS = 1.5
"""What a sentence gets at least, before anything is typed."""

READ_PER_SECOND = 15.0
"""Cells of a sentence that are read in a second."""

LONGEST_WAIT = 6.0
"""Seconds for which a prompt, a window or a program is waited for."""

FAILED_AFTER = 1.5
"""Seconds after a command from which a prompt means that it has ended: before, it may not have begun."""


class Place(Protocol):
    """What a scene acts on."""

    def use_terminal(self, which: str, /) -> None:
        """Type into an idle terminal ('idle') or a new one ('new') from now on."""

    def send(self, text: str, /) -> None:
        """Type into that terminal."""

    def ready(self) -> bool:
        """Whether that terminal shows its prompt and waits for a command."""

    def holds(self, condition: Condition, /) -> bool: ...

    def is_heard(self, topic: str, /) -> bool:
        """Whether a command of ROS (`ros2 topic echo`) listens to a topic."""

    def reading_keys(self) -> bool:
        """Whether the program in that terminal reads single keys."""

    def say(self, text: str, /) -> None:
        """Show a sentence, '' for none."""


@types.coroutine
def _due_in(seconds: float) -> Generator[float, None, None]:
    yield seconds


class ScenePlayer(Player):
    """Performs the actions of a scene in small pieces: call `advance` with the time until `done`."""

    def __init__(self, actions: Iterable[Mapping[str, Any]], place: Place, steering: Steering) -> None:
        super().__init__(_due_in)
        self.steering = steering
        self.done = False
        self._place = place
        self._work = self._performing(actions)
        self._now = self._due = 0.0
        self._behind = 0.0
        """Seconds for which it was held."""
        self._was_held = False

    def advance(self, now: float) -> None:
        """Do what is due at the monotonic time `now`. The time for which it was held counts for none of its waits."""
        if self.steering.held:
            self._was_held = True
            return
        if self._was_held:
            self._was_held, self._behind = False, now - self._now
        self._now = now - self._behind
        while not self.steering.held and not self.done and self._now >= self._due:
            try:
                self._due = self._now + next(self._work)
            except StopIteration:
                self.done = True

    def hurry(self) -> None:
        """Do the rest at once (the user pressed a key)."""
        self.steering.hurry()
        self._due = 0.0

    def _performing(self, actions: Iterable[Mapping[str, Any]]) -> Generator[float, None, None]:
        with suppress(StageError):
            yield from self.perform(actions).__await__()
        self.steering.meet_command()  # it stands at its end too: who goes on by F9 would else stop the world
        yield from self._while_held().__await__()

    async def _until(self, holds: Callable[[], bool], seconds: float) -> bool:
        """Wait for something, at most so long."""
        began = self._now
        while not holds() and self._now - began <= seconds:
            await self._sleep(LOOK)
        return holds()

    async def _while_it_runs(self, holds: Callable[[], bool]) -> bool:
        """Wait for something only until the program it depends on has ended."""
        if not await self._until(holds, FAILED_AFTER):
            await self._until(lambda: holds() or self._place.ready(), LONGEST_WAIT - FAILED_AFTER)
        return holds()

    # -- the actions ---------------------------------------------------------------------------------------------------

    async def _do_terminal(self, which: str) -> None:
        self._place.use_terminal(which)

    async def _do_line(self, line: str) -> None:
        await self._until(self._place.ready, LONGEST_WAIT)
        if line:
            await self._type(self._place.send, line)

    async def _do_wait(self, given: object) -> None:
        condition = condition_of(given)
        assert isinstance(condition, Condition)
        if not await self._while_it_runs(lambda: self._place.holds(condition)):
            raise StageError(f"waited in vain for {given}")

    async def _do_heard(self, topic: str) -> None:
        await self._while_it_runs(lambda: self._place.is_heard(topic))

    async def _do_reading(self, what: str) -> None:
        await self._while_it_runs(self._place.reading_keys)

    async def _do_look(self, seconds: float) -> None:
        if self.steering.seen:
            await self._sleep(seconds / self.steering.speed)

    async def _do_say(self, text: str) -> None:
        self._place.say(text)
        await self._do_look(max(WORDS_SECONDS, text_width(text) / READ_PER_SECOND))
