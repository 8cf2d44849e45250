"""What was killed counts as gone when it has ended, not when it is no longer recognized."""

from __future__ import annotations

import subprocess
import sys
import threading

import pytest

from day6_core.isolation import left
from day6_core.system.processes import processes

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


@pytest.mark.process
@pytest.mark.parametrize("ends", [True, False])
def test_a_process_that_is_ending_is_waited_for(monkeypatch: pytest.MonkeyPatch, ends: bool) -> None:
    monkeypatch.setattr(left, "END_SECONDS", 300.0 if ends else 0.1)
    with subprocess.Popen(["sleep", "60"]) as process:
        recognized = [[process.pid]]
        timer = threading.Timer(0.1, process.kill)

        def strike(pids: list[int]) -> None:
            assert pids == [process.pid]
            if ends:
                timer.start()

        gone = left._end(lambda: recognized.pop() if recognized else [], strike)
        living = [each.pid for each in processes() if each.pid == process.pid and not each.is_dead]
        process.kill()
    assert gone is ends
    assert (living == []) is ends
