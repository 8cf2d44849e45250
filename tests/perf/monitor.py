"""Measures what the topic monitor costs that listens to many fast topics: CPU of its process alone, what it received.

    python -m tests.perf.monitor [--topics 200] [--hertz 50] [--processes 4] [--seconds 10] [--all 500]

The publishers are programs in processes of their own, on a graph of their own. The monitor runs in a terminal of 120x40, where
every topic is ticked by keys, as a person does it. CPU is that of the monitor's process, user and system, all threads.
Linux only.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from day6_core.ros.environment import program_environment
from day6_core.shell.screen.screen import Screen as Picture
from tests.perf.screen import Screen

PUBLISHERS = """
import sys
import rclpy
from geometry_msgs.msg import Twist
name, first, count, hertz = sys.argv[1], *map(int, sys.argv[2:])
rclpy.init()
node = rclpy.create_node(name)
publishers = [node.create_publisher(Twist, f"t{number:03}", 10) for number in range(first, first + count)]
def publish():
    for publisher in publishers:
        publisher.publish(Twist())
node.create_timer(1 / hertz, publish)
rclpy.spin(node)
"""


def main() -> int:
    parser = argparse.ArgumentParser(description="CPU of the topic monitor")
    parser.add_argument("--topics", type=int, default=200, help="topics that are listened to")
    parser.add_argument("--all", type=int, default=0, help="topics there are, if more than these")
    parser.add_argument("--hertz", type=int, default=50)
    parser.add_argument("--processes", type=int, default=4)
    parser.add_argument("--seconds", type=float, default=10.0)
    options = parser.parse_args()
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    with tempfile.TemporaryDirectory() as home:
        given = {"HOME": home, "XDG_RUNTIME_DIR": home, "ROS_DOMAIN_ID": "77", "LANG": "C.UTF-8"}
        measure(options, {**os.environ, **given})
    return 0


def measure(options: argparse.Namespace, env: dict[str, str]) -> None:
    each = options.topics // options.processes
    program = Path(env["HOME"]) / "publishers.py"
    program.write_text(PUBLISHERS)
    own = program_environment(env)
    plan = [(f"fast{n}", n * each, each, options.hertz) for n in range(options.processes)]
    if options.all > options.topics:
        plan.append(("idle", options.topics, options.all - options.topics, 1))
    talkers = [
        subprocess.Popen([sys.executable, str(program), *map(str, words)], env=own, stderr=subprocess.DEVNULL)
        for words in plan
    ]
    try:
        time.sleep(3.0)
        command = [sys.executable, "-m", "day6_tui.main", "ros2", "run", "rqt_topic", "rqt_topic"]
        with Screen(command, 120, 40, **env) as screen:
            screen.read(4.0)
            print(f"{options.topics} topics at {options.hertz} Hz from {options.processes} processes")
            print(f"idle, nothing ticked: {cpu(screen, 5.0):.1f} % of a core")
            tick(screen, options)
            screen.read(7.0)
            ours, theirs = cpu(screen, options.seconds, talkers)
            print(f"all ticked: {ours:.1f} % of a core; the publishers together {theirs:.1f} %")
            print(seen(screen))
    finally:
        for talker in talkers:
            talker.terminate()
            talker.wait()


def seen(screen: Screen) -> str:
    """What the screen shows."""
    picture = Picture(120, 40)
    picture.feed(screen.output.decode("utf-8", "replace"))
    return picture.text


def tick(screen: Screen, options: argparse.Namespace) -> None:
    """Tick the topics one by one; those before them in the list (/parameter_events, /rosout) too."""
    for _ in range(options.topics + 2):
        screen.send("\r")
        screen.read(0.02)
        screen.send("\x1b[B")
        screen.read(0.02)
    screen.send("\x1b[H")


def cpu(screen: Screen, seconds: float, others: list[subprocess.Popen[bytes]] | None = None):
    """Percent of a core that the program on the screen uses; with others the sum of theirs too."""
    before, theirs = used(screen.pid), sum(used(each.pid) for each in others or [])
    began = time.perf_counter()
    screen.read(seconds)
    passed = time.perf_counter() - began
    ours = 100 * (used(screen.pid) - before) / passed
    return ours if others is None else (ours, 100 * (sum(used(each.pid) for each in others) - theirs) / passed)


def used(pid: int) -> float:
    """Seconds of CPU that a process has used."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    sys.exit(main())
