"""Judges one submission: `python -I -m day6_core.lessons.grading.judge`, started by the warden, with a job on standard input.

The machine, its turtlesim, its builds and the node that sends and listens are in this process; only the pupil's programs are
not. Verdicts go, one line of JSON each, to a pipe that no other process has.
"""

from __future__ import annotations

from day6_core.virtual.surroundings import is_virtual

if is_virtual():  # before others take from Python what it replaces
    from day6_core.virtual.follow import begin

    begin()

import json
import os
import sys
import threading
import time
import traceback
from functools import partial
from pathlib import Path
from typing import Any

from day6_core.lessons.grading import shield
from day6_core.reason import fault

DOMAIN = 0
"""Of the graph in which everything is played."""


class Report:
    """The pipe to the grader."""

    def __init__(self) -> None:
        self._pipe = os.fdopen(os.dup(1), "w", encoding="utf-8")
        os.set_inheritable(self._pipe.fileno(), False)
        silent = os.open(os.devnull, os.O_RDWR)
        for number in (0, 1, 2):
            os.dup2(silent, number)

    def say(self, **what: Any) -> None:
        """Send one line."""
        self._pipe.write(json.dumps(what) + "\n")
        self._pipe.flush()


def main() -> int:
    shield.hide()
    job = json.loads(sys.stdin.read())
    report = Report()
    from day6_core.lessons.grading.archive import SubmissionRefused, unpack
    from day6_core.lessons.grading.marks import both

    home = Path(job["work"]) / "home"
    try:
        submission = unpack(job["archive"], home)
    except SubmissionRefused as refused:
        report.say(refused=both(refused.say))
        return 0
    report.say(pupil=submission.pupil, answers=submission.answers)
    _play(job, home, report)
    return 0


def _play(job: dict[str, Any], home: Path, report: Report) -> None:
    from day6_core.ros.environment import activate

    activate()
    from day6_core.lessons.grading.play import Play
    from day6_core.lessons.grading.scenarios import read_grading
    from day6_core.link.paths import LinkError, meeting_place
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk

    try:
        meeting_place(DOMAIN)
    except LinkError as error:  # programs would fail for no fault of theirs
        report.say(problem=str(error))
        return
    gradings = [read_grading(Path(path), text.encode()) for path, text in job["gradings"]]
    desk = Desk(home, domain_id=DOMAIN)
    done = threading.Event()

    async def run(session: Session) -> int:
        session.background = True
        try:
            play = Play(desk, session, job["seed"], shield.seconds_taken)
            for grading in gradings:
                lesson = grading.lesson
                told = partial(report.say, lesson=lesson)
                only = None if job["only"] is None else job["only"].get(lesson, [])
                await play.grading(grading, told, job["passed"].get(lesson, []), only)
        except Exception as error:
            # The grader shows it as ours, not as the pupil's; a traceback has nobody to read it here.
            place = traceback.extract_tb(error.__traceback__)[-1]
            report.say(problem=f"{fault(error)} ({Path(place.filename).name}:{place.lineno})")
        finally:
            done.set()
        return 0

    desk.start()
    desk.start_unseen("grade", run)
    done.wait()  # the warden looks at the time
    report.say(done=True, seconds=round(time.process_time(), 2))
    os._exit(0)  # the warden ends whatever runs


if __name__ == "__main__":
    sys.exit(main())
