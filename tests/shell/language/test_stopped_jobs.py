"""What is on the screen when jobs are stopped, also by themselves, beside what a real bash 5.2 showed for the same keys.

`jobs_of_bash.jsonl` has the keys and the screens. `python -m tests.shell.language.test_stopped_jobs` plays them to the bash
of this machine and writes what it shows; process numbers are N.
"""

from __future__ import annotations

import json
import os
import re
import signal
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from day6_core.shell.process.process import running_processes

SCENES = Path(__file__).parent / "jobs_of_bash.jsonl"
STOPS = """\
import os, signal
print("one", flush=True)
os.kill(os.getpid(), signal.SIGSTOP)
print("two", flush=True)
"""


class Scene(NamedTuple):
    """What is typed in turn, each piece when the one before has had its effect, and all that is on the screen then."""

    keys: list[str]
    screen: list[str]


def read() -> list[Scene]:
    return [Scene(**json.loads(line)) for line in SCENES.read_text(encoding="utf-8").splitlines()]


def masked(text: str) -> list[str]:
    """The lines without their ends and with N for process numbers."""
    text = re.sub(r"(\[\d+\][+-]?|process group) +\d{3,}", r"\1 N", text)
    text = re.sub(r"job (\d+)\[\d+\]", r"job \1[N]", text)
    return [line.rstrip() for line in text.rstrip().splitlines()]


def is_quick(scene: Scene) -> bool:
    return "s.py" not in "".join(scene.keys)


def played(seat: Any, scene: Scene) -> list[str]:
    (seat.desk.home / "s.py").write_text(STOPS)
    seat.type("PS1='$ '; clear\r")
    for keys in scene.keys:
        seat.type(keys)
        if not is_quick(scene):
            seat.wait(lambda text: seat.terminal.closed or seat.terminal.idle)
    return masked(seat.look())


@pytest.mark.parametrize(
    "scene", list(filter(is_quick, read())), ids=lambda scene: " ".join(scene.keys).replace("\r", "")
)
def test_stopped_jobs_are_as_in_bash(seat: Any, scene: Scene) -> None:
    assert played(seat, scene) == scene.screen


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="Windows stops no processes")
def test_a_program_that_stops_itself_is_a_stopped_job_as_in_bash(machine: Any) -> None:
    from tests.shell.conftest import Seat

    for scene in read():
        if not is_quick(scene):
            seat = Seat(machine.desk)
            assert played(seat, scene) == scene.screen, scene.keys
            seat.terminal.close()


# -- where bash itself stands still with the program, the terminal is given back ------------------------------------------


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="Windows stops no processes")
@pytest.mark.parametrize(
    ("line", "after"),
    [
        ("( python3 s.py; echo in )", ["two", "in"]),
        ("timeout 60 python3 s.py", ["two"]),
        ("python3 s.py | sort", ["one", "two"]),
        ("bash -c 'python3 s.py; echo in'", ["two", "in"]),
        ("x=$( python3 s.py ); echo $x", []),
    ],
)
def test_whatever_stands_around_it_stops_too_and_goes_on_with_it(seat: Any, line: str, after: list[str]) -> None:
    (seat.desk.home / "s.py").write_text(STOPS)
    seat.type("PS1='$ '; clear\r")
    seat.line(line)
    job = line if after else "python3 s.py"
    shown = seat.wait(lambda text: seat.terminal.idle and "Stopped" in text).rstrip("\n$ ").splitlines()
    assert shown[-1].split(None, 2)[:2] == ["[1]+", "Stopped"] and shown[-1].split(None, 2)[2].strip() == job
    seat.line("clear; fg")
    assert seat.wait_prompt().rstrip("\n$ ").splitlines()[1:] == after
    assert seat.line("clear; jobs").splitlines()[-1] == "$"


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="Windows stops no processes")
def test_one_that_another_program_stops_and_wakes_is_followed(seat: Any) -> None:
    (seat.desk.home / "s.py").write_text("import time\nprint('one', flush=True)\ntime.sleep(60)\n")
    seat.line("python3 s.py")
    seat.wait(lambda text: "one" in text)
    (process,) = running_processes(seat.desk.scheduler)
    os.kill(process.pid, signal.SIGSTOP)
    seat.wait(lambda text: "Stopped" in text and seat.terminal.idle)
    os.kill(process.pid, signal.SIGCONT)
    seat.wait(lambda text: seat.terminal.shell.jobs.jobs[0].state == "Running")
    seat.desk.pause()  # the world's pause is no stop of the job
    seat.desk.resume()
    assert "[1]+  Running                 python3 s.py &" in seat.line("jobs")
    seat.line("kill %1")
    seat.wait(lambda text: not seat.terminal.shell.jobs.jobs or seat.terminal.shell.jobs.jobs[0].finished)


# -- recording -----------------------------------------------------------------------------------------------------------

QUIET = 1.5
"""Seconds without output after which bash is taken to have done what was typed."""


def _of_bash(keys: list[str]) -> list[str]:
    """Type the keys to a real bash and return its screen. Linux and macOS."""
    from tests.perf.screen import Screen

    with tempfile.TemporaryDirectory() as home:
        (Path(home) / "s.py").write_text(STOPS)
        bare = ["env", "-i", f"PATH={os.environ['PATH']}", f"HOME={home}", "TERM=dumb", "LC_ALL=C.UTF-8"]
        with Screen([*bare, "bash", "--norc", "--noprofile", "-i"], 80, 24, cwd=home) as screen:
            begin = 0
            for text in ("PS1='$ '; bind 'set enable-bracketed-paste off'\r", *keys):
                screen.send(text)
                while screen.read(QUIET):
                    pass
                begin = begin or len(screen.output)
            os.kill(screen.pid, signal.SIGKILL)  # an interactive bash hears no SIGTERM
    return masked("$ " + screen.output[begin:].decode().replace("\r\n", "\n"))


if __name__ == "__main__":
    recorded = [Scene(scene.keys, _of_bash(scene.keys)) for scene in read()]
    lines = [json.dumps(scene._asdict(), ensure_ascii=False) for scene in recorded]
    SCENES.write_text("\n".join([*lines, ""]), encoding="utf-8")
