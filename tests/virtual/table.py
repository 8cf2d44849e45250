"""The table of virtual time, by hand: `python -m tests.virtual.table [--runs N]`. Seconds are this machine's.

Ten simulated minutes of talker, listener, turtlesim, a broadcaster of tf2 and an action client, on one core; what the mode costs
a program in which nobody waits, beside the same in real time; and N runs of the six processes of `test_worlds`, with busy loops
beside.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from difflib import unified_diff
from functools import partial
from pathlib import Path

from tests.perf import budgets
from tests.perf.budgets import Row, print_table
from tests.virtual.test_worlds import SIX, files
from tests.virtual.world import World

TEN_MINUTES = (
    "python3 listener.py & python3 talker.py & ros2 run turtlesim turtlesim_node & python3 broadcaster.py & "
    "python3 fibonacci.py & for n in 1 2 3 4 5 6 7 8 9 10; do "
    'ros2 action send_goal /fibonacci example_interfaces/action/Fibonacci "{order: 45}"; done; sleep 156; '
    "kill -9 %1 %2 %3 %4 %5; echo $SECONDS"
)
NOBODY_WAITS = """
import resource, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("node")
heard = []
node.create_subscription(String, "chatter", heard.append, 10)
publisher = node.create_publisher(String, "chatter", 10)
began = sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
for n in range(100_000):
    publisher.publish(String(data=str(n)))
    rclpy.spin_once(node, timeout_sec=0)
print(sum(resource.getrusage(resource.RUSAGE_SELF)[:2]) - began)
"""


def main() -> int:
    """Print the table; return 1 if something isn't kept."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=20)
    runs: int = parser.parse_args().runs
    with tempfile.TemporaryDirectory() as folder:
        world = World(Path(folder))
        files(world)
        missed = print_table(each(world) for each in (ten_minutes, overhead, partial(repeat, runs=runs)))
        world.close()
    return int(missed > 0)


def ten_minutes(world: World) -> Row:
    """How long ten minutes take on one core."""
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = world.fast(TEN_MINUTES)
    os.sched_setaffinity(0, cores)
    took, after = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return budgets.TEN_MINUTES.row(took, f"{done.stdout.splitlines()[-1]} simulated seconds, {cpu:.1f} s of CPU")


def overhead(world: World) -> Row:
    """What a program costs that never waits, relative to real time; each three times in turn, the least counts."""
    world.file("busy.py", NOBODY_WAITS)
    costs: dict[bool, list[float]] = {True: [], False: []}
    for _ in range(3):
        for fast in costs:
            words = ["python", *(["--fast"] if fast else []), "busy.py"]
            costs[fast].append(float(world.run(*words, DAY6_LINK="off").stdout))
    return budgets.NOBODY_WAITS.row(min(costs[True]) / min(costs[False]))


def repeat(world: World, runs: int) -> Row:
    """How many of some runs of six processes, beside busy loops that come and go, say the same."""
    said: Counter[str] = Counter()
    for number in range(runs):
        busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(number % 5)]
        try:
            done = world.fast(SIX)
        finally:
            for each in busy:
                each.kill()
                each.wait()
        said[done.stdout + done.stderr] += 1
    (usual, same), *others = said.most_common()
    for text, times in others:
        print(f"{times} times:", *unified_diff(usual.splitlines(), text.splitlines(), lineterm="", n=0), sep="\n")
    return budgets.SAME_RUNS._replace(limit=runs).row(same, f"on {len(os.sched_getaffinity(0))} cores")


if __name__ == "__main__":
    sys.exit(main())
