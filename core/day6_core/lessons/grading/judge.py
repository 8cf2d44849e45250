"""Judges one submission: a process that the warden has forked, in virtual time where there is any.

Elsewhere the warden starts `python -I -m day6_core.lessons.grading.judge`, with a job on standard input. The machine, its
turtlesim, its builds and the node that sends and listens are in this process; only the pupil's programs are not. Verdicts go,
one line of JSON each, to a pipe that no other process has.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import threading
import traceback
from collections.abc import Callable
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.lessons.grading import shield
from day6_core.lessons.grading.archive import SubmissionRefused, unpack
from day6_core.reason import fault
from day6_core.ros.environment import activate
from day6_core.virtual import ready

if TYPE_CHECKING:
    from day6_core.lessons.grading.scenarios import Grading
    from day6_core.session.session import Session

_MODULES = (
    *("rclpy.node", "rclpy.executors", "rclpy._day6.node_parts", "rclpy._day6.rosout", "rclpy._day6.log_file"),
    *("rclpy._day6.lost_errors", "rcl_interfaces.msg", "builtin_interfaces.msg", "day6_core.interfaces.copying"),
    *("day6_core.interfaces.hashing", "day6_core.link.fork_hook"),
    *("setuptools", "setuptools.dist", "distutils.core"),
    "day6_core.lessons.grading.play",
    *("rclpy", "rclpy.action", "tf2_ros", "rosidl_runtime_py.set_message", "rosidl_runtime_py.utilities"),
    *("std_msgs.msg", "geometry_msgs.msg", "sensor_msgs.msg", "std_srvs.srv", "tf2_msgs.msg"),
    *("day6_core.shell.terminal", "day6_core.shell.login", "day6_core.shell.commands"),
    "day6_core.shell.line.completion",
    *("day6_core.shell.process.process", "day6_core.shell.process.real_tools", "day6_core.shell.builtins.programs"),
    *("day6_core.shell.builtins.text", "day6_core.shell.builtins.state", "day6_core.shell.builtins.files"),
    *("day6_core.workspace.command", "day6_core.workspace.colcon", "day6_core.workspace.build_python"),
    *("day6_core.workspace.sourcing", "catkin_pkg.package", "day6_core.ros.ros2.cli.run", "day6_core.session.host"),
    *("day6_core.ros.ros2.run", "day6_core.ros.ros2.launch", "day6_core.session.real_streams"),
    *("day6_core.advice.rules", "day6_core.advice.below", "day6_core.link.link", "day6_core.link.local.session"),
    *("day6_core.ros.programs.turtlesim.turtlesim_node", "day6_core.ros.robot_check", "day6_urdf.check"),
    "day6_core.ros.programs.robot_state_publisher.robot_state_publisher",
)
"""With all that they import: what nearly every submission needs, the first ones also what its nodes do.

None of them starts a thread or looks at anybody's files.
"""

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


def prepare() -> None:
    """Import what judging a submission takes, for processes that are forked later."""
    activate()
    for module in _MODULES:
        import_module(module)
    gc.collect()
    gc.freeze()  # or the first collection of every child would copy all that it shares


def judge(job: dict[str, Any], begin: Callable[[], None] = lambda: None) -> None:
    """Judge one, for which `begin` is called first; doesn't return if anything of it was played."""
    shield.hide()
    report = Report()
    try:
        begin()
        _unpack_and_play(job, report)
    except Exception as error:
        _say_whose_fault(error, report)


def _say_whose_fault(error: Exception, report: Report) -> None:
    """The grader shows it as ours, not as the pupil's; a traceback has nobody to read it here."""
    place = traceback.extract_tb(error.__traceback__)[-1]
    report.say(problem=f"{fault(error)} ({Path(place.filename).name}:{place.lineno})")


def _unpack_and_play(job: dict[str, Any], report: Report) -> None:
    home = Path(job["work"]) / "home"
    try:
        submission = unpack(job["archive"], home)
    except SubmissionRefused as refused:
        from day6_core.lessons.grading.marks import both

        report.say(refused=both(refused.say))
        return
    report.say(pupil=submission.pupil, answers=submission.answers)
    activate()
    _play(job, home, report)


def _gradings(job: dict[str, Any]) -> list[Grading]:
    from day6_core.lessons.grading.scenarios import read_grading

    return [read_grading(Path(path), text.encode()) for path, text in job["gradings"]]


def _play(job: dict[str, Any], home: Path, report: Report) -> None:
    from day6_core.lessons.grading.play import Play
    from day6_core.link.paths import LinkError, meeting_place
    from day6_core.shell.desk import Desk

    try:
        meeting_place(DOMAIN)
    except LinkError as error:  # programs would fail for no fault of theirs
        report.say(problem=str(error))
        return
    gradings = _gradings(job)
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
            _say_whose_fault(error, report)
        finally:
            done.set()
        return 0

    desk.start()
    desk.start_unseen("grade", run)
    done.wait()  # the warden looks at the time
    report.say(done=True, programs=ready.wanted or 0)
    os._exit(0)  # the warden ends whatever runs


if __name__ == "__main__":
    judge(json.loads(sys.stdin.read()))
