"""Desktops that are forked from a common parent: they are what desktops that were started singly are, and as much apart."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from day6_tui.web import nursery, starting
from tests.support.waiting import PATIENCE

pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")
assert not TYPE_CHECKING or sys.platform == "linux"

school = pytest.importorskip("tests.isolation.school", reason="desktops are forked on Linux only")


@pytest.mark.process
@pytest.mark.parametrize("name", ["users", "landlock", "none"])
def test_a_forked_desktop_has_the_rights_limits_files_and_words_of_one_that_is_started_singly(name: str) -> None:
    python = school.python_for_others()
    if python is None:
        pytest.skip("no Python here that other users may run")
    with school.folder() as top:
        plain = {}
        if os.geteuid() == 0 and name == "landlock":
            plain = {"user": school.PLAIN_USER, "group": school.PLAIN_USER, "extra_groups": []}
            top = top / "plain"
            top.chmod(0o711)
        done = subprocess.run(
            [python, "-I", "-c", school.started("tests.web.births"), name, str(top)],
            cwd="/",
            env={"PATH": "/usr/local/bin:/usr/bin:/bin", "LANG": "C.UTF-8", "DAY6_SECRET_OF_SERVER": "x31337"},
            capture_output=True,
            text=True,
            timeout=40 * PATIENCE,
            **plain,
        )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    if isinstance(found, str):
        pytest.skip(found)
    *processes, tried = found["forked"]
    assert len(processes) >= 2 and not any(each["knows a secret"] for each in processes)
    assert tried == {"reads the server's files": name == "none"}
    assert found["forked"] == found["started"]


@pytest.mark.process
def test_a_parent_that_is_killed_begins_anew_one_that_is_stuck_is_not_waited_for_and_all_end_with_the_server(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(nursery, "BEAR_SECONDS", 10 * PATIENCE)
    made = nursery.Nursery(starting.environment(0))
    try:
        made.begin()
        first = made._process
        assert first is not None
        assert made.bear({}, []) and not made.bear({"words": "x" * nursery.LARGEST}, [])
        first.kill()
        first.wait()
        assert made.bear({}, [])
        second = made._process
        assert second is not None and second.poll() is None
        monkeypatch.setattr(nursery, "BEAR_SECONDS", 0.2)
        second.send_signal(signal.SIGSTOP)
        assert not made.bear({}, [])
        second.send_signal(signal.SIGCONT)
        assert made._control is not None
        made._control.close()  # as when the server was killed
        assert second.wait(PATIENCE) == 0
    finally:
        made.close()
