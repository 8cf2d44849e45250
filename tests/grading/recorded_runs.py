"""The scenarios of submissions as they once were played, graded again: by the real `Play`, with what was written down.

`recorded_live.py` says how; `record_runs.py` writes it.
"""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from collections import deque
from collections.abc import Coroutine, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType, SimpleNamespace
from typing import Any, NamedTuple

from day6_core.lessons.checks import Condition, Verdict
from day6_core.lessons.grading import play
from day6_core.lessons.grading.marks import Outcome
from day6_core.lessons.grading.scenarios import Grading, gradings
from day6_core.lessons.grading.stage import GraderStage, NotPlayed
from day6_core.lessons.live import Live
from tests.grading.forgeries import GROUPS, Forgery, together
from tests.grading.solutions import OTHERWISE
from tests.support.recorded_live import BEGAN_NS, Json, ToldDesk, ToldLive, keys_of, said, say_of, verdict_json

RECORDED = Path(__file__).with_name("recorded_runs.jsonl")
"""One submission a line."""

SEED = "recorded"
GOOD = "good"
"""The submission that is as a good pupil hands it in: all its scenarios are played."""

ATTACKS = {
    "listener: reads the words from the grader's memory": "reads the memory of all processes",
    "listener: writes verdicts into all open files of the others": "writes into what all processes have open",
    "talker: kills its parents": "ends the judge itself",
}
"""Forgeries that are not recorded, because they attack the judge's process, not its checks: played behind the shield only."""


class Submission(NamedTuple):
    """What is handed in: the forgeries in it, and the scenarios that are played for them; or what is right in another way."""

    name: str
    forgeries: tuple[Forgery, ...]
    gradings: tuple[Grading, ...]
    otherwise: Mapping[str, str | None] = MappingProxyType({})

    @property
    def files(self) -> dict[str, str | None]:
        """The files that are not as in the good one."""
        return {**self.otherwise, **{name: text for each in self.forgeries for name, text in each.files.items()}}

    @property
    def fingerprint(self) -> str:
        """Another one wherever another forgery or scenario would have to be played; titles change nothing of that."""
        scenarios = [repr(replace(each, line=0, title={})) for grading in self.gradings for each in grading.scenarios]
        return hashlib.sha256(json.dumps([self.files, scenarios], sort_keys=True).encode()).hexdigest()[:16]


def submissions() -> list[Submission]:
    """The good one, and those of `test_forgeries.py` without attacks."""
    every = gradings()
    found = [Submission(GOOD, (), tuple(every))]
    for name, (lessons, files) in OTHERWISE.items():
        found.append(Submission(f"{GOOD} {name}", (), tuple(each for each in every if each.lesson in lessons), files))
    for group, (lessons, _) in GROUPS.items():
        for number, spoiled in enumerate(together(group)):
            forgeries = tuple(each for each in spoiled if each.id not in ATTACKS)
            chosen = tuple(_needed(each, forgeries) for each in every if each.lesson in lessons)
            if forgeries:
                found.append(
                    Submission(f"{group}-{number}", forgeries, tuple(each for each in chosen if each.scenarios))
                )
    return found


def _needed(grading: Grading, forgeries: Sequence[Forgery]) -> Grading:
    """The scenarios that are spoiled, and those that these need."""
    names = {each.scenario for each in forgeries if each.lesson == grading.lesson}
    for scenario in reversed(grading.scenarios):
        if scenario.name in names:
            names |= set(scenario.needs)
    return replace(grading, scenarios=tuple(each for each in grading.scenarios if each.name in names))


class Graded(NamedTuple):
    """How a scenario went: what was wanted and seen instead, what each look at the checks saw."""

    problems: list[Json]
    looks: list[Json]
    outcome: Outcome


def graded_again(
    submission: Submission, runs: Sequence[Json], home: Path, told: play.Told = lambda **_: None
) -> dict[str, Graded]:
    """Grade what was written down of each scenario, by the scenario's name; `told` hears what the grader would."""
    found: dict[str, Graded] = {}
    with _told():
        desk = _Desk(home)
        judge = _Play(desk, found, {run["scenario"]: run for run in runs})
        for grading in submission.gradings:
            _finish(judge.grading(grading, told))
    return found


@contextmanager
def _told() -> Iterator[None]:
    before = play.Live, play.GraderStage
    play.Live, play.GraderStage = ToldLive, _Stage  # type: ignore[misc]
    try:
        yield
    finally:
        play.Live, play.GraderStage = before  # type: ignore[misc]


def _finish(work: Coroutine[Any, Any, None]) -> None:
    """Run what waits for nothing real."""
    try:
        work.send(None)
    except StopIteration:
        return
    raise AssertionError("it waits for something")


class _Session:
    """The judge's own program, for which time does not matter."""

    pid = 1

    async def sleep(self, seconds: float) -> None:
        """What happens meanwhile is in the next moment."""

    async def until(self, holds: Any, *_: float) -> bool:
        return bool(holds())

    def spawn(self, work: Coroutine[Any, Any, None]) -> Any:
        """No machine can be late here."""
        work.close()
        return SimpleNamespace(cancel=lambda: None)


class _Desk(ToldDesk):
    """The machine, with what was written down of the scenario that is played."""

    def __init__(self, home: Path) -> None:
        super().__init__(home)
        self.events: deque[Json] = deque()

    def next(self, what: str) -> Json:
        """What happened next in this scenario, which has to be this."""
        event = self.events.popleft()
        assert event["do"] == what, (event["do"], what)
        return event

    def open_terminal(self) -> Any:
        """The terminal in which a package was built."""
        self.terminals.append(self.built)
        return self.built


class _Stage(GraderStage):
    """Does nothing: waiting and building are judged by what was written down, the rest went as it went."""

    _live: ToldLive

    def _next(self, what: str) -> None:
        event = self._live.desk.next(what)  # type: ignore[attr-defined]
        if "problem" in event:
            wanted, saw = map(say_of, event["problem"])
            assert wanted is not None
            raise NotPlayed(wanted, saw)

    async def _do_type(self, lines: str) -> None:
        self._next("type")

    async def _do_pause(self, seconds: float) -> None:
        self._next("pause")

    async def _do_start(self, given: Any) -> None:
        self._next("start")

    async def _do_publish(self, given: Any) -> None:
        self._next("publish")

    async def _do_call(self, given: Any) -> None:
        self._next("call")

    async def _do_wait(self, given: object) -> None:
        self._live.show(self._live.desk.next("wait")["moment"])  # type: ignore[attr-defined]
        await super()._do_wait(given)

    async def _build(self, name: str) -> None:
        desk: Any = self._live.desk
        event = desk.next("build")
        self._live.lay(event["files"])
        if event["terminals"]:
            desk.built = self._live.terminal(event["terminals"][-1])
            desk.built.run_line = lambda line: None
        await super()._build(name)


class _Play(play.Play):
    def __init__(self, desk: _Desk, found: dict[str, Graded], runs: Mapping[str, Json]) -> None:
        made: Any = desk
        session: Any = _Session()
        super().__init__(made, session, SEED)
        self._told, self._found, self._runs = desk, found, runs
        self._looks: list[Json] = []

    async def _scenario(self, grading: Grading, scenario: Any) -> Any:
        run, home = self._runs[scenario.name], self._told.home
        self._told.events, self._looks = deque(run["events"]), []
        self._told.now_ns = BEGAN_NS
        _lay(home, run["files"])
        outcome = await super()._scenario(grading, scenario)
        problems = [[said(each, home) for each in pair] for pair in outcome.problems]
        self._found[scenario.name] = Graded(problems, self._looks, outcome)
        return outcome

    def _look(self, live: Live, checks: list[Condition]) -> list[Verdict]:
        """Look at the next moment, at the last one again and again."""
        events = self._told.events
        is_new = bool(events) and events[0]["do"] == "look"
        if is_new:
            assert isinstance(live, ToldLive)
            live.show(events.popleft()["moment"])
        verdicts = super()._look(live, checks)
        if is_new:
            self._looks.append([verdict_json(each, self._told.home) for each in verdicts])
        return verdicts


def _lay(home: Path, files: Json) -> None:
    """Make the home folder what it was when the scenario began."""
    ToldLive(ToldDesk(home), None, home).lay(files)


def shape(told: Json) -> Json:
    """Of what was said the keys of the texts only."""
    if isinstance(told, dict):
        inner = {name: shape(each) for name, each in told.items() if name != "say" and isinstance(each, dict)}
        return [told["say"], inner]
    return [shape(each) for each in told] if isinstance(told, list) else told


def reasons(problems: list[Json]) -> str:
    """What a teacher reads."""
    texts = [say.text("en") for pair in problems for say in map(say_of, pair) if say is not None]
    return " ".join(texts)


def otherwise(submission: Submission, runs: Sequence[Json]) -> list[Json]:
    """What is graded otherwise than it was on the machine, or for another reason than forgeries have."""
    with tempfile.TemporaryDirectory(prefix="d6-") as home:
        graded = graded_again(submission, runs, Path(home))
    wrong: list[Json] = []
    for run in runs:
        name = run["scenario"]
        if name not in graded:  # what it needs has not passed
            wrong.append([name, "not played"])
            continue
        now, looks = graded[name], [each["moment"]["verdicts"] for each in run["events"] if each["do"] == "look"]
        if shape(now.problems) != shape(run["problems"]):
            wrong.append([name, run["problems"], now.problems])
        if list(map(keys_of, now.looks)) != list(map(keys_of, looks)):
            wrong.append([name, looks, now.looks])
    for forgery in submission.forgeries:
        problems = graded[forgery.scenario].problems if forgery.scenario in graded else []
        if not problems or not re.search(forgery.reason, reasons(problems)):
            wrong.append([forgery.id, forgery.reason, problems])
    return wrong
