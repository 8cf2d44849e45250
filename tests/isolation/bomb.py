"""Measures what one pupil's fork bomb does to another's keys, by mode: `python -m tests.isolation.bomb [MODE…]`.

Two desktops, each in a cell and on a terminal of its own. In anna's a key is typed again and again, and the time until its echo
is on the screen is measured: alone, beside endless loops of bert's, beside a fork bomb of bert's. The bomb is bounded by the
limit of the cell, by its own count and by the clock; where nothing limits it (no control group and no user of its own) it stays
small.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

from day6_core.isolation import modes
from day6_core.isolation.cell import Cell, Limits
from tests.isolation.school import PLAIN_USER, School, folder, in_words, python_for_others, started
from tests.perf.screen import Screen

SECONDS = 8
MOST = 250
"""Processes of the bomb, where a limit holds; elsewhere FEW."""
FEW = 60
KEYS = 60
LIMITS = Limits(processes=200)

BOMB = """
import os, signal, sys, time
until, most = time.time() + float(sys.argv[1]), int(sys.argv[2])
signal.signal(signal.SIGCHLD, signal.SIG_IGN)
made = 0
while made < most:
    try:
        if os.fork() == 0:
            while time.time() < until:
                try:
                    if sys.argv[3] == "forks" and os.fork() == 0:
                        os._exit(0)
                except OSError:
                    pass
            os._exit(0)
        made += 1
    except OSError:
        break
print(made, flush=True)
time.sleep(max(0, until - time.time()))
"""


def desktop(school: School, cell: Cell) -> Screen:
    """Start a desktop in a cell as a server does."""
    argv = [
        sys.executable,
        "-m",
        "day6_tui.main",
        "--home",
        str(cell.home / "home"),
        "--lang",
        "en",
        "--scene",
        "empty",
    ]
    return Screen(school.mode.command(cell, argv), 80, 24)


def echoes(screen: Screen) -> str:
    """Type keys and tell p50, p95 and the longest wait, in ms."""
    waits = []
    for number in range(KEYS):
        waits.append(1000 * screen.echo_time("xyzw"[number % 4]))
    waits.sort()
    return f"p50 {statistics.median(waits):.0f}  p95 {waits[int(0.95 * len(waits))]:.0f}  worst {waits[-1]:.0f}"


def measure(name: str, top: Path) -> None:
    """Print one mode's lines."""
    (offer,) = modes.survey((name,))
    if offer.mode is None:
        assert offer.reason is not None
        print(f"{name}: {in_words(offer.reason)}")
        return
    mode = offer.mode
    school = School(mode, top)
    anna, bert = school.cell("anna", LIMITS), school.cell("bert", LIMITS)
    most = MOST if "processes" in mode.enforces else FEW
    print(f"{name} (limited as a whole: {', '.join(sorted(mode.enforces)) or 'nothing'})")
    try:
        with desktop(school, anna) as screen, desktop(school, bert) as other:
            for each in (screen, other):
                each.first_frame()
                each.read(1.0)
            print("  two desktops, nothing else:", echoes(screen))
            used = mode.used(anna)
            print(f"  a desktop takes {used.memory >> 20} MB, {used.processes} processes")
            for kind, count in (("loops", 8), ("loops", most), ("forks", most)):
                words = [sys.executable, "-I", "-c", BOMB, str(SECONDS), str(count), kind]
                with subprocess.Popen(mode.command(bert, words), stdout=subprocess.PIPE, text=True) as bomb:
                    assert bomb.stdout is not None
                    made = bomb.stdout.readline().strip()
                    try:
                        print(f"  beside {made} processes of bert's ({kind}):", echoes(screen), flush=True)
                    except TimeoutError as error:
                        print(f"  beside {made} processes of bert's ({kind}): {error} within 5 s")
                    if "forks" in kind:
                        began = time.monotonic()
                        gone = mode.end(bert)
                        print(
                            f"  end of bert's cell: {'all gone' if gone else 'SOME LEFT'}, {time.monotonic() - began:.2f} s"
                        )
                    bomb.wait(SECONDS + 10)
                time.sleep(1.0)  # the processes of the bomb look at the clock, too
    finally:
        mode.end(anna)
        mode.end(bert)


def main() -> None:
    """Each mode as the server it is for."""
    if "--as-it-is" in sys.argv:
        measure(sys.argv[2], Path(sys.argv[3]))
        return
    python = python_for_others() or sys.executable
    for name in sys.argv[1:] or modes.NAMES:
        with folder() as top:
            plain = (
                {"user": PLAIN_USER, "group": PLAIN_USER, "extra_groups": []}
                if os.geteuid() == 0 and name != "users"
                else {}
            )
            place = top / "plain" if plain else top
            place.chmod(0o711)
            words = [python, "-I", "-c", started("tests.isolation.bomb"), "--as-it-is", name, str(place)]
            environment = {"PATH": os.defpath, "HOME": str(place), "LANG": "C.UTF-8"}
            subprocess.run(words, cwd="/", env=environment, timeout=180, check=False, **plain)  # type: ignore[call-overload]


if __name__ == "__main__":
    main()
