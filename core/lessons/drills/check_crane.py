"""Check of drill 10: what the crane does in a new terminal that sources ~/ros2_ws/install/setup.bash, in a world of its own."""

import os
import subprocess
import sys
from pathlib import Path

WORKSPACE = Path.home() / "ros2_ws"
NEW = "PULLS_PER_SECOND = 10"
LINES = "source ~/ros2_ws/install/setup.bash; timeout 2 ros2 run crane lift"


def is_new() -> bool:
    """Whether it can be so at all, without running it: with --symlink-install the module is linked from build."""
    modules = (each for top in ("install", "build") for each in (WORKSPACE / top / "crane").rglob("crane/lift.py"))
    return any(NEW in module.read_text(encoding="utf-8", errors="replace") for module in modules)


def main() -> int:
    """Print what was seen; return 0 if it is the new program."""
    if is_new():
        words = ["day6-tui", "exec", "--home", str(Path.home()), "-c", LINES]
        ran = subprocess.run(words, env={**os.environ, "DAY6_LINK": "off"}, capture_output=True, text=True, check=False)
        if "10 pulls per second" in ran.stdout + ran.stderr:
            print("新终端里的起重机每秒拉 10 次 (in a new terminal the crane pulls 10 times a second)")
            return 0
    print("新终端里的起重机还是老样子 (in a new terminal the crane is as slow as before)")
    return 1


sys.exit(main())
