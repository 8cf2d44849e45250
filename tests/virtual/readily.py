"""Runs programs each twice: in an interpreter that was ready, and in a new one. `main()` is for `virtual.ready`.

On standard input: a folder, then a line of JSON for each program, {"words": […], "stdin": "…", "variables": {…}, "kills": …}, the
last one being how many interpreters that are ready are killed before it. On standard output, JSON: what each did at first and
what each did then, [how it ended, output, errors], and how many that were ready were gone after the first time.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from typing import Any

from day6_core.lessons.grading import warden
from day6_core.ros.environment import program_environment
from day6_core.virtual import ready, surroundings
from day6_core.virtual.ready import forks

_kill, _waitid = os.kill, os.waitid


def main() -> int:
    """Run them."""
    folder, *lines = sys.stdin.read().splitlines()
    begin_world = warden.prepare()
    programs = list(map(json.loads, lines))
    surroundings.make_world(world := f"/tmp/day6-time-{os.getpid()}-ready")  # whose first process removes it
    del os.environ["PYTHONPATH"]
    os.environ.update(surroundings.environment(os.environ, world))
    forks.fork(len(programs))
    begin_world(60)
    first = [_run(each, folder) for each in programs]
    gone = len(programs) - len(ready.waiting)
    ready.waiting.clear()
    print(json.dumps([first, [_run(each, folder) for each in programs], gone]))
    return 0


def _run(program: dict[str, Any], folder: str) -> list[Any]:
    environment = program_environment(os.environ)
    for name, value in program.get("variables", {}).items():
        environment[name] = f"{value}{os.pathsep}{environment[name]}" if name == "PYTHONPATH" else value
    for pid, _ in list(ready.waiting)[: program.get("kills", 0)]:
        _kill(pid, signal.SIGKILL)
        _waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)
    done = subprocess.run(
        [sys.executable, *program["words"]],
        input=program.get("stdin", "").encode(), capture_output=True, check=False,
        cwd=folder, env=environment, start_new_session=True,
    )  # fmt: skip
    return [done.returncode, done.stdout.decode(), done.stderr.decode()]
