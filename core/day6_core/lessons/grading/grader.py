"""Grades many submissions, each behind a warden of its own, and gathers what was seen. Nothing a submission claims is used."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.lessons.catalogue import days
from day6_core.lessons.grading import shield
from day6_core.lessons.grading.limits import SECONDS
from day6_core.lessons.grading.scenarios import Grading
from day6_core.lessons.texts import Say

WARDEN = "day6_core.lessons.grading.warden"
PATIENCE = 10.0
"""Seconds that a warden gets beyond its submission's, before it is ended too."""

LARGEST_REPORT = 2_000_000
ANSWERS = "answers"


@dataclass
class Grade:
    """How one scenario went: `problems` are what was wanted and what was seen instead, each as {language: text}."""

    lesson: str
    scenario: str
    title: Mapping[str, str]
    passed: bool = False
    problems: list[tuple[dict[str, str], dict[str, str]]] = field(default_factory=list)
    seconds: float = 0.0


@dataclass
class Graded:
    """One submission. `refused` is why it was not looked at; `pupil` is what it calls itself."""

    file: Path
    pupil: str = ""
    refused: dict[str, str] | None = None
    results: list[Grade] = field(default_factory=list)
    ended: str = ""
    problem: str = ""
    """What failed in the grader itself."""

    shielded: bool = True
    seconds: float = 0.0

    @property
    def passed(self) -> int:
        return sum(result.passed for result in self.results)


def _both(say: Say) -> dict[str, str]:
    return {"zh": say.text("zh"), "en": say.text("en")}


def right_answers(lessons: Iterable[str]) -> dict[str, dict[str, str]]:
    """The right letters of the questions of these lessons, by lesson and step."""
    wanted, found = set(lessons), {}
    for lesson in days():
        if lesson.name in wanted:
            letters = {
                step.name: str(check.arguments.get("letter", ""))
                for step in lesson.steps
                for check in step.checks
                if check.name == "answer"
            }
            found.update({lesson.name: letters} if letters else {})
    return found


class Grader:
    """Grades submissions with the same scenarios and the same drawn values."""

    def __init__(
        self,
        gradings: list[Grading],
        *,
        seconds: float = SECONDS,
        seed: str = "",
        shielded: bool = True,
        answers: Mapping[str, Mapping[str, str]] | None = None,
    ) -> None:
        self.seed = seed or secrets.token_hex(8)
        self._gradings = gradings
        self._seconds = seconds
        self._shield = shield.Shield.WHOLE if shielded else shield.Shield.NONE
        self._answers = right_answers(each.lesson for each in gradings) if answers is None else answers
        self._wardens: set[subprocess.Popen[bytes]] = set()
        self._lock = threading.Lock()
        self._stopped = False

    def grade(self, files: list[Path], jobs: int, told: Callable[[Graded], None] = lambda _: None) -> list[Graded]:
        """Grade all, `jobs` at a time; `told` hears of each when it is done, on another thread. Blocks."""

        def one(file: Path) -> Graded:
            graded = self._one(file)
            told(graded)
            return graded

        with ThreadPoolExecutor(max_workers=jobs) as pool:
            try:
                return list(pool.map(one, files))
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                self.stop()
                raise

    def stop(self) -> None:
        """End all wardens, and with them everything they keep."""
        self._stopped = True
        with self._lock:
            for warden in self._wardens:
                with contextlib.suppress(ProcessLookupError):
                    warden.kill()

    def _one(self, file: Path) -> Graded:
        graded = Graded(file, results=self._empty())
        began = time.monotonic()
        short = "/tmp" if os.name == "posix" and os.access("/tmp", os.W_OK | os.X_OK) else None  # it holds sockets
        work = tempfile.mkdtemp(prefix="d6g-", dir=short)
        try:
            for said in self._said(file, work):
                self._take(graded, said)
        finally:
            shutil.rmtree(work, ignore_errors=True)
        graded.seconds = round(time.monotonic() - began, 1)
        self._conclude(graded)
        return graded

    def _empty(self) -> list[Grade]:
        return [
            Grade(grading.lesson, scenario.name, scenario.title)
            for grading in self._gradings
            for scenario in grading.scenarios
        ]

    def _said(self, file: Path, work: str) -> list[dict[str, Any]]:
        """What the warden and the judge said about one submission."""
        job = {
            "archive": str(file.absolute()), "work": work, "seed": self.seed, "seconds": self._seconds,
            "shield": self._shield.value, "gradings": [str(each.path.absolute()) for each in self._gradings],
        }  # fmt: skip
        if self._stopped:
            return []
        warden = subprocess.Popen(
            [sys.executable, "-I", "-m", WARDEN],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True,
        )  # fmt: skip
        with self._lock:
            self._wardens.add(warden)
        try:
            text, _ = warden.communicate(json.dumps(job).encode() + b"\n", self._seconds + PATIENCE)
        except subprocess.TimeoutExpired:
            if sys.platform != "win32":
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.killpg(warden.pid, signal.SIGKILL)
            text, _ = warden.communicate()
        finally:
            with self._lock:
                self._wardens.discard(warden)
        return _lines(text[:LARGEST_REPORT])

    def _take(self, graded: Graded, said: dict[str, Any]) -> None:
        if "refused" in said:
            graded.refused = dict(zip(("zh", "en"), said["refused"], strict=True))
        elif "pupil" in said:
            graded.pupil = said["pupil"]
            self._judge_answers(graded, said["answers"])
        elif "scenario" in said:
            for result in graded.results:
                if (result.lesson, result.scenario) == (said["lesson"], said["scenario"]):
                    result.passed, result.seconds = said["ok"], said["seconds"]
                    result.problems = [({"zh": a, "en": b}, {"zh": c, "en": d}) for a, b, c, d in said["problems"]]
        elif "ended" in said:
            graded.ended = graded.ended or said["ended"]
            graded.shielded = said["shield"] == shield.Shield.WHOLE.value
        elif "problem" in said:
            graded.ended, graded.problem = "problem", str(said["problem"])

    def _judge_answers(self, graded: Graded, given: Mapping[str, Mapping[str, str]]) -> None:
        """Compare the last letter that was chosen at each question with the lesson's."""
        for lesson, letters in self._answers.items():
            wrong = [name for name, letter in letters.items() if given.get(lesson, {}).get(name, "")[-1:] != letter]
            title = _both(Say("grade.answers_title"))
            result = Grade(lesson, ANSWERS, title, not wrong)
            if wrong:
                wanted = Say("grade.answers", names=tuple(letters))
                saw = Say(
                    "grade.answers_saw", right=len(letters) - len(wrong), all=len(letters), names=tuple(wrong)
                )  # fmt: skip
                result.problems.append((_both(wanted), _both(saw)))
            graded.results.append(result)

    def _conclude(self, graded: Graded) -> None:
        """Say of what was not played why it was not."""
        if graded.refused is not None:
            graded.results = []
            return
        values = {
            "seconds": f"{self._seconds:g}", "most": shield.MOST_PROCESSES, "megabytes": shield.MOST_MEMORY // 2**20
        }  # fmt: skip
        values["reason"] = graded.problem
        ended = graded.ended if graded.ended in ("time", "processes", "memory", "problem") else "killed"
        wanted, saw = Say(f"grade.ended.{ended}", **values), Say(f"grade.ended.{ended}_saw", **values)
        for result in graded.results:
            if not result.passed and not result.problems:
                result.problems.append((_both(wanted), _both(saw)))


def _lines(text: bytes) -> list[dict[str, Any]]:
    """The whole lines of JSON; a judge that was ended may have left half of one."""
    found = []
    for line in text.split(b"\n"):
        with contextlib.suppress(ValueError):
            said = json.loads(line)
            if isinstance(said, dict):
                found.append(said)
    return found
