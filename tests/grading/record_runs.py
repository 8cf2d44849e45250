"""Writes `recorded_runs.jsonl` anew: `python -m tests.grading.record_runs [WORD…]` plays submissions for real, some at a time.

With words only the submissions whose names begin with one of them; the others stay as they are. To be run by hand, after
forgeries, scenarios, or what checks ask a machine for have changed. There is no shield around them (`ATTACKS` are left out).
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any

from tests import conftest as surroundings

# isort: split
from tests.grading.article import write
from tests.grading.recorded_runs import RECORDED, SEED, Submission, graded_again, otherwise, submissions
from tests.support.recorded_live import RecordingLive, compact, read_lines, said, same_everywhere, write_lines

AT_A_TIME = 3
LONGEST = 400.0
"""Seconds for one submission."""

_grading_again = threading.Lock()


def play_one(submission: Submission) -> Any:
    """Play the scenarios of a submission in this process and return what was seen of each."""
    from day6_core.lessons.grading import play
    from day6_core.lessons.grading.archive import unpack
    from day6_core.lessons.grading.stage import GraderStage, NotPlayed
    from day6_core.ros.environment import activate
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk

    work = Path(tempfile.mkdtemp(prefix="d6-"))
    home = work / "home"
    for name in ("home", "run", "tmp"):
        (work / name).mkdir()
    folders = {"HOME": str(home), "DAY6_RUNTIME_DIR": str(work / "run"), "ROS_LOG_DIR": str(work / "tmp")}
    surroundings.set_environment({**surroundings.environment(), **folders})
    del os.environ["DAY6_LINK"]
    unpack(write(work / "submission.zip", submission.files), home)
    activate()
    runs: list[Any] = []
    events: list[Any] = []

    class RecordedStage(GraderStage):
        """Notes each action, with a moment for each wait and the terminal of each build."""

        _live: RecordingLive

        async def perform(self, actions: Any) -> None:
            for action in actions:
                name = next(iter(action))
                told: dict[str, Any] = {"do": name}
                try:
                    await super().perform([action])
                except NotPlayed as problem:
                    told["problem"] = [said(problem.wanted, home), said(problem.saw, home)]
                    raise
                finally:
                    if name not in ("wait", "build"):
                        events.append(told)

        async def _do_wait(self, given: object) -> None:
            condition: Any = play.condition_of(given)
            try:
                await super()._do_wait(given)
            finally:
                self._live.forget()
                verdict = condition.judge(self._live)
                events.append({"do": "wait", "moment": self._live.moment([verdict], ("terminals",))})

        async def _build(self, name: str) -> None:
            try:
                await super()._build(name)
            finally:
                moment = self._live.moment([], ("terminals", "files"))
                events.append({"do": "build", "terminals": moment["terminals"], "files": moment["files"]})

    class RecordedPlay(play.Play):
        """Notes each look after which something else holds, and the last one."""

        async def _scenario(self, grading: Any, scenario: Any) -> Any:
            events.clear()
            self._last: Any = None
            live = RecordingLive(self._desk, self._session, grading.path.parent)
            files = live.moment([], ("files",))["files"]
            outcome = await super()._scenario(grading, scenario)
            shown = [[said(each, home) for each in pair] for pair in outcome.problems]
            runs.append({"scenario": scenario.name, "files": files, "events": list(events), "problems": shown})
            return outcome

        def _look(self, live: Any, checks: Any) -> Any:
            live.forget()
            verdicts = super()._look(live, checks)
            now = live.signature(checks, verdicts)
            if now != self._last:
                self._last = now
                self._take(live, verdicts)
            return verdicts

        async def _judged(self, live: Any, checks: Any, within: float) -> Any:
            self._last = None
            verdicts = await super()._judged(live, checks, within)
            if not all(verdict.ok for verdict in verdicts):  # time is over: what was seen last is what is told
                self._take(live, verdicts)
            return verdicts

        @staticmethod
        def _take(live: Any, verdicts: Any) -> None:
            events.append({"do": "look", "moment": live.moment(verdicts, ("terminals",))})

    play.Live, play.GraderStage = RecordingLive, RecordedStage  # type: ignore[misc]
    desk = Desk(home, domain_id=0)
    done = threading.Event()

    async def main(session: Session) -> int:
        session.background = True
        try:
            judge = RecordedPlay(desk, session, SEED)
            for grading in submission.gradings:
                await judge.grading(grading, lambda **_: None)
        finally:
            done.set()
        return 0

    desk.start()
    desk.start_unseen("grade", main)
    done.wait(LONGEST)
    return same_everywhere(runs, home)


def record(submission: Submission) -> Any:
    """Play one in a process of its own, which is ended with all that it started."""
    command = [sys.executable, "-m", "tests.grading.record_runs", "--one", submission.name]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, start_new_session=True)
    try:
        text, _ = child.communicate(timeout=LONGEST)
    finally:
        with suppress(ProcessLookupError):
            os.killpg(child.pid, signal.SIGKILL)
    with _grading_again, tempfile.TemporaryDirectory(prefix="d6-") as home:
        kept = compact(json.loads(text), lambda told: otherwise(submission, told))
        graded = graded_again(submission, kept, Path(home))
    for run in kept:
        now = graded[run["scenario"]]
        run["problems"], looks = now.problems, iter(now.looks)
        for event in run["events"]:
            if event["do"] == "look":
                event["moment"]["verdicts"] = next(looks)
    return {"submission": submission.name, "fingerprint": submission.fingerprint, "runs": kept}


def main() -> int:
    words = tuple(sys.argv[1:])
    every = submissions()
    if words[:1] == ("--one",):
        told = play_one(next(each for each in every if each.name == words[1]))
        print(json.dumps(told), flush=True)
        os._exit(0)
    chosen = [each for each in every if not words or each.name.startswith(words)]
    recorded = {each["submission"]: each for each in (read_lines(RECORDED) if RECORDED.exists() else ())}
    failed = 0

    def one(submission: Submission) -> tuple[str, Any]:
        try:
            return submission.name, record(submission)
        except (ValueError, subprocess.TimeoutExpired) as error:
            return submission.name, error

    with ThreadPoolExecutor(AT_A_TIME) as pool:
        for name, told in pool.map(one, chosen):
            if isinstance(told, Exception):
                failed += 1
                print(f"{name}: {told}"[:3000], flush=True)
                continue
            recorded[name] = told
            write_lines(RECORDED, [recorded[each.name] for each in every if each.name in recorded])
            passed = [run["scenario"] for run in told["runs"] if not run["problems"]]
            print(f"{name}: {len(told['runs'])} scenarios, passed: {', '.join(passed) or '-'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
