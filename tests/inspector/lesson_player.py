"""Plays a lesson's solutions on a lab's machine, as a pupil who makes no mistake, and lets a test look after every step."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.lessons.live import Live
from day6_core.lessons.stage import Stage
from day6_core.session.clock import nanoseconds

if TYPE_CHECKING:
    from day6_core.lessons.document import Lesson, Step
    from day6_core.session.session import Session
    from tests.inspector.lab import Lab

LOOK = 0.05
SOLVED_WITHIN = 30.0
MOST_PLAYS = 3
LAGGED_NS = nanoseconds(0.25)
"""World time that was given up while a step was played: of one that went wrong this says as little as in `day6-tui grade`, which
plays it again. A turtle that a program steers by the wall's seconds turns less then.
"""

LONGEST = 500.0
"""Seconds for one lesson."""


def play(lab: Lab, lesson: Lesson, after: Callable[[Step], object]) -> None:
    """Play all steps; `after` is called when one is solved, on this thread, while the world goes on.

    Raises AssertionError for a step that its solution does not solve, and what `after` raises.
    """
    player = _Player(lab, lesson)
    player.start()
    for step in lesson.steps:
        player.solved(step)
        after(step)
        player.go_on.set()


class _Player:
    def __init__(self, lab: Lab, lesson: Lesson) -> None:
        self._lab = lab
        self._lesson = lesson
        self._done: dict[str, str] = {}
        """Steps that were played -> '' or what went wrong."""
        self.go_on = threading.Event()

    def start(self) -> None:
        self._lab.desk.start_unseen("lesson", self._main)

    def solved(self, step: Step) -> None:
        """Wait until a step was played."""
        self._lab.wait(lambda: self._pump() or step.name in self._done, LONGEST)
        assert self._done[step.name] == "", f"{step.name}: {self._done[step.name]}"

    def _pump(self) -> None:
        for terminal in list(self._lab.desk.terminals):
            terminal.update()

    async def _main(self, session: Session) -> int:
        live = Live(self._lab.desk, session, self._lesson.path.parent)
        stage = Stage(live, session)
        for step in self._lesson.steps:
            self.go_on.clear()
            for _ in range(MOST_PLAYS):
                lost = session.clock.lost_ns
                said = await self._play(step, live, stage, session)
                if not said or session.clock.lost_ns - lost < LAGGED_NS:
                    break
            self._done[step.name] = said
            while not self.go_on.is_set():
                await session.sleep(LOOK)
        return 0

    async def _play(self, step: Step, live: Live, stage: Stage, session: Session) -> str:
        def holds() -> bool:
            return not [check for check in step.checks if not check.judge(live).ok]  # all of them hear messages

        performing = True

        async def look() -> None:  # messages are heard by a check that is asked
            while performing:
                holds()
                await session.sleep(LOOK)

        try:
            await stage.perform(step.before)
            live.begin_step()
            session.spawn(look())
            await stage.perform(step.solve)
        except Exception as error:
            return f"{type(error).__name__}: {error}"
        finally:
            performing = False
        if await session.until(holds, SOLVED_WITHIN, LOOK):
            return ""
        return "; ".join(verdict.text("en") for check in step.checks if not (verdict := check.judge(live)).ok)
