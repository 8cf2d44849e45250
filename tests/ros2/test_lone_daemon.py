"""`ros2 daemon` where no desktop is: a process of its own."""

from __future__ import annotations

import os
import sys

import pytest

from day6_core.ros.environment import program_environment
from day6_core.ros.ros2.cli import lone_daemon
from tests.support.waiting import PATIENCE, run, until

pytestmark = pytest.mark.process
DOMAIN = 77


@pytest.fixture
def ros2(monkeypatch):
    monkeypatch.setenv("DAY6_LINK", "on")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))
    yield lambda *words: run(["ros2", *words], env=program_environment())
    lone_daemon.shut_down(DOMAIN, PATIENCE)


def test_it_outlives_the_command_until_it_is_stopped_and_commands_ask_it(ros2):
    for words, said in (
        ("daemon status", "The daemon is not running\n"),
        ("daemon start", "The daemon has been started\n"),
        ("daemon start", "The daemon is already running\n"),
        ("daemon status", "The daemon is running\n"),
    ):
        result = ros2(*words.split())
        assert (result.stdout, result.stderr, result.returncode) == (said, "", 0)
    listed = until(lambda: ros2("node", "list", "-a").stdout)  # it waits a second at most for what the daemon knows
    assert listed.startswith(f"/_ros2cli_daemon_{DOMAIN}_"), "and the command has no node of its own"
    assert listed.count("\n") == 1
    for said in ("The daemon has been stopped\n", "The daemon is not running\n"):
        result = ros2("daemon", "stop")
        assert (result.stdout, result.returncode) == (said, 0)
    assert lone_daemon.running(DOMAIN) == 0


def test_one_that_was_killed_is_not_running_and_the_next_one_starts(monkeypatch):
    monkeypatch.setenv("DAY6_LINK", "on")
    assert lone_daemon.spawn(DOMAIN + 1, 2 * PATIENCE)
    number = lone_daemon.running(DOMAIN + 1)
    os.kill(number, 9)
    until(lambda: not lone_daemon.running(DOMAIN + 1))
    assert lone_daemon.spawn(DOMAIN + 1, 2 * PATIENCE)
    assert lone_daemon.running(DOMAIN + 1) != number
    assert not lone_daemon.spawn(DOMAIN + 1)
    assert lone_daemon.shut_down(DOMAIN + 1, PATIENCE)
    assert not lone_daemon.shut_down(DOMAIN + 1)


_HEARD_ELSEWHERE = """
import signal, sys, threading
from day6_core.link.paths import meeting_place
from day6_core.ros.ros2.cli import lone_daemon

def hear():
    number = lone_daemon._file(meeting_place(int(sys.argv[1])).folder)
    while not number.exists():  # to ask whether it runs is to take its lock for a moment, and it would find it taken
        pass
    signal.pthread_kill(threading.get_ident(), signal.SIGTERM)

threading.Thread(target=hear, daemon=True).start()
lone_daemon.main(int(sys.argv[1]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no signals between threads")
def test_a_signal_that_does_not_interrupt_its_wait_ends_it_all_the_same(monkeypatch):
    monkeypatch.setenv("DAY6_LINK", "on")
    result = run([sys.executable, "-c", _HEARD_ELSEWHERE, str(DOMAIN + 2)])
    assert result.returncode == 0
    assert not lone_daemon.running(DOMAIN + 2)


_ASKED_MEANWHILE = """
import sys
from day6_core.link.file_lock import FileLock
from day6_core.ros.ros2.cli import lone_daemon

try_acquire, replace_file = FileLock.try_acquire, lone_daemon.replace_file

tries = []

def taken_once(lock):
    tries.append(lock)
    return len(tries) > 1 and try_acquire(lock)

def begun(*words, **options):
    print("begun")
    replace_file(*words, **options)

FileLock.try_acquire, lone_daemon.replace_file, lone_daemon.UNUSED_SECONDS = taken_once, begun, -1e9
lone_daemon.main(int(sys.argv[1]))
"""


def test_it_begins_although_somebody_just_asks_whether_it_is_there(monkeypatch):
    monkeypatch.setenv("DAY6_LINK", "on")
    assert run([sys.executable, "-c", _ASKED_MEANWHILE, str(DOMAIN + 3)]).stdout == "begun\n"
