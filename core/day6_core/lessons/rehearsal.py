"""Plays a lesson on a machine of its own: each step has to begin unsolved, refuse wrong answers, be solved by its solution."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from day6_core.lessons.checks import Verdict
from day6_core.lessons.document import Action, Lesson, Step, Wrong
from day6_core.lessons.lag import Lag
from day6_core.lessons.live import Live
from day6_core.lessons.player import StageError
from day6_core.lessons.stage import Stage
from day6_core.reason import named_reason
from day6_core.session.session import Session
from day6_core.shell.desk import Desk
from day6_core.virtual.surroundings import is_virtual

SOON = 0.5
"""Seconds in which a check would notice what is there already, or that a wrong answer was taken."""

SOLVED_WITHIN = 30.0
REFUSED_WITHIN = 12.0
TIMES = 3
"""An answer is played again if the machine stood still meanwhile."""

HELD_UP = 0.15
"""Seconds that it may stand still while a solution is played: programs that count the wall's seconds go wrong by that."""

LOOK = 0.05
LONGEST = 600.0
"""Seconds for a whole lesson."""


@dataclass
class Played:
    """How one step went; `faults` are what its author has to mend."""

    step: str
    line: int
    seconds: float = 0.0
    """That passed on its machine; in virtual time they say nothing of the wall's."""
    faults: list[str] = field(default_factory=list)
    held_up: float = 0.0
    """Seconds for which the machine stood still while its solution went wrong."""


def rehearse(
    lesson: Lesson, home: Path, told: Callable[[Played], None] = lambda _: None, only: str | None = None
) -> list[Played]:
    """Play a lesson with `home` as the machine's home folder; `told` hears of each step when it is done.

    `only`: this step alone, after the solutions of those that it needs. A step whose solution went wrong while the machine was
    held up is played again at the end, alone and with a home beside `home`, TIMES in all. The machine meets no other one. Blocks;
    for commands and tests. Raises TimeoutError.
    """

    def hear(step: Played) -> None:
        if not step.held_up:
            told(step)

    played = _play(lesson, home, hear, only)
    for place, step in enumerate(played):
        if step.held_up:
            played[place] = _play_again(lesson, home, step.step)
            told(played[place])
    return played


def _play_again(lesson: Lesson, home: Path, name: str) -> Played:
    for number in range(2, TIMES + 1):
        (step,) = _play(lesson, home.with_name(f"{home.name}-{name}-{number}"), lambda _: None, name)
        if not step.held_up:
            return step
    step.faults[-1] += _stood_still(step.held_up)
    return step


def _stood_still(seconds: float) -> str:
    return f" (this machine stood still for {seconds} s)" if seconds else ""


def _play(lesson: Lesson, home: Path, told: Callable[[Played], None], only: str | None) -> list[Played]:
    played: list[Played] = []
    with apart():
        desk = Desk(home, domain_id=0)
        done = threading.Event()

        async def main(session: Session) -> int:
            try:
                rehearsal = _Rehearsal(desk, session, lesson)
                needed = _needed(lesson, only)
                for step in lesson.steps:
                    if step.name in needed:
                        await rehearsal.prepare(step)
                    if only not in (None, step.name):
                        continue
                    played.append(await rehearsal.play(step))
                    told(played[-1])
            finally:
                done.set()
            return 0

        desk.start()
        try:
            desk.start_unseen("lesson", main)
            if not done.wait(LONGEST):
                raise TimeoutError(f"the lesson was not done after {LONGEST:g} s")
        finally:
            desk.hurry()
            desk.close()
    return played


def _needed(lesson: Lesson, name: str | None) -> set[str]:
    """The steps that have to be done before the one of this name; none for the whole lesson."""
    step = lesson.step(name) if name is not None else None
    found: set[str] = set()
    for each in step.needs if step is not None else ():
        found |= {each, *_needed(lesson, each)}
    return found


@contextmanager
def apart() -> Iterator[None]:
    """A meeting place of this process's own, so that nobody else's nodes are seen."""
    before = {name: os.environ.get(name) for name in ("DAY6_RUNTIME_DIR", "DAY6_LINK", "ROS_DOMAIN_ID")}
    short = "/tmp" if os.name == "posix" and os.access("/tmp", os.W_OK | os.X_OK) else None  # it holds sockets
    with tempfile.TemporaryDirectory(prefix="d6l-", dir=short, ignore_cleanup_errors=True) as folder:
        os.environ["DAY6_RUNTIME_DIR"] = folder
        if not is_virtual():  # there it is a part of that
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
        self._now = ""
        """Which actions are performed."""

    async def prepare(self, step: Step) -> None:
        """Do what is needed for a later step."""
        with suppress(StageError, OSError, ValueError):  # the step that needs it tells what is missing
            await self._stage.perform((*step.before, *step.solve))
            await self._session.until(lambda: self._solved(step), SOLVED_WITHIN, LOOK)

    async def play(self, step: Step) -> Played:
        played = Played(step.name, step.line)
        began = time.monotonic()
        if not step.solve:
            played.faults.append("has no 'solve' (the actions that solve it), so it cannot be played")
            return played
        self._now = "before"
        try:
            await self._stage.perform(step.before)
            self._live.begin_step()
            if await self._session.until(lambda: self._solved(step), SOON, LOOK):
                played.faults.append(f"is solved before anything was done: {self._holding(step)}")
            for number, wrong in enumerate(step.wrong, 1):
                await self._refuse(step, number, wrong, played)
            await self._solve(step, played)
        except (StageError, OSError, ValueError, KeyError) as error:
            reason = f"unknown name {error}" if isinstance(error, KeyError) else named_reason(error)
            played.faults.append(f"could not be played, {self._now}: {reason}")
        played.seconds = time.monotonic() - began
        return played

    async def _solve(self, step: Step, played: Played) -> None:
        self._now = "solve"
        is_solved = False
        lag = Lag()
        try:
            with lag.watched(self._session):
                await self._perform(step, step.solve)
                is_solved = await self._session.until(lambda: self._solved(step), SOLVED_WITHIN, LOOK)
            if not is_solved:
                played.faults.append(f"is not solved by its solution: {self._missing(step)}")
        finally:
            if not is_solved:
                played.held_up = lag.stood_still(HELD_UP)

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
        what = f"the wrong answer {number} (line {wrong.line})"
        for _ in range(TIMES):
            self._now = what
            lag = Lag()
            with lag.watched(self._session):
                fault = await self._fault_with(step, wrong, what)
            stood_still = lag.stood_still()
            self._now = f"{what}, undo"
            await self._stage.perform(wrong.undo)
            if wrong.undo and "type" in wrong.undo[-1]:
                await self._stage.until_line_ends()  # what comes next may open a terminal beside it
            self._live.begin_step()
            if not fault or not stood_still:
                break
        if fault:
            played.faults.append(fault + _stood_still(stood_still))

    async def _fault_with(self, step: Step, wrong: Wrong, what: str) -> str:
        """Play a wrong answer, and return what the step does wrong with it; empty if nothing."""
        await self._perform(step, wrong.do)
        waited = 0.0
        while waited < REFUSED_WITHIN:
            if self._solved(step):
                return f"takes {what} for right: {self._holding(step)}"
            if waited >= SOON and _plain(wrong.says) in _plain(self._failing(step)):
                return ""
            await self._session.sleep(LOOK)
            waited += LOOK
        return f"{what} should be refused with {wrong.says!r}, but it says: {self._missing(step)}"

    def _verdicts(self, step: Step) -> list[Verdict]:
        return [check.judge(self._live) for check in step.checks]

    def _solved(self, step: Step) -> bool:
        return all(verdict.ok for verdict in self._verdicts(step))

    def _failing(self, step: Step) -> str:
        """What `says` is compared with."""
        return "; ".join(verdict.text("en") for verdict in self._verdicts(step) if not verdict.ok)

    def _missing(self, step: Step) -> str:
        """What an author reads: what does not hold, and what was seen instead."""
        verdicts = [verdict for verdict in self._verdicts(step) if not verdict.ok]
        return "; ".join(f"not yet '{each.wanted.text('en')}'{_seen(each)}" for each in verdicts)

    def _holding(self, step: Step) -> str:
        return "; ".join(f"'{verdict.wanted.text('en')}' holds" for verdict in self._verdicts(step))


def _seen(verdict: Verdict) -> str:
    text = verdict.saw.text("en").strip() if verdict.saw is not None else ""
    return f" (seen: {text})" if text else ""


def _plain(text: str) -> str:
    """A message as it is compared: without the marks of commands, with single blanks."""
    return " ".join(text.replace("`", "").lower().split())
