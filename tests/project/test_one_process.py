"""What a test of the default layer may not do is an error where it is done; one with a marker may, and is in another layer."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.support.waiting import run

pytestmark = pytest.mark.process

ROOT = Path(__file__).resolve().parents[2]
SUITE = """
import os, socket, subprocess, sys, threading, time
import pytest

def start(): subprocess.run([sys.executable, "-c", ""])

def test_starts_a_process(): start()
def test_starts_one_and_swallows_the_error():
    try: start()
    except Exception: pass
def test_starts_one_in_a_thread():
    thread = threading.Thread(target=start)
    thread.start()
    thread.join()
def test_sleeps(): time.sleep(0.001)
def test_opens_a_terminal(): os.openpty()
def test_connects_to_somebody(): socket.create_connection(("127.0.0.1", 9))
def test_asks_who_somebody_is(): socket.getaddrinfo("somebody.invalid", 9)

def test_talks_to_itself():
    with socket.create_server(("127.0.0.1", 0)) as server, socket.create_connection(server.getsockname()): pass
def test_waits_for_a_condition():
    from tests.support import waiting
    ends = time.monotonic() + 0.02
    waiting.until(lambda: time.monotonic() > ends)
@pytest.mark.process
def test_says_so(): start(), time.sleep(0.001)
@pytest.fixture(scope="module")
def shared():
    yield
    start()
def test_is_the_last_with_what_others_share(shared): pass
"""


def played(folder: Path, *options: str) -> str:
    (folder / "test_some.py").write_text(SUITE, encoding="utf-8")
    plugins = [word for name in ("tests.conftest", "no:cacheprovider", "no:random_order") for word in ("-p", name)]
    words = [sys.executable, "-m", "pytest", *plugins, "-rfEp", *options]
    done = run(words, cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT), "PYTEST_ADDOPTS": ""})
    return done.stdout + done.stderr


def test_only_what_stays_in_the_process_passes(tmp_path: Path) -> None:
    said = played(tmp_path, f"--basetemp={tmp_path / 'base'}", ".")
    passed = {line.rpartition("::")[2] for line in said.splitlines() if line.startswith("PASSED")}
    failed = {
        line.partition(" - ")[0].rpartition("::")[2]
        for line in said.splitlines()
        if line.startswith(("FAILED", "ERROR"))
    }
    assert passed - failed == {
        "test_talks_to_itself",
        "test_waits_for_a_condition",
        "test_is_the_last_with_what_others_share",
    }, said
    assert "1 deselected" in said


@pytest.mark.parametrize("words", [("--whole", "."), ("-m", "", "."), ("test_some.py",)])
def test_the_whole_and_a_named_file_leave_nothing_out(tmp_path: Path, words: tuple[str, ...]) -> None:
    said = played(tmp_path, f"--basetemp={tmp_path / 'base'}", *words)
    assert "PASSED test_some.py::test_says_so" in said and "deselected" not in said
