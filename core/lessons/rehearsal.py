"""Plays a lesson on a machine of its own: each step has to begin unsolved, refuse wrong answers, be solved by its solution."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from day6_tui.core.lessons.checks import Verdict
from day6_tui.core.lessons.document import Action, Lesson, Step, Wrong
from day6_tui.core.lessons.live import Live
from day6_tui.core.lessons.stage import Stage, StageError
from day6_tui.core.session.session import Session
from day6_tui.core.session.streams import InputStream, OutputStream
from day6_tui.core.shell.desk import Desk
from day6_tui.core.shell.language.redirection import Streams

SOON = 0.5
"""Seconds in which a check would notice what is there already, or that a wrong answer was taken."""

SOLVED_WITHIN = 30.0
REFUSED_WITHIN = 12.0
LOOK = 0.05
LONGEST = 600.0
"""Seconds for a whole lesson."""


@dataclass
class Played:
    """How one step went; `faults` are what its author has to mend."""

    step: str
    line: int
    seconds: float = 0.0
    faults: list[str] = field(default_factory=list)


def rehearse(lesson: Lesson, home: Path, told: Callable[[Played], None] = lambda _: None) -> list[Played]:
    """Play a lesson with `home` as the machine's home folder; `told` hears of each step when it is done.

    The machine meets no other one. Blocks; for commands and tests. Raises TimeoutError.
    """
    played: list[Played] = []
    with _apart():
        desk = Desk(home, domain_id=0)
        done = threading.Event()

        async def main(session: Session) -> int:
            try:
                rehearsal = _Rehearsal(desk, session, lesson)
                for step in lesson.steps:
                    played.append(await rehearsal.play(step))
                    told(played[-1])
            finally:
                done.set()
            return 0

        def start() -> None:
            streams = Streams(InputStream(), OutputStream(), OutputStream())
            desk.start_program(["lesson"], main, streams, env=desk.environment(), cwd=desk.home)

        desk.start()
        try:
            desk.scheduler.call_soon_threadsafe(start)
            if not done.wait(LONGEST):
                raise TimeoutError(f"the lesson was not done after {LONGEST:g} s")
        finally:
            desk.hurry()
            desk.close()
    return played


@contextmanager
def _apart() -> Iterator[None]:
    """A meeting place of this process's own, so that nobody else's nodes are seen."""
    before = {name: os.environ.get(name) for name in ("DAY6_RUNTIME_DIR", "DAY6_LINK", "ROS_DOMAIN_ID")}
    short = "/tmp" if os.name == "posix" and os.access("/tmp", os.W_OK | os.X_OK) else None  # it holds sockets
    with tempfile.TemporaryDirectory(prefix="d6l-", dir=short) as folder:
        os.environ["DAY6_RUNTIME_DIR"] = folder
        os.environ.pop("DAY6_LINK", None)
        os.environ.pop("ROS_DOMAIN_ID", None)
        try:
            yield
        finally:
            for name, value in before.items():
                if value is None:
                    os.environ.pop(name, None)
                else:
                    os.environ[name] = value


class _Rehearsal:
    def __init__(self, desk: Desk, session: Session, lesson: Lesson) -> None:
        self._session = session
        self._live = Live(desk, session, lesson.path.parent)
        self._stage = Stage(self._live, session)

    async def play(self, step: Step) -> Played:
        played = Played(step.name, step.line)
        began = time.monotonic()
        try:
            await self._stage.perform(step.before)
            self._live.begin_step()
            if await self._holds(step, SOON):
                played.faults.append("is solved before anything was done")
            for number, wrong in enumerate(step.wrong, 1):
                await self._refuse(step, number, wrong, played)
            await self._perform(step, step.solve)
            if not await self._holds(step, SOLVED_WITHIN):
                played.faults.append(f"is not solved by its solution: {self._failing(step)}")
        except (StageError, OSError, ValueError, KeyError) as error:
            played.faults.append(f"could not be played: {error}")
        played.seconds = time.monotonic() - began
        return played

    async def _perform(self, step: Step, actions: tuple[Action, ...]) -> None:
        """Perform actions and look meanwhile, as the desktop does: messages are heard by a check that was asked."""
        performing = True

        async def look() -> None:
            while performing:
                self._verdicts(step)
                await self._session.sleep(LOOK)

        self._session.spawn(look())
        try:
            await self._stage.perform(actions)
        finally:
            performing = False

    async def _refuse(self, step: Step, number: int, wrong: Wrong, played: Played) -> None:
        await self._perform(step, wrong.do)
        waited, said = 0.0, ""
        while waited < REFUSED_WITHIN:
            if self._solved(step):
                played.faults.append(f"takes the wrong answer {number} for right")
                break
            said = self._failing(step)
            if waited >= SOON and wrong.says.lower() in said.lower():
                break
            await self._session.sleep(LOOK)
            waited += LOOK
        else:
            played.faults.append(
                f"the wrong answer {number} should be refused with {wrong.says!r}, but it says: {said}"
            )
        await self._stage.perform(wrong.undo)
        self._live.begin_step()

    async def _holds(self, step: Step, seconds: float) -> bool:
        waited = 0.0
        while not self._solved(step):
            if waited >= seconds:
                return False
            await self._session.sleep(LOOK)
            waited += LOOK
        return True

    def _verdicts(self, step: Step) -> list[Verdict]:
        return [check.judge(self._live) for check in step.checks]

    def _solved(self, step: Step) -> bool:
        return all(verdict.ok for verdict in self._verdicts(step))

    def _failing(self, step: Step) -> str:
        return "; ".join(verdict.text("en") for verdict in self._verdicts(step) if not verdict.ok)
