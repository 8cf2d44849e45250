"""Check of drill 10: what the crane does in a new terminal that sources ~/ros2_ws/install/setup.bash, in a world of its own."""

import os
import subprocess
import sys
import threading
from pathlib import Path

SECONDS = 6.0
WORKSPACE = Path.home() / "ros2_ws"
NEW = "PULLS_PER_SECOND = 10"
SAYS = "10 pulls per second"
LINES = "source ~/ros2_ws/install/setup.bash; ros2 run crane lift"


def is_new() -> bool:
    """Whether it can be so at all, without running it: with --symlink-install the module is linked from build."""
    modules = (each for top in ("install", "build") for each in (WORKSPACE / top / "crane").rglob("crane/lift.py"))
    return any(NEW in module.read_text(encoding="utf-8", errors="replace") for module in modules)


def new_terminal_says_so() -> bool:
    """Run it as in a new terminal until it says its speed."""
    words = ["day6-tui", "exec", "--home", str(Path.home()), "--timeout", str(SECONDS), "-c", LINES]
    world = {**os.environ, "DAY6_LINK": "off"}
    crane = subprocess.Popen(
        words,
        env=world,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
    )
    late = threading.Timer(SECONDS, crane.kill)
    late.start()
    try:
        assert crane.stdout is not None
        return any(SAYS in line for line in crane.stdout)
    finally:
        late.cancel()
        crane.terminate()
        crane.wait()


def main() -> int:
    """Print what was seen; return 0 if the new program is what runs."""
    if is_new() and new_terminal_says_so():
        print("新终端里的起重机每秒拉 10 次 (in a new terminal the crane pulls 10 times a second)")
        return 0
    print("新终端里的起重机还是老样子 (in a new terminal the crane is as slow as before)")
    return 1


if __name__ == "__main__":
    sys.exit(main())
