"""Grades many submissions, each behind a warden of its own, and gathers what was seen. Nothing a submission claims is used."""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

from day6_core.lessons.catalogue import days
from day6_core.lessons.document import Lesson
from day6_core.lessons.grading import shield
from day6_core.lessons.grading.grades import ANSWERS, Grade, Graded
from day6_core.lessons.grading.limits import OVER
from day6_core.lessons.grading.marks import Mark, Seen, both
from day6_core.lessons.grading.scenarios import Grading, longest
from day6_core.lessons.texts import Say
from day6_core.virtual.surroundings import is_there

WARDEN = "day6_core.lessons.grading.warden"
PATIENCE = 10.0
"""Seconds that a warden gets beyond its submission's, before it is ended too."""

OWN_SHARE = 4
"""How many times as long it is given in virtual time, where it counts only what a submission takes itself on a busy machine."""

MOST_READY = 8
"""Interpreters, for one submission."""

LARGEST_REPORT = 2_000_000


def _folder() -> str:
    """Make a folder with a short name, as it holds sockets. Raises OSError."""
    if os.name == "posix":
        with contextlib.suppress(OSError):  # in a cell it may be closed although its mode says otherwise
            return tempfile.mkdtemp(prefix="d6g-", dir="/tmp")
    own = os.environ.get("DAY6_RUNTIME_DIR", tempfile.gettempdir())
    for number in itertools.count():
        with contextlib.suppress(FileExistsError):
            os.mkdir(folder := f"{own}/g{number}", 0o700)
            return folder
    raise AssertionError


def right_answers(lessons: Iterable[str]) -> dict[str, dict[str, str]]:
    """The right letters of the questions of these lessons, by lesson and step."""
    wanted = set(lessons)
    return answers_of(lesson for lesson in days() if lesson.name in wanted)


def answers_of(lessons: Iterable[Lesson]) -> dict[str, dict[str, str]]:
    """The right letters of the questions of lessons, by lesson and step."""
    found = {}
    for lesson in lessons:
        letters = {
            step.name: str(check.arguments.get("letter", ""))
            for step in lesson.steps
            for check in step.checks
            if check.name == "answer"
        }
        found.update({lesson.name: letters} if letters else {})
    return found


def _users() -> tuple[Iterator[int | None], Path | None]:
    """Whose submissions are, one after the other, and the folder that keeps root from giving them away."""
    if sys.platform != "linux" or os.geteuid() != 0:
        return itertools.repeat(None), None
    from day6_core.isolation import users

    if (closed := users.cannot_run_python(users.FOR_GRADING[0])) is not None:
        return itertools.repeat(None), closed
    first = os.getpid() % len(users.FOR_GRADING)  # another grader's are others
    return itertools.cycle([*users.FOR_GRADING[first:], *users.FOR_GRADING[:first]]), None


class Grader:
    """Grades submissions with the same scenarios and the same drawn values."""

    def __init__(
        self,
        gradings: list[Grading],
        *,
        seconds: float | None = None,
        seed: str = "",
        shielded: bool = True,
        virtual: bool = True,
        answers: Mapping[str, Mapping[str, str]] | None = None,
        hidden: Iterable[Path] = (),
    ) -> None:
        """`hidden`: folders in which no program of a submission finds anything; no submission finds another, either.

        `virtual`: in virtual time, where there is any.
        """
        self.seed = seed or secrets.token_hex(8)
        self._gradings = gradings
        self._hidden = set(map(os.path.realpath, hidden))
        self._texts = [(str(each.path.absolute()), each.path.read_bytes().decode()) for each in gradings]
        self._users: Iterator[int | None] | None = None
        self.closed: Path | None = None
        """The folder because of which programs of submissions run as root."""
        self._seconds = longest(gradings) if seconds is None else seconds
        self._virtual = virtual and is_there()
        self._shield = shield.Shield.WHOLE if shielded else shield.Shield.NONE
        self._given_answers = answers
        self._wardens: set[_Warden] = set()
        self._free: list[_Warden] = []
        """Those of them that have nothing to do."""
        self._lock = threading.Lock()
        self._stopped = False
        self._programs = min(MOST_READY, sum(len(each.scenarios) for each in gradings))
        """So many interpreters are made ready for a submission: the most that one has needed, at first a guess."""

    def grade(
        self,
        files: list[Path],
        jobs: int,
        told: Callable[[Graded], None] = lambda _: None,
        again: Callable[[int], None] = lambda _: None,
    ) -> list[Graded]:
        """Grade all, `jobs` at a time. Blocks.

        What the machine was too busy for is played again, one submission after the other when all others are done; `again` hears
        how many these are. `told` hears of each when it is done, for most of them on another thread.
        """

        self._hidden |= set(map(os.path.realpath, files))

        def one(file: Path) -> Graded:
            graded = Graded(file, results=self._empty())
            self._play(graded)
            if not graded.lagged:
                told(graded)
            return graded

        with ThreadPoolExecutor(max_workers=jobs) as pool:
            try:
                found = list(pool.map(one, files))
                lagged = [graded for graded in found if graded.lagged]
                if lagged:
                    again(len(lagged))
                for graded in lagged:
                    self._again(graded)
                    told(graded)
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                self.stop()
                raise
            while self._free:
                self._end(self._free.pop())
        return found

    @cached_property
    def _answers(self) -> Mapping[str, Mapping[str, str]]:
        """The right ones; read when the first submission is there, as wardens need longer to begin."""
        if self._given_answers is not None:
            return self._given_answers
        return right_answers(each.lesson for each in self._gradings)

    def stop(self) -> None:
        """End all wardens, and with them everything they keep."""
        self._stopped = True
        with self._lock:
            for warden in self._wardens:
                warden.kill()

    def _again(self, graded: Graded) -> None:
        """Play once more what the machine was too busy for, and what had to wait for that."""
        only: dict[str, list[str]] = {}
        passed: dict[str, list[str]] = {}
        lagged = graded.lagged
        for at, result in enumerate(graded.results):
            if result in lagged or result.mark is Mark.UNPLAYED:
                only.setdefault(result.lesson, []).append(result.scenario)
                graded.results[at] = Grade(result.lesson, result.scenario, result.title, stall=result.stall)
            elif result.passed:
                passed.setdefault(result.lesson, []).append(result.scenario)
        graded.ended, graded.stalls = "", []
        self._play(graded, only, passed)
        for result in graded.lagged:
            asked, seen = Say("grade.busy"), Say("grade.busy_saw", seconds=f"{result.stood_still:g}")
            result.conclude(Mark.UNPLAYED, asked, seen)

    def _play(
        self,
        graded: Graded,
        only: Mapping[str, list[str]] | None = None,
        passed: Mapping[str, list[str]] = MappingProxyType({}),
    ) -> None:
        """Play all scenarios of a submission, or `only` these where those have `passed` before."""
        began = time.monotonic()
        work = _folder()
        try:
            for said in self._said(graded.file, {"work": work, "only": only, "passed": dict(passed)}):
                self._take(graded, said)
        finally:
            shutil.rmtree(work, ignore_errors=True)
        ended = time.monotonic()
        graded.seconds = round(graded.seconds + ended - began, 1)
        self._conclude(graded, [each for each in graded.results if _is_among(each, only)], ended)

    def _user(self) -> int | None:
        """Whose the next submission is; None: of the user who grades."""
        with self._lock:
            if self._users is None:
                self._users, self.closed = _users()
            return next(self._users)

    def _empty(self) -> list[Grade]:
        return [
            Grade(grading.lesson, scenario.name, scenario.title, stall=scenario.stall)
            for grading in self._gradings
            for scenario in grading.scenarios
        ]

    def _said(self, file: Path, chosen: Mapping[str, Any]) -> list[dict[str, Any]]:
        """What the warden and the judge said about one submission."""
        job = {
            "archive": str(file.absolute()), "seconds": self._seconds, "shield": self._shield.value, "user": self._user(),
            "hidden": sorted(self._hidden), "programs": self._programs, "work": chosen["work"],
        }  # fmt: skip
        secret = {name: chosen[name] for name in ("only", "passed")} | {"seed": self.seed, "gradings": self._texts}
        warden = self._warden()
        if warden is None:
            return []
        end = threading.Timer(self._seconds * (OWN_SHARE if self._virtual else 1) + PATIENCE, warden.kill_group)
        end.daemon = True
        end.start()
        try:
            text, is_over = warden.report(job, secret)
        finally:
            end.cancel()
        if is_over:
            self._free.append(warden)
        else:
            self._end(warden)
        return _lines(text)

    def _warden(self) -> _Warden | None:
        """One that has nothing to do; None when all is to end."""
        with self._lock:
            if self._stopped:
                return None
            if self._free:
                return self._free.pop()
            warden = _Warden(virtual=self._virtual)
            self._wardens.add(warden)
            return warden

    def _end(self, warden: _Warden) -> None:
        warden.end()
        with self._lock:
            self._wardens.discard(warden)

    def _take(self, graded: Graded, said: dict[str, Any]) -> None:
        if "refused" in said:
            graded.refused, graded.results = said["refused"], []
        elif "pupil" in said:
            graded.pupil = said["pupil"]
            if not any(each.scenario == ANSWERS for each in graded.results):
                self._judge_answers(graded, said["answers"])
        elif "scenario" in said:
            for result in graded.results:
                if (result.lesson, result.scenario) == (said["lesson"], said["scenario"]):
                    result.note(said)
        elif "ended" in said:
            graded.ended = graded.ended or said["ended"]
            graded.stalls = said.get("stalls", [])
            graded.shielded = said["shield"] == shield.Shield.WHOLE.value
        elif "done" in said:
            self._programs = min(MOST_READY, max(self._programs, said["programs"]))
        elif "problem" in said:
            graded.ended, graded.problem = "problem", str(said["problem"])

    def _judge_answers(self, graded: Graded, given: Mapping[str, Mapping[str, str]]) -> None:
        """Compare the last letter that was chosen at each question with the lesson's."""
        for lesson, letters in self._answers.items():
            wrong = [name for name, letter in letters.items() if given.get(lesson, {}).get(name, "")[-1:] != letter]
            right = len(letters) - len(wrong)
            result = Grade(lesson, ANSWERS, both(Say("grade.answers_title")), Mark.WRONG if wrong else Mark.RIGHT)
            result.points = round(right / len(letters), 2)
            saw = Say("grade.answers_saw", right=right, all=len(letters), names=tuple(wrong)) if wrong else None
            result.checks = [Seen(Say("grade.answers", names=tuple(letters)), saw, ok=not wrong).data()]
            graded.results.append(result)

    def _conclude(self, graded: Graded, played: list[Grade], ended: float) -> None:
        """Say of what was not played to its end why it was not, and of everything whether the machine kept up."""
        values = {
            "seconds": f"{self._seconds:g}", "most": shield.MOST_PROCESSES, "megabytes": shield.MOST_MEMORY // 2**20,
            "reason": graded.problem,
        }  # fmt: skip
        how = graded.ended if graded.ended in ("time", "processes", "memory", "problem") else "killed"
        wanted, saw = Say(f"grade.ended.{how}", **values), Say(f"grade.ended.{how}_saw", **values)
        mark = {"time": Mark.LATE, "problem": Mark.UNPLAYED}.get(how, Mark.WRONG)
        for result in played:
            if result.ended is None and result.scenario != ANSWERS:
                result.conclude(Mark.UNPLAYED if result.began is None else mark, wanted, saw)
            result.look_for_lag(graded.stalls, ended)


class _Warden:
    """A process that judges one submission after the other."""

    def __init__(self, *, virtual: bool) -> None:
        words, env = _command(virtual=virtual)
        self._jobs, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(
                words,
                env=env,
                stdin=theirs.fileno(),
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )

    @property
    def pid(self) -> int:
        return self._process.pid

    def report(self, job: Mapping[str, Any], secret: Mapping[str, Any]) -> tuple[bytes, bool]:
        """Return what it says of a job, and whether it is there for another one. Only the judge reads what is `secret`."""
        if sys.platform == "win32":
            raise NotImplementedError  # nothing is graded there: `command.main` says so
        assert self._process.stdout is not None
        with contextlib.suppress(ConnectionError), tempfile.TemporaryFile() as file:
            file.write(json.dumps(secret).encode())
            file.seek(0)
            line = json.dumps(job).encode() + b"\n"
            sent = socket.send_fds(self._jobs, [line], [file.fileno()])
            self._jobs.sendall(line[sent:])
        found: list[bytes] = []
        left = LARGEST_REPORT
        while line := self._process.stdout.readline(LARGEST_REPORT):
            if line == OVER:
                return b"".join(found), True
            found.append(line[:left])
            left -= len(found[-1])
        return b"".join(found), False

    def end(self) -> None:
        """Let it end that has nothing to do any more, or has ended already."""
        self._jobs.close()
        self._process.communicate()

    def kill(self) -> None:
        """Kill it alone, and with it what it keeps, where the system does that."""
        with contextlib.suppress(ProcessLookupError):
            self._process.kill()

    def kill_group(self) -> None:
        """Kill it and all that it has started."""
        if sys.platform != "win32":
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self.pid, signal.SIGKILL)


def _command(*, virtual: bool) -> tuple[list[str], dict[str, str] | None]:
    """Return what runs a warden, and its variables; None: all that there are."""
    if sys.platform == "linux" and virtual:
        from day6_core.lessons.grading.warden import environment
        from day6_core.virtual.ready import forks

        return forks.command(WARDEN), forks.environment(environment())
    return [sys.executable, "-I", "-m", WARDEN], None


def _is_among(result: Grade, only: Mapping[str, list[str]] | None) -> bool:
    return only is None or result.scenario in only.get(result.lesson, ())


def _lines(text: bytes) -> list[dict[str, Any]]:
    """The whole lines of JSON; a judge that was ended may have left half of one."""
    found = []
    for line in text.split(b"\n"):
        with contextlib.suppress(ValueError):
            said = json.loads(line)
            if isinstance(said, dict):
                found.append(said)
    return found
