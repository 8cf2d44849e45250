"""Measures what a common parent process would save: desktops forked from one that has imported everything, or started singly.

    python -m tests.perf.fork_server [--desktops 1 8 16]

For each number of desktops, two runs in processes of their own: memory (PSS, the parent's own counted in) with the turtle on each
screen, and the seconds until the first frame of the first and of the last desktop. Everything runs as the same user. Linux only.
"""

from __future__ import annotations

import argparse
import gc
import importlib
import os
import subprocess
import sys
import tempfile
import time
import traceback

from tests.perf.load import TURTLE
from tests.perf.screen import Screen

MODULES = (
    "day6_tui.app",
    "day6_tui.main",
    "day6_tui.commands.desktop",
    "day6_core.shell.desk",
    "day6_core.shell.outside",
    "day6_core.ros.programs",
    "day6_core.ros.ros2.run",
    "zenoh",
)
"""What the parent has imported; the rest of it is what these import."""

PROGRAMS = (("turtlesim", "turtlesim_node"), ("turtlesim", "turtle_teleop_key"))
COLUMNS, ROWS = 120, 40


class Forked(Screen):
    """A desktop in a fork of this process."""

    def become(self, command: list[str], env: dict[str, str]) -> None:
        from day6_tui.main import main

        os.environ.clear()
        os.environ.update(env)
        sys.argv = ["day6-tui", *command[3:]]
        for name, number in (("stdin", 0), ("stdout", 1), ("stderr", 2)):
            stream = os.fdopen(number, "r" if number == 0 else "w", encoding="utf-8", closefd=False)
            setattr(sys, name, stream)
            setattr(sys, f"__{name}__", stream)
        status = 1
        try:
            status = main()
        except BaseException:
            traceback.print_exc(file=sys.stdout)
            sys.stdout.flush()
        finally:
            os._exit(status)


def prepare() -> None:
    """Import what a desktop imports, and leave it alone from now on."""
    from day6_core.ros.programs import load

    for module in MODULES:
        importlib.import_module(module)
    for package, executable in PROGRAMS:
        load(package, executable)
    gc.collect()
    gc.freeze()


def one_run(kind: type[Screen], count: int) -> tuple[float, float, float, float]:
    """Start so many at once: PSS in MB of all, seconds to the first and to the last first frame, seconds of preparation."""
    began = time.perf_counter()
    if kind is Forked:
        prepare()
    prepared = time.perf_counter() - began
    desktops: list[Screen] = []
    began = time.perf_counter()
    try:
        for _ in range(count):
            command = [sys.executable, "-m", "day6_tui.main", "--home", tempfile.mkdtemp(prefix="day6-fork-")]
            command += ["--lang", "en", "--scene", "empty"]
            env = {"DAY6_RUNTIME_DIR": tempfile.mkdtemp(prefix="day6-fork-"), "LANG": "C.UTF-8"}
            desktops.append(kind(command, COLUMNS, ROWS, **env))
        shown, seconds = [], []
        while len(shown) < count and time.perf_counter() - began < 60:
            for desktop in desktops:
                desktop.read(0.002)
                if desktop not in shown and len(desktop.output) > 1500:
                    shown.append(desktop)
                    seconds.append(time.perf_counter() - began)
        for desktop in desktops:
            desktop.read(2.0 / count)
            desktop.send(TURTLE)
        for _ in range(40):
            for desktop in desktops:
                desktop.read(5.0 / 40 / count)
        for desktop in desktops:
            assert b"TurtleSim" in desktop.output, bytes(desktop.output[-400:])
        memory = sum(desktop.pss_mb() for desktop in desktops)
        if kind is Forked:
            memory += pss_of_this_process()
    finally:
        for desktop in desktops:
            desktop.__exit__()
    return memory, seconds[0], seconds[-1], prepared


def pss_of_this_process() -> float:
    """In MB."""
    with open("/proc/self/smaps_rollup") as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("Pss:"))


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--desktops", type=int, nargs="+", default=[1, 8, 16], metavar="N")
    parser.add_argument("--run", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.run:
        kind, count = options.run
        print(*one_run(Forked if kind == "forked" else Screen, int(count)))
        return 0
    print("| desktops | separate: PSS MB, first frame of first / last s | forked: the same | PSS saved |")
    print("| --- | --- | --- | --- |")
    for count in options.desktops:
        rows = []
        for kind in ("separate", "forked"):
            command = [sys.executable, "-m", "tests.perf.fork_server", "--run", kind, str(count)]
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
            rows.append([float(word) for word in done.stdout.split()])
        texts = [f"{row[0]:.0f} = {row[0] / count:.1f} each, {row[1]:.2f} / {row[2]:.2f}" for row in rows]
        print(f"| {count} | {texts[0]} | {texts[1]} | {100 * (1 - rows[1][0] / rows[0][0]):.0f} % |", flush=True)
        prepared = rows[1][3]
    print(f"\nThe parent takes {prepared:.2f} s to import everything, once.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
