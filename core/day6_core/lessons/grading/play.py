"""Plays the hidden scenarios of a lesson with one submission, one after the other, on one machine."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from dataclasses import replace
from functools import partial

from day6_core.lessons.actions import filled
from day6_core.lessons.checks import Condition, Verdict, condition_of
from day6_core.lessons.checks.terminals import plain_output
from day6_core.lessons.grading.limits import ENDING_SECONDS, IDLE_SECONDS
from day6_core.lessons.grading.marks import Mark, Outcome, Seen, points
from day6_core.lessons.grading.scenarios import Grading, Scenario
from day6_core.lessons.grading.stage import GraderStage, NotPlayed, tail
from day6_core.lessons.lag import Lag
from day6_core.lessons.live import Live
from day6_core.lessons.texts import Say
from day6_core.reason import fault
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.shell.desk import Desk

LOOK = 0.1
Told = Callable[..., None]


class Play:
    """One submission's way through the scenarios. Runs as a program of the machine.

    `taken` tells for how many seconds the cores have worked for programs of the submission.
    """

    def __init__(self, desk: Desk, session: Session, seed: str, taken: Callable[[], float] = lambda: 0.0) -> None:
        self._desk = desk
        self._session = session
        self._seed = seed
        self._taken = taken
        self._cpu = 0.0
        self._built: dict[str, NotPlayed | None] = {}
        self._held: dict[int, float] = {}
        """The seconds at which those checks began to hold that hold now, by their places."""

    async def grading(
        self, grading: Grading, told: Told, passed: Collection[str] = (), only: Collection[str] | None = None
    ) -> None:
        """Play all scenarios of a file, or `only` these; `told` hears of each when it begins and when it is done.

        `passed` are those that have passed already.
        """
        right = set(passed)
        for scenario in grading.scenarios:
            if only is not None and scenario.name not in only:
                continue
            lag, took = Lag(), self._taken()
            self._cpu = took
            began = time.monotonic()
            told(scenario=scenario.name, began=began)
            missing = next((each for each in scenario.needs if each not in right), None)
            if missing is not None:
                needed = Seen(Say("grade.needs", name=missing), Say("grade.needs_saw"))
                outcome = Outcome(Mark.UNPLAYED, [needed], timed=False)
            else:
                with lag.watched(self._session):
                    outcome = await self._scenario(grading, scenario)
            if outcome.mark is Mark.RIGHT:
                right.add(scenario.name)
            ended = time.monotonic()
            told(
                scenario=scenario.name, mark=outcome.mark.value, points=outcome.points,
                checks=[each.data() for each in outcome.checks], seconds=round(ended - began, 2), ended=ended,
                lag=[lag.worst, lag.total], timed=outcome.timed, cpu=self._cpu - took,
            )  # fmt: skip

    async def _scenario(self, grading: Grading, scenario: Scenario) -> Outcome:
        """Play one."""
        values = scenario.drawn(f"{self._seed}/{grading.lesson}")
        for name, patterns in scenario.files.items():
            found = self._file(patterns)
            if found is None:
                missing = Seen(Say("grade.no_file", patterns=patterns), Say("grade.no_file_saw"))
                return Outcome(Mark.WRONG, [missing], timed=False)
            values[name] = found
        live = Live(self._desk, self._session, grading.path.parent)
        stage = GraderStage(live, self._session, self._built)
        checks = [made for each in scenario.check if isinstance(made := condition_of(filled(each, values)), Condition)]
        try:
            await stage.perform(filled(list(scenario.before), values))
            live.begin_step()
            self._held = {}
            # Those that listen have to do so before there is anything to hear.
            before = self._look(live, checks)
            await stage.perform(filled(list(scenario.run), values))
            verdicts = await self._judged(live, checks, scenario.within)
            if not scenario.run:
                before = [replace(each, ok=False) for each in before]
            return self._outcome(live, verdicts, points(checks, verdicts, before, scenario.must), bool(scenario.run))
        except NotPlayed as problem:
            seen = [Seen(problem.wanted, self._with_output(live, problem.saw))]
            return Outcome(problem.mark, seen, timed=problem.timed)
        except Exception as error:
            # A scenario with a mistake of its author must not take the others with it.
            reason = fault(error)[:200]
            broken = Seen(Say("grade.ended.problem"), Say("grade.ended.problem_saw", reason=reason))
            return Outcome(Mark.UNPLAYED, [broken], timed=False)
        finally:
            self._cpu = self._taken()
            await self._clear(live)

    def _outcome(self, live: Live, verdicts: list[Verdict], part: float, timed: bool) -> Outcome:
        """What the last look at the checks is marked with."""
        seen = [
            Seen(each.wanted, each.saw, each.where, each.ok, self._held.get(at)) for at, each in enumerate(verdicts)
        ]
        wrong = [at for at, each in enumerate(verdicts) if not each.ok]
        if not wrong:
            return Outcome(Mark.RIGHT, seen, 1.0)
        first = wrong[0]
        seen[first] = replace(seen[first], seen=self._with_output(live, seen[first].seen))
        late = bool(live.running()) and all(verdicts[at].going for at in wrong)
        cheated = any(each.cheated for each in verdicts)  # no machine is to blame for that
        return Outcome(Mark.LATE if late else Mark.WRONG, seen, part, timed and not cheated)

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
            seconds = round((live.now_ns() - live.step_began_ns) / 1e9, 1)
            self._held = {at: self._held.get(at, seconds) for at, verdict in enumerate(verdicts) if verdict.ok}
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
