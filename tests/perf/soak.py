"""Twenty processes start, crash and are killed at random beside a desktop with a lesson on it; then all must be gone. Linux only.

    python -m tests.perf.soak [--minutes 10] [--processes 20] [--warm-up 5] [--seed N]

The lesson: a turtle that drives squares, `ros2 topic echo` of its pose, and the car in RViz with turning wheels.

Every half minute the churn stops for a moment, and the nodes that a fresh `ros2 node list` and the desktop know are compared
with the processes that are alive. At the end nothing may be left: no process, node, socket, temporary file; and the desktop
must have no more threads than before, and no more memory than after the warm-up. The exit status is 1 if something is.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from day6_core.ros.environment import program_environment
from tests.perf.budgets import GROWTH
from tests.perf.screen import Screen

DAY6 = [sys.executable, "-m", "day6_tui.main"]
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

PROGRAMS = {
    "talker": "p = n.create_publisher(String, 'chatter', 10)\nn.create_timer(0.1, lambda: p.publish(String(data=name)))\n",
    "listener": "n.create_subscription(String, 'chatter', lambda message: None, 10)\n",
    "latched": "q = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)\n"
    "n.create_publisher(String, 'latched', q).publish(String(data=name))\n",
    "server": "n.create_service(Empty, 'work', lambda request, response: response)\n",
    "client": "c = n.create_client(Empty, 'work')\nn.create_timer(0.2, lambda: c.call_async(Empty.Request()))\n",
    "action": "ActionServer(n, Fibonacci, 'fib', lambda goal: Fibonacci.Result())\n",
    "crash": "p = n.create_publisher(String, 'chatter', 10)\nn.create_timer(random.uniform(0.2, 4), lambda: 1 / 0)\n",
    "segfault": "n.create_timer(random.uniform(0.2, 4), lambda: os.kill(os.getpid(), signal.SIGSEGV))\n",
    "leaves": "n.create_timer(random.uniform(0.2, 4), lambda: sys.exit(0))\n",
    "hangs": "n.create_timer(random.uniform(0.2, 2), lambda: time.sleep(1000))\n",
}
START = """\
import os, random, signal, sys, time
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import Empty

name = sys.argv[1]
rclpy.init()
n = Node(name)
"""
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
DESK_NODE = "/desk_listener"
LESSON = (
    "ros2 run turtlesim turtlesim_node &",
    "ros2 run turtlesim draw_square > /dev/null &",
    "ros2 launch day6_bot display.launch.py > /dev/null &",
    f"python3 listener.py {DESK_NODE[1:]} &",
    "ros2 topic echo /turtle1/pose &",
)
LESSON_NODES = {"/turtlesim", "/draw_square", "/robot_state_publisher", "/rviz2", "/wheel_spinner", DESK_NODE}
HELPERS = "/transform_listener_impl_"
"""How the nodes begin that RViz makes for itself."""


@dataclass
class Tally:
    """What happened."""

    started: int = 0
    ended_alone: int = 0
    killed: dict[str, int] = field(default_factory=dict)
    comparisons: int = 0
    seconds_to_agree: list[float] = field(default_factory=list)
    troubles: list[str] = field(default_factory=list)


class Soak:
    """One run in folders of its own."""

    def __init__(self, processes: int, seed: int) -> None:
        self.count = processes
        self.random = random.Random(seed)
        self.folder = Path(tempfile.mkdtemp(prefix="day6-soak-"))
        self.runtime, self.temporary, self.home = (self.folder / name for name in ("r", "tmp", "home"))
        for each in (self.runtime, self.temporary, self.home):
            each.mkdir(mode=0o700)
        for name, code in PROGRAMS.items():
            (self.home / f"{name}.py").write_text(START + code + "rclpy.spin(n)\n", encoding="utf-8")
        places = {"DAY6_RUNTIME_DIR": str(self.runtime), "TMPDIR": str(self.temporary), "LANG": "C.UTF-8"}
        os.environ.update(places)
        self.env = program_environment(dict(os.environ))
        self.alive: dict[str, subprocess.Popen[bytes]] = {}
        self.tally = Tally()

    # -- the churn -----------------------------------------------------------------------------------------------------

    def start_one(self) -> None:
        self.tally.started += 1
        kind = self.random.choice(list(PROGRAMS))
        name = f"{kind}_{self.tally.started}"
        self.alive[f"/{name}"] = subprocess.Popen(
            [sys.executable, str(self.home / f"{kind}.py"), name],
            env=self.env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def kill_one(self) -> None:
        name = self.random.choice(list(self.alive))
        number = self.random.choice(SIGNALS)
        process = self.alive[name]
        process.send_signal(number)
        self.tally.killed[number.name] = self.tally.killed.get(number.name, 0) + 1
        if name.startswith("/hangs") and number != signal.SIGKILL:
            process.send_signal(signal.SIGKILL)  # SIGTERM does not get a Python program out of sleep
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(0.0)

    def reap(self) -> None:
        for name in [name for name, process in self.alive.items() if process.poll() is not None]:
            self.tally.ended_alone += self.alive.pop(name).returncode in (0, 1, -signal.SIGSEGV)

    def churn(self, screen: Screen, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.reap()
            if len(self.alive) < self.count:
                self.start_one()
            elif self.random.random() < 0.5:
                self.kill_one()
            screen.read(self.random.uniform(0.05, 0.4))

    # -- looking -------------------------------------------------------------------------------------------------------

    def listed(self) -> set[str]:
        done = subprocess.run(
            [*DAY6, "ros2", "node", "list"], env=self.env, capture_output=True, text=True, timeout=60, encoding="utf-8"
        )
        return _named(done.stdout)

    def compare(self, screen: Screen) -> None:
        """Nodes are exactly those of the living processes; crashing ones may end meanwhile, so it is asked again."""
        began = time.monotonic()
        while True:
            screen.read(0.3)
            self.reap()
            listed, known = self.listed(), self.listed_by_the_desktop(screen)
            self.reap()
            expected = {*self.alive, *LESSON_NODES}
            if listed == known == expected:
                break
            if listed == expected:
                listed = known
            if time.monotonic() - began > 15:
                missing, extra = sorted(expected - listed), sorted(listed - expected)
                self.tally.troubles.append(f"listed wrongly: missing {missing}, dead but listed {extra}")
                break
        self.tally.comparisons += 1
        self.tally.seconds_to_agree.append(time.monotonic() - began)

    def listed_by_the_desktop(self, screen: Screen) -> set[str]:
        """What `ros2 node list` says in its own terminal."""
        file = self.home / "nodes.txt"
        file.unlink(missing_ok=True)
        screen.send("ros2 node list > new.txt; mv new.txt nodes.txt\r")
        end = time.monotonic() + 10
        while not file.exists() and time.monotonic() < end:
            screen.read(0.05)
        return _named(file.read_text(encoding="utf-8")) if file.exists() else set()

    def ours(self) -> list[int]:
        mark = f"DAY6_RUNTIME_DIR={self.runtime}".encode()
        found = []
        for entry in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if int(entry.name) != os.getpid() and mark in (entry / "environ").read_bytes().split(b"\0"):
                    found.append(int(entry.name))
        return found

    # -- the whole -----------------------------------------------------------------------------------------------------

    def run(self, minutes: float, warm_up: float) -> int:
        samples: list[tuple[float, int, int]] = []
        with Screen([*DAY6, "--scene", "empty", "--lang", "en", "--home", str(self.home)], 120, 40) as screen:
            screen.first_frame()
            screen.read(4)
            for line in LESSON:
                screen.send(f"{line}\r")
                screen.read(3)
            self.compare(screen)
            print("threads at first:", " ".join(sorted(_thread_names(screen.pid))))
            calm = _threads(screen.pid), _files(screen.pid), screen.rss_mb()
            end = time.monotonic() + 60 * minutes
            while (left := end - time.monotonic()) > 0:
                self.churn(screen, min(left, 27.0))
                self.compare(screen)
                samples.append((screen.rss_mb(), _threads(screen.pid), _files(screen.pid)))
                del screen.output[:-300_000]
                print(
                    f"{self.tally.started:5} started, {len(self.alive):2} alive, desktop {samples[-1][0]:.1f} MB, "
                    f"{samples[-1][1]} threads, {samples[-1][2]} files",
                    flush=True,
                )
            for process in self.alive.values():
                process.kill()
            for process in self.alive.values():
                process.wait()
            self.compare(screen)
            # Zenoh's threads that read from a connection wait a while for the next one before they end.
            waited = time.monotonic()
            while _threads(screen.pid) > calm[0] + 1 and time.monotonic() - waited < 40:
                screen.read(0.5)
            print(f"threads of the desktop settled after {time.monotonic() - waited:.0f} s")
            after = _threads(screen.pid), _files(screen.pid), screen.rss_mb()
            names = " ".join(sorted(_thread_names(screen.pid)))
            screen.send("\x11\x11")
            began = time.monotonic()
            # It is looked at, not taken: `Screen` does that.
            while not (ended := _has_ended(screen.pid)) and time.monotonic() - began < 10:
                screen.read(0.1)
            if not ended:
                self.trouble("the desktop did not end")
        if after[0] > calm[0] + 1:
            self.trouble(f"{after[0] - calm[0]} threads of the desktop are left over: {names}")
        if after[1] > calm[1] + 2:
            self.trouble(f"{after[1] - calm[1]} open files of the desktop are left over")
        memory = [sample[0] for sample in samples[int(len(samples) * warm_up / minutes) :]]
        tenth = max(1, len(memory) // 10)
        settled, last = (statistics.median(part) for part in (memory[:tenth], memory[-tenth:]))
        print(f"memory after {warm_up:g} minutes {settled:.1f} MB, at the end {last:.1f} MB")
        if not GROWTH.keeps(last - settled):
            self.trouble(f"the desktop grew from {settled:.1f} to {last:.1f} MB")
        self.look_for_leftovers()
        self.report(minutes, calm, after, samples)
        shutil.rmtree(self.folder, ignore_errors=True)
        return 1 if self.tally.troubles else 0

    def trouble(self, text: str) -> None:
        self.tally.troubles.append(text)

    def look_for_leftovers(self) -> None:
        end = time.monotonic() + 5
        while self.ours() and time.monotonic() < end:
            time.sleep(0.1)
        for pid in self.ours():
            command = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()
            self.trouble(f"process {pid} is left: {command}")
            os.kill(pid, signal.SIGKILL)
        # One more process cleans up after those that were killed, as every start does.
        if nodes := self.listed():
            self.trouble(f"nodes are left: {sorted(nodes)}")
        for path in self.runtime.rglob("*"):
            if path.is_file() and path.suffix == ".lock" and not path.name.startswith("p-"):
                continue
            if not path.is_dir():
                self.trouble(f"{path.relative_to(self.folder)} is left")
        for path in self.temporary.iterdir():
            if path.name.startswith("launch_params_"):
                continue  # the real launch_ros leaves these too
            self.trouble(f"temporary file {path.name} is left")

    def report(
        self, minutes: float, calm: tuple[int, int, float], after: tuple[int, int, float], samples: list
    ) -> None:  # type: ignore[type-arg]
        tally = self.tally
        memory = [sample[0] for sample in samples]
        killed = ", ".join(f"{count} by {name}" for name, count in sorted(tally.killed.items()))
        print(f"| soak | {minutes:g} minutes, {self.count} processes at a time |\n| --- | --- |")
        print(f"| processes started | {tally.started} |")
        print(f"| killed | {killed} |")
        print(f"| ended or crashed by themselves | {tally.ended_alone} |")
        print(
            f"| node list compared with what lives | {tally.comparisons} times, agreed after "
            f"{statistics.median(tally.seconds_to_agree):.1f} s (median), {max(tally.seconds_to_agree):.1f} s (worst), "
            "the command's own time included |"
        )
        growth = 1024 * (after[2] - calm[2]) / max(tally.started, 1)
        print(
            f"| desktop's memory | {calm[2]:.1f} MB before, {max(memory):.1f} MB at most, {after[2]:.1f} MB after: "
            f"{growth:.1f} kB a program |"
        )
        print(f"| desktop's threads, open files | {calm[0]}, {calm[1]} before; {after[0]}, {after[1]} after |")
        print(f"| left behind | {'; '.join(tally.troubles) or 'nothing'} |", flush=True)


def _named(listed: str) -> set[str]:
    return {name for name in listed.split() if not name.startswith(HELPERS)}


def _has_ended(pid: int) -> bool:
    return os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None


def _threads(pid: int) -> int:
    return len(os.listdir(f"/proc/{pid}/task"))


def _thread_names(pid: int) -> list[str]:
    return [
        Path(f"/proc/{pid}/task/{task}/comm").read_text(encoding="utf-8").strip()
        for task in os.listdir(f"/proc/{pid}/task")
    ]


def _files(pid: int) -> int:
    return len(os.listdir(f"/proc/{pid}/fd"))


def main() -> int:
    """Run and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--processes", type=int, default=20)
    parser.add_argument("--warm-up", type=float, default=5.0, metavar="MINUTES")
    parser.add_argument("--seed", type=int, default=6)
    options = parser.parse_args()
    return Soak(options.processes, options.seed).run(options.minutes, min(options.warm_up, options.minutes / 2))


if __name__ == "__main__":
    sys.exit(main())
