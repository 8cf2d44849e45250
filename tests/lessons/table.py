"""All lessons and drills, played by hand: `python -m tests.lessons.table [--runs N] [--busy N] [--real-time]`.

Prints how long that took, as many commands at a time as there are cores, and which steps went otherwise in another run: another
verdict or, in virtual time, other seconds. `--busy`: so many loops beside that do nothing but compute.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from tests.lessons.test_played import GROUPS, play
from tests.perf.budgets import LESSONS


def main() -> int:
    """Print the table; return 1 if a step went wrong, or otherwise in another run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--busy", type=int, default=0)
    parser.add_argument("--real-time", action="store_true")
    options = parser.parse_args()
    more = ["--real-time"] if options.real_time else []
    first: list[str] = []
    bad = False
    for number in range(options.runs):
        busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(options.busy)]
        before, began = _cpu(), time.monotonic()
        try:
            with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
                done = list(pool.map(lambda paths: play(paths, *more), GROUPS))
        finally:
            took = time.monotonic() - began
            cpu = _cpu() - before
            for each in busy:
                each.kill()
                each.wait()
        lines = [line for each in done for line in (each.stdout + each.stderr).splitlines()]
        steps = sum(line.startswith(("ok  ", "FAIL")) for line in lines)
        kept = "" if LESSONS.keeps(took) else f", more than {LESSONS.limit:g} s"
        print(f"run {number + 1}: {steps} steps in {took:.1f} s{kept}, {cpu:.1f} s of CPU", flush=True)
        first = first or lines
        told = [line for line in lines if not line.startswith("ok  ") or line not in first]
        bad = bad or bool(told)
        print("\n".join(told) or "  all is well, and as in the first run", flush=True)
    return int(bad)


def _cpu() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    sys.exit(main())
