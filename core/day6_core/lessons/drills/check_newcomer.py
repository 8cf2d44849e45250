"""Check of drill 18: starts the pupil's ~/screen.py as somebody who comes late, and looks whether it shows the notice.

Twice: the first one may have been there by chance when the notice was sent.
"""

import os
import subprocess
import sys
import threading
import time

SECONDS = 1.5
NOTICE = "trip to the zoo"
PROGRAM = os.path.expanduser("~/screen.py")
NAMES = ("--ros-args", "-r", "__node:=_newcomer", "-r", "shown:=_newcomer/shown")


def late_screen_shows_it() -> bool:
    screen = subprocess.Popen(
        [sys.executable, "-u", PROGRAM, *NAMES],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    shown = threading.Event()

    def read() -> None:
        assert screen.stdout is not None
        if any(NOTICE.encode() in line for line in screen.stdout):
            shown.set()

    reading = threading.Thread(target=read)
    reading.start()
    end = time.monotonic() + SECONDS
    try:
        while time.monotonic() < end and not shown.wait(0.05) and screen.poll() is None:
            pass
    finally:
        screen.kill()
        screen.wait()
        reading.join()
    return shown.is_set()


def main() -> int:
    """Print what was seen; return 0 if a screen that is switched on late shows the notice."""
    if late_screen_shows_it() and late_screen_shows_it():
        print("现在打开的屏幕显示了通知 (a screen that is switched on now shows the notice)")
        return 0
    print("现在打开的屏幕还是空的 (a screen that is switched on now stays empty)")
    return 1


if __name__ == "__main__":
    sys.exit(main())
