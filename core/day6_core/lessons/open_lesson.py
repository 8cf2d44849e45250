"""A lesson while it is open: the machine that its checks look at, the stage for its actions, what has happened in it."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable
from typing import TYPE_CHECKING

from day6_core.lessons.document import Lesson, Step
from day6_core.lessons.following import FollowedFile
from day6_core.lessons.live import Live
from day6_core.lessons.player import Steering
from day6_core.lessons.progress import Progress
from day6_core.lessons.stage import Stage

if TYPE_CHECKING:
    from day6_core.lessons.demonstration import Demonstration
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk
    from day6_core.shell.terminal import Terminal

LOOK_SECONDS = 0.25
"""Between two looks at the machine."""

CALM_LOOKS, CALM_SECONDS = 20, 1.0
"""After so many looks without news (a pupil reads) there are fewer."""


class OpenLesson:
    """One lesson from its opening to its closing. Everything that takes time raises StageError where it does not work.

    `since_ns`: when it was asked for; what is typed counts from then on.
    """

    def __init__(self, desk: Desk, session: Session, lesson: Lesson, since_ns: int | None = None) -> None:
        self.lesson = lesson
        self.step = lesson.steps[0]
        """Where the pupil is."""
        self.live = Live(desk, session, lesson.path.parent, since_ns)
        self._since_ns = since_ns
        self.stage = Stage(self.live, session)
        self.file = FollowedFile(lesson.path)
        self.demonstration: Demonstration | None = None
        self.began = 0.0
        """When the step began (`time.monotonic`)."""
        self.shown = False
        """Whether the solution of this step was played for the pupil."""
        self.injecting = False
        """Whether making that fault was begun, once: what goes wrong with it is told."""
        self.injected = False
        """Whether the fault of this drill is there: what is right without it is no solution."""
        self.prepared: set[str] = set()
        """The steps that have got what they begin with."""
        self._performed: set[str] = set()
        """The steps whose solution was played because a later one needs it."""
        self._closed = False

    def close(self) -> None:
        """Stop looking and playing; a drill's home folder is no longer the terminals'."""
        self._closed = True
        if self.demonstration is not None:
            self.demonstration.stop()
        self.live.close()
        desk = self.live.desk
        desk.searching = lambda: ""
        room, desk.room = desk.room, None
        if room is not None:
            theirs = [each for each in desk.terminals if each.shell.variables.get("HOME") == str(room)]
            threading.Thread(target=_close, args=(theirs,), name="day6-close-terminals", daemon=True).start()

    def begin(self, step: Step) -> None:
        """Go to a step: what was done counts no longer."""
        self.step = step
        self.live.begin_step(self._since_ns)
        self._since_ns = None
        self.began = time.monotonic()
        self.shown = False

    async def prepare(self, step: Step) -> None:
        """Make what a step begins with; a file that the pupil has already is left as it is."""
        self.stage.spares = True
        try:
            await self.stage.perform(step.before)
        finally:
            self.stage.spares = False

    async def inject(self) -> None:
        """Make the fault of a drill in a home folder of its own, so that no file of the pupil's is touched."""
        live = self.live
        if self._closed:
            return
        folder = live.desk.home / "drills"
        number = 1
        while (room := folder / (self.lesson.name if number == 1 else f"{self.lesson.name}-{number}")).exists():
            number += 1
        (room / "ros2_ws" / "src").mkdir(parents=True)
        live.desk.room = room
        await self.stage.perform([{"terminal": "new"}, *self.lesson.steps[0].before])
        live.begin_step()
        live.lesson_began_ns = live.step_began_ns
        self.injected = True

    async def solve(self, step: Step, steering: Steering | None = None) -> None:
        """Play a step's solution where everybody can see it."""
        self.shown = self.shown or step is self.step
        self.stage.steering = steering or Steering(seen=True)
        try:
            await self.stage.perform([{"terminal": "idle"}, *step.solve])
        finally:
            self.stage.steering = Steering()

    async def solve_needed(self, names: Iterable[str]) -> None:
        """Play the solutions of steps that a later one needs."""
        for step in filter(None, map(self.lesson.step, names)):
            await self.solve(step)
            self._performed.add(step.name)

    def missing(self, progress: Progress) -> tuple[str, ...]:
        """The needed steps whose state is not there, and those of events alone that were never solved."""
        found = []
        for name in self.step.needs:
            needed = self.lesson.step(name)
            states = [check for check in needed.checks if not check.is_event] if needed is not None else []
            there = states or name in self._performed or progress.step(self.lesson.name, name).solved
            if not there or not all(check.judge(self.live).ok for check in states):
                found.append(name)
        return tuple(found)


def _close(terminals: Iterable[Terminal]) -> None:
    for terminal in terminals:
        terminal.close()
