# ruff: noqa: E501 (a program a line)
"""What hostile programs do costs their own submission only: nothing survives, nobody else waits, no verdict is changed."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
import uuid
from pathlib import Path

import pytest

from day6_core.lessons.grading import shield
from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.grades import Graded
from day6_core.lessons.grading.marks import Mark
from day6_core.lessons.grading.scenarios import gradings, read_grading
from tests.grading.article import INNER, Patient, has_namespaces, write
from tests.support.waiting import communicate, until

pytestmark = [pytest.mark.process, pytest.mark.skipif(sys.platform != "linux", reason="namespaces are Linux's")]

FORK_BOMB = "import os\n\n\ndef main():\n    while True:\n        os.fork()\n"
THREADS = "import os, time\n\n\ndef main():\n    for _ in range(300):\n        if not os.fork():\n            time.sleep(600)\n    time.sleep(600)\n"
LOOP = "def main():\n    while True:\n        pass\n"
HEAP = "def main():\n    held = []\n    while True:\n        held.append(bytearray(1 << 24))\n"
HEAPS = "import os, time\n\n\ndef main():\n    for _ in range(9):\n        if not os.fork():\n            held = bytearray(400 << 20)\n            held[::4096] = b'x' * len(held[::4096])\n            time.sleep(600)\n    time.sleep(600)\n"
DISK = (
    "def main():\n    with open('big', 'wb') as file:\n        while True:\n            file.write(b'x' * (1 << 20))\n"
)
KILL_ALL = "import os\n\n\ndef main():\n    os.kill(-1, 9)\n"
ESCAPE = """\
import os, subprocess, sys, time


def main():
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for name in list(os.environ):
                del os.environ[name]
            os.execv('/bin/sleep', ['sleep', '{seconds}'])
        os._exit(0)
    print('away')
"""
MARKED = """\
import runpy, tempfile
make = tempfile.mkdtemp
tempfile.mkdtemp = lambda prefix, dir: make(prefix=prefix + "{mark}", dir=dir)
runpy.run_module("day6_tui.main", run_name="__main__", alter_sys=True)
"""
"""The command, whose folders can be told from those of other graders on this machine."""
C_SLEEP = "import ctypes\n\n\ndef main():\n    ctypes.CDLL(None).sleep(600)\n"
FOREIGN = "import subprocess\n\n\ndef main():\n    subprocess.run(['sleep', '600'])\n"
POLLS = "import time\n\n\ndef main():\n    while True:\n        time.sleep(0)\n"
SPEAKS = """\
import subprocess, sys

CODE = '''
import contextlib, os, socket, struct, threading, time
frame, world = struct.Struct("<BBqq").pack, os.environ["DAY6_TIME"]
IDLE, TOUCHED, SPAWNED, KILLED, WANTS = range(2, 7)
judge = int(os.readlink(world + "/first"))
def connected():
    made = socket.socket(socket.AF_UNIX)
    made.connect(world + "/socket")
    return made
{attack}
'''


def main():
    print(subprocess.run([sys.executable, '-I', '-c', CODE], capture_output=True, text=True, check=True))
"""
"""A program that has another one speak to who says what time it is, in the judge, and goes on."""
ATTACKS = {
    "kills": """
with open(f"/proc/{judge}/stat") as file:
    parent, group = map(int, file.read().rpartition(")")[2].split()[1:3])
for number in 9, 15, 19:
    for target in judge, parent, -group, -parent, 1, -1:
        connected().send(frame(KILLED, 0, target, number) + frame(IDLE, 0, 0, -1))
""",
    "lies": """
worst = 2**63 - 1, -2**63, 2**62, 2**31, -2**31, -1, 0, 1, judge
for kind in range(256):
    for first in worst:
        connected().send(b"".join(frame(kind, 255, first, second) for second in worst))
""",
    "claims": """
threading.Thread(target=time.sleep, args=[1], daemon=True).start()
for name in (*os.listdir("/proc"), threading.enumerate()[1].native_id):
    if str(name).isdecimal():
        connected().send(frame(SPAWNED, 0, int(name), 0) + frame(TOUCHED, 0, int(name), 0))
""",
    "half": """
kept = [connected() for _ in range(50)]
for each in kept:
    with contextlib.suppress(OSError):
        each.send(frame(KILLED, 0, judge, 9)[:7])
time.sleep(1)
""",
    "many": """
for _ in range(5000):
    connected()
""",
    "floods": """
made = connected()
for each in (frame(IDLE, 255, 0, 0), frame(WANTS, 0, 0, 0), frame(TOUCHED, 0, judge, 0), frame(99, 0, 0, 0)):
    with contextlib.suppress(OSError):
        made.sendall(each * 20_000)
""",
    "deaf": """
made = connected()
with contextlib.suppress(OSError):
    while True:
        made.send(frame(IDLE, 1, 0, 0))
""",
    "vandal": """
import shutil
shutil.rmtree(world)
os.mkdir(world)
os.symlink("nowhere", world + "/socket")
""",
}
VANDAL = """\
import os, pathlib


def main():
    for path in {paths!r}:
        try:
            pathlib.Path(path).write_text('passed = True')
        except OSError as error:
            print(error)
"""


def _graded(tmp_path: Path, programs: dict[str, str], *, within: int = 6, shielded: bool = True) -> dict[str, Graded]:
    """Grade day 4 of submissions whose hello.py is one of these, and of a good one, all at once.

    `within`: seconds that a program may take. Those of a submission are more than any takes: each is ended by what it does.
    """
    files = [write(tmp_path / f"{name}.zip", {INNER + "hello.py": text}) for name, text in programs.items()]
    (day4,) = (each for each in gradings() if each.lesson == "day4")
    patient = tmp_path / "day4.md"
    text = day4.path.read_text(encoding="utf-8")
    assert "within: 6\n" in text
    patient.write_text(text.replace("within: 6\n", f"within: {within}\n"), encoding="utf-8")
    grader = Patient([read_grading(patient)], seconds=90, shielded=shielded, answers={})
    done = grader.grade([*files, write(tmp_path / "good.zip")], len(files) + 1)
    return {graded.file.stem: graded for graded in done}


def _said(graded: Graded) -> str:
    return " ".join(
        f"{wanted['en']} {saw['en']}" for result in graded.results for wanted, saw in result.problems
    )  # fmt: skip


needs_namespaces = pytest.mark.skipif(not has_namespaces(), reason="this system gives users no namespaces")


@needs_namespaces
def test_each_costs_its_own_limit_only(tmp_path: Path) -> None:
    seconds = str(4_000_000 + os.getpid())
    programs = {
        "fork": FORK_BOMB, "many": THREADS, "heap": HEAP, "heaps": HEAPS, "disk": DISK, "kill": KILL_ALL,
        "escape": ESCAPE.format(seconds=seconds),
    }  # fmt: skip
    done = _graded(tmp_path, programs, within=60)
    assert (done["good"].passed, done["good"].ended) == (2, "")
    assert all(graded.shielded for graded in done.values())
    assert "more and more" in _said(done["fork"])
    assert "more and more" in _said(done["many"])
    assert "MemoryError" in _said(done["heap"])
    assert "It used more" in _said(done["heaps"])
    assert "too large" in _said(done["disk"]) or "status" in _said(done["disk"])
    assert "ended from inside" in _said(done["kill"])
    assert all(done[name].passed == 1 for name in programs if name != "escape")
    listed = subprocess.run(["ps", "-axo", "args"], capture_output=True, text=True, check=True).stdout
    assert f"sleep {seconds}" not in listed.splitlines()


def test_nothing_escapes_without_namespaces_either(tmp_path: Path) -> None:
    seconds = str(5_000_000 + os.getpid())
    done = _graded(
        tmp_path, {"escape": ESCAPE.format(seconds=seconds), "many": THREADS, "loop": LOOP}, shielded=False
    )  # fmt: skip
    assert done["good"].passed == 2
    assert not any(graded.shielded for graded in done.values())
    assert re.search("more and more|It is still running", _said(done["many"]))
    assert "It is still running" in _said(done["loop"])
    listed = subprocess.run(["ps", "-axo", "args"], capture_output=True, text=True, check=True).stdout
    assert f"sleep {seconds}" not in listed.splitlines()


def test_who_computes_or_waits_for_something_real_holds_nobody_for_ever(tmp_path: Path) -> None:
    programs = {"loop": LOOP, "polls": POLLS, "sleeps": C_SLEEP, "foreign": FOREIGN}
    done = _graded(tmp_path, programs, within=2)
    for name in programs:
        assert (done[name].passed, done[name].ended) == (1, "")
        assert "It is still running" in _said(done[name])
        assert "time stands still" not in _said(done[name])
    assert done["good"].passed == 2


@pytest.mark.parametrize("shielded", [pytest.param(True, marks=needs_namespaces), False])
def test_who_speaks_to_the_judge_has_nobody_killed_and_stops_nobody(tmp_path: Path, shielded: bool) -> None:
    programs = {name: SPEAKS.replace("{attack}", attack) for name, attack in ATTACKS.items()}
    done = _graded(tmp_path, programs, within=60, shielded=shielded)
    assert {name for name, graded in done.items() if (graded.passed, graded.ended) == (2, "")} == {*ATTACKS, "good"}


HUNTER = """\
import ctypes, os


def main():
    judge, own, libc = os.getppid(), os.getpid(), ctypes.CDLL(None)
    for name in os.listdir('/proc'):
        if name.isdigit() and int(name) not in (judge, own):
            with open(f'/proc/{name}/stat') as file:
                parent = int(file.read().rpartition(')')[2].split()[1])
            if parent == judge:
                print('killed', libc.kill(int(name), 9))
    assert 'job' not in os.listdir(os.path.dirname(os.path.expanduser('~')))
    print('This is my own package!')
"""
"""Ends the interpreters that are ready for other programs of its submission, and looks for what only the judge may read."""


@pytest.mark.parametrize("shielded", [pytest.param(True, marks=needs_namespaces), False])
def test_who_kills_the_interpreters_that_are_ready_gets_new_ones(tmp_path: Path, shielded: bool) -> None:
    done = _graded(tmp_path, {"hunter": HUNTER}, shielded=shielded)
    assert [(graded.passed, graded.ended) for graded in done.values()] == [(2, ""), (2, "")]


@needs_namespaces
def test_nothing_outside_can_be_written(tmp_path: Path) -> None:
    import day6_core.lessons.grading.judge as judge

    paths = [judge.__file__, str(tmp_path / "new.txt"), os.path.expanduser("~/vandal.txt"), f"/tmp/{uuid.uuid4().hex}"]
    before = Path(str(judge.__file__)).read_bytes()
    done = _graded(tmp_path, {"vandal": VANDAL.format(paths=paths), "loop": LOOP})
    assert Path(str(judge.__file__)).read_bytes() == before
    assert not any(os.path.lexists(path) for path in paths[1:])
    assert "It is still running" in _said(done["loop"])
    assert done["good"].passed == 2


def test_a_submission_that_takes_too_long_keeps_what_it_had_passed(tmp_path: Path) -> None:
    files = [write(tmp_path / "slow.zip", {"home/star.py": "while True:\n    pass\n"})]
    chosen = sorted((each for each in gradings() if each.lesson in ("day3", "day4")), key=lambda each: -each.order)
    done = Patient(chosen, seconds=15, answers={}).grade(files, 1)[0]
    assert {(each.lesson, each.passed) for each in done.results} == {("day4", True), ("day3", False)}
    assert "ends within 15 s" in _said(done)


def test_ctrl_c_leaves_nothing(tmp_path: Path) -> None:
    files = [str(write(tmp_path / f"{number}.zip", {INNER + "hello.py": C_SLEEP})) for number in range(8)]
    mark = uuid.uuid4().hex[:8]
    words = [sys.executable, "-c", MARKED.format(mark=mark), "grade", "--lesson", "day4", "--lang", "en", *files]
    grade = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    until(lambda: len(_works(mark)) == 2 and len(_inside(mark)) == 2)
    grade.send_signal(signal.SIGINT)
    _, error = communicate(grade)
    assert (grade.returncode, "stopped" in error, "Traceback" in error) == (130, True, False)
    assert not _works(mark)


def _works(mark: str) -> set[str]:
    """The folders of one run of the grader."""
    return {name for name in os.listdir("/tmp") if name.startswith(f"d6g-{mark}")}


def _inside(mark: str) -> set[str]:
    """Those of them in which a program runs."""
    found = set()
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            parts = Path(os.readlink(process / "cwd")).parts
            found |= {part for part in parts if part.startswith(f"d6g-{mark}")}
    return found


@pytest.mark.parametrize("virtual", [True, False])
def test_a_program_that_could_not_run_in_time_is_never_wrong(tmp_path: Path, virtual: bool) -> None:
    """Everything of the submission stands still again and again, as on a machine that is far too busy.

    In virtual time that makes no difference; in real time it is not played.
    """
    scenario = tmp_path / "own.md"
    scenario.write_text(
        "---\ngrading: own\ntitle: {zh: a, en: b}\n---\n# sleeps\n~~~yaml\nrun:\n  - type: python3 ~/sleeps.py\n"
        "check:\n  - ran: {line: sleeps.py, prints: in time}\nwithin: 8\n~~~\n## zh a\n## en b\n"
    )
    program = "import time\nbegan = time.monotonic()\ntime.sleep(1.0)\nprint('in time' if time.monotonic() < began + 1.3 else 'late')\n"
    grader = Grader([read_grading(scenario)], answers={}, virtual=virtual)
    again: list[int] = []
    done = threading.Event()

    def hold_up() -> None:
        while not done.wait(0.5):
            for number, times in ((signal.SIGSTOP, 30), (signal.SIGCONT, 1)):
                for _ in range(times):  # those that began meanwhile, too
                    wardens = [warden.pid for warden in list(grader._wardens)]
                    for pid in [each for warden in wardens for each in (warden, *shield.followers(warden))]:
                        with contextlib.suppress(ProcessLookupError, PermissionError):
                            os.kill(pid, number)
                    done.wait(0.05)

    holder = threading.Thread(target=hold_up)
    holder.start()
    try:
        (graded,) = grader.grade([write(tmp_path / "a.zip", {"home/sleeps.py": program})], 1, again=again.append)
    finally:
        done.set()
        holder.join()
    (result,) = graded.results
    if virtual:
        assert (result.mark, again) == (Mark.RIGHT, [])
        return
    assert again == [1]
    assert (result.mark, result.points) == (Mark.UNPLAYED, 0.0)
    assert "Too busy twice" in result.problems[0][1]["en"]
