"""What a test finds around it is the same whoever starts it, and from where."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path

import pytest

from tests.support.waiting import run

CALLERS = {
    "LC_ALL": "C",
    "LANGUAGE": "fr",
    "TERM": "dumb",
    "COLUMNS": "37",
    "NO_COLOR": "1",
    "TZ": "Pacific/Kiritimati",
    "HOME": "/nonexistent",
    "EDITOR": "ed",
    "GIT_DIR": "/nonexistent",
    "http_proxy": "http://127.0.0.1:9",
    "PYTHONWARNINGS": "ignore",
    "ROS_DOMAIN_ID": "77",
    "RMW_IMPLEMENTATION": "rmw_of_somebody",
    "DAY6_LANG": "zh",
}


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="has no umask, and other signals")
def test_nothing_of_the_callers_reaches_a_test(tmp_path: Path) -> None:
    """Plays the next test in an odd place: started by `nohup`, with a umask and variables of its own."""
    probe = f"{__file__}::test_a_test_starts_with_the_environment_of_the_fixtures"
    # Its own place for temporary files: in the usual one pytest removes those of earlier runs, gigabytes after a whole suite.
    options = f"-q -p no:cacheprovider --basetemp='{tmp_path / 'base'}'"
    command = f"umask 077; trap '' INT HUP; exec '{sys.executable}' -m pytest {options} '{probe}'"
    done = run(["sh", "-c", command], cwd=tmp_path, env={**os.environ, **CALLERS})
    assert done.returncode == 0 and "1 passed" in done.stdout, done.stdout + done.stderr


def test_a_test_starts_with_the_environment_of_the_fixtures(tmp_path: Path) -> None:
    ours = ("TERM", "TZ", "HOME")
    assert [name for name in CALLERS if name in os.environ and name not in ours] == []
    assert os.environ["TERM"] == "xterm-256color" and os.environ["TZ"] in ("UTC", "Pacific/Kiritimati")
    assert os.path.realpath(os.environ["HOME"]) == os.getcwd()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if sys.platform != "win32":
        assert signal.getsignal(signal.SIGHUP) is signal.SIG_DFL
        (tmp_path / "new").touch()
        assert (tmp_path / "new").stat().st_mode & 0o777 == 0o644
