"""Runs the tests many times under bad conditions and prints a line for each run: nothing may fail by luck.

    python -m tests.perf.runs --times 50 --busy 2 --cores 1 --memory 2G
    python -m tests.perf.runs --times 20 --busy 2 --busy-every 2 -- --whole -n 4

What follows `--` goes to pytest (default: `-n logical`). Every run is in another random order, whose seed is printed: it repeats
the run with `--random-order-seed=SEED`. `--busy N` has N loops beside that take all the time they get (`--busy-every 2`: in every
second run). `--stalls` stops one of the tests' processes now and then, as happens on a machine that is shared. `--cores N` has
everything on N cores, `--memory SIZE` in a control group of that size (Linux, root). Status 1 if a run failed.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import re
import signal
import statistics
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GROUPS = Path("/sys/fs/cgroup")
COUNTS = re.compile(r"^(?:\d+ \w+(?:, )?)+ in .*$", re.MULTILINE)
FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+)", re.MULTILINE)


@contextlib.contextmanager
def loops(number: int) -> Iterator[None]:
    """Have programs beside that compute without end."""
    running = [
        subprocess.Popen([sys.executable, "-c", "while True: pass"], start_new_session=True) for _ in range(number)
    ]
    try:
        yield
    finally:
        for each in running:
            each.kill()
            each.wait()


@contextlib.contextmanager
def control_group(size: str) -> Iterator[Path | None]:
    """Make a control group that may have so much memory; yields the file that takes the processes of it."""
    if not size:
        yield None
        return
    second = (GROUPS / "cgroup.controllers").exists()
    folder = (GROUPS if second else GROUPS / "memory") / f"day6-runs-{os.getpid()}"
    folder.mkdir()
    try:
        (folder / ("memory.max" if second else "memory.limit_in_bytes")).write_text(size)
        yield folder / "cgroup.procs"
    finally:
        folder.rmdir()


@contextlib.contextmanager
def stalls(group: int) -> Iterator[None]:
    """Have a process of a group stopped for up to 0.2 s, several times a second."""
    over = threading.Event()

    def stall() -> None:
        dice = random.Random(group)
        while not over.wait(dice.uniform(0.02, 0.3)):
            members = [int(each.name) for each in Path("/proc").glob("[0-9]*") if group_of(int(each.name)) == group]
            if not members:
                continue
            stopped = dice.choice(members)
            with contextlib.suppress(ProcessLookupError):
                os.kill(stopped, signal.SIGSTOP)
                try:
                    over.wait(dice.expovariate(1 / 0.04) % 0.2)
                finally:
                    os.kill(stopped, signal.SIGCONT)

    stalling = threading.Thread(target=stall)
    stalling.start()
    try:
        yield
    finally:
        over.set()
        stalling.join()


def group_of(pid: int) -> int:
    try:
        return os.getpgid(pid)
    except ProcessLookupError:
        return 0


def one_run(words: list[str], seed: int, members: Path | None, stalled: bool) -> tuple[float, int, str]:
    """Run the tests; return the seconds it took, the status and what it printed."""

    def enter() -> None:
        if members is not None:
            members.write_text(str(os.getpid()))

    start = time.monotonic()
    with subprocess.Popen(
        [sys.executable, "-m", "pytest", "-q", f"--random-order-seed={seed}", *words],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        preexec_fn=enter,
        start_new_session=True,
    ) as run:
        try:
            with stalls(run.pid) if stalled else contextlib.nullcontext():
                said, _ = run.communicate()
        except BaseException:  # Ctrl-C does not reach a session of its own
            os.killpg(run.pid, signal.SIGTERM)
            raise
    return time.monotonic() - start, run.returncode, said


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=50)
    parser.add_argument(
        "--seed", type=int, default=random.randrange(1_000_000), help="what the seeds of the runs come from"
    )
    parser.add_argument("--busy", type=int, default=0, metavar="N")
    parser.add_argument("--busy-every", type=int, default=1, metavar="N")
    parser.add_argument("--stalls", action="store_true")
    parser.add_argument("--cores", type=int, metavar="N")
    parser.add_argument("--memory", default="", metavar="SIZE")
    parser.add_argument("words", nargs="*", default=["-n", "logical"], metavar="PYTEST OPTION")
    given = parser.parse_args()
    if given.cores:
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: given.cores])
    seeds = random.Random(given.seed)
    print(
        f"pytest {' '.join(given.words)}: {given.times} runs, --seed {given.seed}, {len(os.sched_getaffinity(0))} cores"
    )
    took: list[float] = []
    fallen: Counter[str] = Counter()
    red = 0
    with control_group(given.memory) as members:
        for number in range(1, given.times + 1):
            busy = given.busy if number % given.busy_every == 0 else 0
            seed = seeds.randrange(1_000_000)
            with loops(busy):
                seconds, status, said = one_run(given.words, seed, members, given.stalls)
            failed = FAILED.findall(said)
            took.append(seconds)
            red += status != 0
            fallen.update(failed)
            counts = COUNTS.findall(said)
            print(
                f"{number:3}  seed {seed:6}  {busy} loops  {seconds:6.1f} s  {counts[-1] if counts else said[-2000:]}",
                flush=True,
            )
            for each in failed:
                print(f"     {each}", flush=True)
    least, middle, most = min(took), statistics.median(took), max(took)
    print(f"{given.times} runs, {red} failed; {least:.1f} / {middle:.1f} / {most:.1f} s (min, median, max)")
    for name, times in fallen.most_common():
        print(f"{times:3} x {name}")
    return int(red > 0)


if __name__ == "__main__":
    sys.exit(main())
