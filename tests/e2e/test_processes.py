"""Programs that ask more of a terminal, or less of their manners: on the desktop, and by `ros2 run` of a workspace."""

from __future__ import annotations

import os
import signal
import stat
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.e2e.waits import READY
from tests.support.waiting import communicate, until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

CURSES = """\
import curses

def main(screen):
    curses.curs_set(0)
    rows, columns = screen.getmaxyx()
    screen.addstr(1, 2, f'{columns} columns', curses.A_BOLD)
    screen.refresh()
    while (key := screen.getch()) != ord('x'):
        screen.addstr(2, 2, f'key {key}   ')
        screen.refresh()

curses.wrapper(main)
print('curses over')
"""

TELEOP = (
    READY
    + """\
import select
import sys
import termios
import tty

settings = termios.tcgetattr(sys.stdin)
print('reading keys')
try:
    while True:
        tty.setraw(sys.stdin.fileno())
        ready()
        readable, _, _ = select.select([sys.stdin], [], [], 600.0)
        key = sys.stdin.read(1) if readable else ''
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        if key == '\\x03':
            break
        if key:
            print(f'key <{key}>', flush=True)
finally:
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    print('restored')
"""
)
"""How every teleop script of a course reads the keyboard, but they look for a tenth of a second only. What is typed between two
looks is flushed by `setraw`, and a Ctrl-C is a signal then.
"""

GETPASS = """\
import getpass
secret = getpass.getpass('Secret: ')
print('you typed', len(secret), 'letters')
"""

FAMILY = """\
import multiprocessing, os, subprocess, sys, time

def child():
    subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(1000)'], start_new_session=True)
    time.sleep(1000)

if __name__ == '__main__':
    for _ in range(3):
        multiprocessing.Process(target=child).start()
    print('the family is there', flush=True)
    time.sleep(1000)
"""

WITHOUT_PROC = "from day6_core.system import processes\nprocesses.PROC = '/nothing/here'"
"""Planted into a desktop, which then looks for processes as it has to on macOS."""

RUNAWAYS = {
    "loop.py": "while True: pass\n",
    "shout.py": "while True: print('again and again')\n",
    "eat.py": "kept = []\nwhile True: kept.append(bytearray(1_000_000))\n",
}

SPINS = """\
#!{python}
import sys
import rclpy
from rclpy.node import Node
{how}
"""


def desk(place: Place, **env: str) -> Terminal:
    screen = place.desktop("--scene", "empty", **env)
    screen.wait("student@day6:~$")
    return screen


def test_a_curses_program_has_the_whole_terminal_and_gives_it_back(place: Place) -> None:
    place.home_file("screen.py", CURSES)
    with desk(place) as screen:
        screen.line("python3 screen.py")
        screen.wait("columns")
        screen.send("q")
        screen.wait("key 113")
        screen.press("Up")
        screen.wait("key 259")
        screen.send("x")
        screen.wait_lines("curses over")


def test_a_teleop_script_reads_single_keys_and_its_ctrl_c(place: Place) -> None:
    place.home_file("keys.py", TELEOP)
    with desk(place) as screen:
        screen.line("python3 keys.py")
        screen.wait("reading keys", "ready")
        screen.send("w")
        screen.wait("key <w>", lambda seen: seen.count("ready") == 2)
        screen.press("Ctrl-C")
        screen.wait_lines("restored")
        screen.line("echo still $?")
        screen.wait_lines("still 0")


def test_a_password_is_not_shown(place: Place) -> None:
    place.home_file("ask.py", GETPASS)
    with desk(place) as screen:
        screen.line("python3 ask.py")
        screen.wait("Secret:")
        screen.line("open sesame")
        assert "sesame" not in screen.wait_lines("you typed 11 letters")


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.parametrize("plant", ["", WITHOUT_PROC], ids=["proc", "ps"])
def test_neither_children_nor_grandchildren_outlive_a_desktop_that_was_killed(place: Place, plant: str) -> None:
    place.home_file("family.py", FAMILY)
    with desk(place, plant=plant) as screen:
        screen.line("python3 family.py")
        screen.wait_lines("the family is there")
        until(lambda: sum("sleep(1000)" in line for line in place.processes().values()) == 3)
        screen.kill()
        assert screen.wait_end() == -signal.SIGKILL
        until(lambda: not place.processes(), 10)


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_closing_the_terminal_ends_the_family_within_four_seconds(place: Place) -> None:
    place.home_file("family.py", FAMILY)
    with desk(place) as screen:
        screen.line("python3 family.py")
        screen.wait_lines("the family is there")
        screen.quit()
        until(lambda: screen.wait_end() == 0 and not place.processes(), 8)


def test_three_runaways_leave_the_keyboard_to_others(place: Place) -> None:
    for name, code in RUNAWAYS.items():
        place.home_file(name, code)
    with desk(place, DAY6_MEMORY_LIMIT="200") as screen:
        for name in ("loop.py", "shout.py"):
            screen.line(f"python3 {name} > /dev/null &")
        screen.line("python3 eat.py")
        screen.wait("MemoryError")
        screen.line("echo I can type")
        screen.wait_lines("I can type")
        screen.line("clear; kill %1 %2; wait; jobs; echo quiet")
        screen.wait_lines("quiet")


WITHOUT_LIMITS = "from day6_core.shell.process import memory, memory_watch, prepared\n" + "".join(
    f"{module}.is_held_by_system = lambda: False\n" for module in ("memory", "memory_watch", "prepared")
)
"""Planted into a desktop, which then has to look after the memory of programs as on macOS."""


@pytest.mark.parametrize(
    ("lang", "plant", "hint"),
    [("en", WITHOUT_LIMITS, ""), ("zh", f"{WITHOUT_LIMITS}{WITHOUT_PROC}", "一下子要得太多了")],
    ids=["proc", "ps"],
)
def test_where_the_system_does_not_limit_memory_the_desktop_does(
    place: Place, lang: str, plant: str, hint: str
) -> None:
    eat = "import time\nkept = bytearray(b'x') * 300_000_000\nprint('eaten', flush=True)\ntime.sleep(1000)\n"
    place.home_file("eat.py", eat)
    call = "subprocess.call([sys.executable, 'eat.py'])"
    place.home_file("parent.py", f"import subprocess, sys\nprint('child', {call})\n")
    with desk(place, lang=lang, plant=plant, DAY6_MEMORY_LIMIT="200") as screen:
        screen.line("python3 eat.py")
        screen.wait("MemoryError: python3 was ended: process", "had more than 210 MB", hint, "Killed")
        screen.line("clear; python3 parent.py")
        screen.wait("MemoryError: python3 was ended: process", "child -9")


def workspace(place: Place, how: str) -> str:
    """A package `pkg` with the executable `spins`, as colcon installs one; returns its AMENT_PREFIX_PATH."""
    prefix = place.work / "install" / "pkg"
    (prefix / "lib" / "pkg").mkdir(parents=True)
    (prefix / "share" / "ament_index" / "resource_index" / "packages").mkdir(parents=True)
    (prefix / "share" / "ament_index" / "resource_index" / "packages" / "pkg").touch()
    file = prefix / "lib" / "pkg" / "spins"
    file.write_text(SPINS.format(python=sys.executable, how=how), encoding="utf-8")
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return str(prefix)


SPIN = (
    READY
    + "rclpy.init(); node = Node('spins'); print(__import__('os').getpid(), flush=True); ready(); rclpy.spin(node)"
)


@pytest.mark.parametrize(
    ("number", "status", "last"),
    [
        (signal.SIGINT, 254, "[ros2run]: Interrupt"),
        (signal.SIGKILL, 247, "[ros2run]: Killed"),
        (signal.SIGTERM, 1, "[ros2run]: Process exited with failure 1"),
    ],
)
def test_ros2_run_says_what_ended_its_program(place: Place, number: int, status: int, last: str) -> None:
    prefix = workspace(place, SPIN)
    process = place.start("ros2", "run", "pkg", "spins", AMENT_PREFIX_PATH=prefix)
    assert process.stdout is not None
    pid = int(process.stdout.readline())
    assert process.stdout.readline() == "ready\n"
    os.kill(pid, number)
    out, err = communicate(process)
    assert out.splitlines()[-1] == last, err
    assert process.returncode == status


def test_the_program_of_ros2_run_ends_with_it_also_when_that_is_killed(place: Place) -> None:
    prefix = workspace(place, SPIN)
    for number in (signal.SIGTERM, signal.SIGKILL):
        process = place.start("ros2", "run", "pkg", "spins", AMENT_PREFIX_PATH=prefix)
        assert process.stdout is not None
        pid = int(process.stdout.readline())
        process.send_signal(number)
        communicate(process)
        until(lambda pid=pid: not Path(f"/proc/{pid}/cmdline").exists() if sys.platform == "linux" else True, 5)


def test_ctrl_c_in_a_real_terminal_ends_ros2_run_with_pythons_traceback(place: Place) -> None:
    prefix = workspace(place, SPIN)
    with place.terminal("ros2", "run", "pkg", "spins", AMENT_PREFIX_PATH=prefix) as screen:
        screen.wait("ready")
        screen.press("Ctrl-C")
        assert screen.wait_end() == 254
        seen = screen.look()
        assert "KeyboardInterrupt" in seen and "[ros2run]: Interrupt" in seen
