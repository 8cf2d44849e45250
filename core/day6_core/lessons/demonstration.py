"""Plays a lesson by itself for a hall: shows each step, types its solution at reading speed, waits until it is solved.

It can be held anywhere, taken on by a key, and made slower or faster, a quarter to four times.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.lessons.player import StageError, Steering

if TYPE_CHECKING:
    from day6_core.lessons.course import Course
    from day6_core.lessons.document import Page
    from day6_core.lessons.open_lesson import OpenLesson

SLICE = 0.1
"""Seconds between two looks whether somebody pressed a key."""

SOLVED_WITHIN = 30.0
AFTER_SOLVED = 3.0
READS = {"zh": 7.0, "en": 18.0}
"""Characters a second that people read."""


class Demonstration(Steering):
    """One demonstration; the window reads `speed` and `held` and calls `hold`, `go_on`, `change_speed`, `stop`."""

    def __init__(self, course: Course, opened: OpenLesson, language: str) -> None:
        super().__init__(seen=True, changed=course.changed)
        self._course = course
        self._opened = opened
        self._session = opened.live.session  # its time is the world's: a paused world holds a demonstration too
        self._language = language
        self._skip = False
        self.stopped = False

    def go_on(self) -> None:
        """Do not wait any longer: the next thing now."""
        self._skip, self.held = True, False
        self._course.changed()

    def stop(self) -> None:
        self.stopped = True
        self._course.changed()

    async def play(self) -> None:
        """From the present step to the end of the lesson. Raises StageError if a solution does not work."""
        course = self._course
        try:
            while not self.stopped and (step := course.state.step) is not None:
                await self._rest(_reading_seconds(step.pages[self._language], self._language))
                if not course.state.solved and not self.stopped:
                    await self._opened.solve(step, self)
                    await self._until_solved(step.name)
                await self._rest(AFTER_SOLVED)
                if course.state.is_last or self.stopped:
                    return
                course.next()
        finally:
            self._opened.demonstration = None
            course.changed()

    async def _until_solved(self, name: str) -> None:
        if not await self._session.until(lambda: self._course.state.solved or self.stopped, SOLVED_WITHIN, SLICE):
            raise StageError(f"step '{name}' was not solved by its solution")

    async def _rest(self, seconds: float) -> None:
        left = seconds
        while (left > 0 or self.held) and not self._skip and not self.stopped:
            await self._session.sleep(SLICE)
            if not self.held:
                left -= SLICE * self.speed
        self._skip = False


def _reading_seconds(page: Page, language: str) -> float:
    return 2.0 + len(page.body + page.do) / READS[language]
