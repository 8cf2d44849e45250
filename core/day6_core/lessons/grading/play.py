"""Plays the hidden scenarios of a lesson with one submission, one after the other, on one machine."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

from day6_core.lessons.actions import filled
from day6_core.lessons.checks import Condition, Verdict, condition_of
from day6_core.lessons.checks.terminals import plain_output
from day6_core.lessons.grading.scenarios import Grading, Scenario
from day6_core.lessons.grading.stage import IDLE_SECONDS, GraderStage, NotPlayed, tail
from day6_core.lessons.live import Live
from day6_core.lessons.texts import Say
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.shell.desk import Desk

LOOK = 0.1
ENDING_SECONDS = 1.0
Told = Callable[..., None]


class Play:
    """One submission's way through the scenarios. Runs as a program of the machine."""

    def __init__(self, desk: Desk, session: Session, seed: str) -> None:
        self._desk = desk
        self._session = session
        self._seed = seed
        self._built: dict[str, NotPlayed | None] = {}

    async def grading(self, grading: Grading, told: Told) -> None:
        """Play all scenarios of a file; `told` hears of each when it is done."""
        passed: set[str] = set()
        for scenario in grading.scenarios:
            began = time.monotonic()
            missing = next((each for each in scenario.needs if each not in passed), None)
            problems: list[tuple[Say, Say | None]]
            if missing is not None:
                problems = [(Say("grade.needs", name=missing), Say("grade.needs_saw"))]
            else:
                problems = await self._scenario(grading, scenario)
            if not problems:
                passed.add(scenario.name)
            shown = [
                [
                    *(wanted.text(each) for each in ("zh", "en")),
                    *(saw.text(each) if saw else "" for each in ("zh", "en")),
                ]
                for wanted, saw in problems
            ]
            told(scenario=scenario.name, ok=not problems, problems=shown, seconds=round(time.monotonic() - began, 2))

    async def _scenario(self, grading: Grading, scenario: Scenario) -> list[tuple[Say, Say | None]]:
        """Play one; what was wanted and seen instead, nothing if it passed."""
        values = scenario.drawn(f"{self._seed}/{grading.lesson}")
        for name, patterns in scenario.files.items():
            found = self._file(patterns)
            if found is None:
                return [(Say("grade.no_file", patterns=patterns), Say("grade.no_file_saw"))]
            values[name] = found
        live = Live(self._desk, self._session, grading.path.parent)
        stage = GraderStage(live, self._session, self._built)
        checks = [made for each in scenario.check if isinstance(made := condition_of(filled(each, values)), Condition)]
        try:
            await stage.perform(filled(list(scenario.before), values))
            live.begin_step()
            # Those that listen have to do so before there is anything to hear.
            self._look(live, checks)
            await stage.perform(filled(list(scenario.run), values))
            verdicts = await self._judged(live, checks, scenario.within)
            wrong = [(verdict.wanted, verdict.saw) for verdict in verdicts if not verdict.ok]
            if wrong:
                wrong[0] = (wrong[0][0], self._with_output(live, wrong[0][1]))
            return wrong
        except NotPlayed as problem:
            return [(problem.wanted, self._with_output(live, problem.saw))]
        except Exception as error:
            # A scenario with a mistake of its author must not take the others with it.
            reason = f"{type(error).__name__}: {error}"[:200]
            return [(Say("grade.ended.problem"), Say("grade.ended.problem_saw", reason=reason))]
        finally:
            await self._clear(live)

    def _file(self, patterns: tuple[str, ...]) -> str | None:
        for pattern in patterns:
            for path in sorted(self._desk.home.glob(pattern[2:])):
                if path.is_file() and not path.is_symlink():
                    return f"~/{path.relative_to(self._desk.home).as_posix()}"
        return None

    async def _judged(self, live: Live, checks: list[Condition], within: float) -> list[Verdict]:
        """Look until all hold at once, the time is over, or nothing of the pupil's runs any more."""
        waited = idle = 0.0
        while True:
            verdicts = self._look(live, checks)
            if all(verdict.ok for verdict in verdicts) or waited >= within or idle >= IDLE_SECONDS:
                return verdicts
            idle = 0.0 if live.running() else idle + LOOK
            await self._session.sleep(LOOK)
            waited += LOOK

    def _look(self, live: Live, checks: list[Condition]) -> list[Verdict]:
        return [check.judge(live) for check in checks]

    @staticmethod
    def _with_output(live: Live, saw: Say | None) -> Say | None:
        """What was seen, with the end of what the pupil's program printed."""
        runs = live.runs(live.lesson_began_ns)
        text = tail(plain_output(runs[-1])) if runs else ""
        if not text:
            return saw
        printed = Say("grade.printed", text=text)
        return Say("grade.both", first=saw, second=printed) if saw is not None else printed

    async def _clear(self, live: Live) -> None:
        """End everything that this scenario started, as closing the machine would."""
        mine = [program for program in self._desk.programs.values() if program.pid != self._session.pid]
        for end in ("interrupt", "kill"):
            for program in mine:
                if program.status is None:
                    program.resume()
                    getattr(program, end)()
            await self._session.until(partial(_have_ended, mine), ENDING_SECONDS, LOOK)
            mine = [program for program in self._desk.programs.values() if program.pid != self._session.pid]
        self._desk.terminals.clear()
        live.close()


def _have_ended(programs: list[Program]) -> bool:
    return all(program.status is not None for program in programs)
