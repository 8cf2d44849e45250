"""Starts the desktop again and again, does random things in it, and ends it in a random way. Linux only, by hand.

    python -m tests.perf.ends [--runs 500] [--jobs 2] [--seed 1] [--only N]

Every run has a number; `--seed` and the number give the same scene, keys and programs again (`--only N` plays that run alone
and prints what it does). A run is good when the desktop ended in time and with the status that belongs to how it was ended,
gave the terminal back as it was, printed no traceback, and left neither a process nor a temporary file behind. What hangs
writes the stacks of its threads first. The exit status is 1 if any run was not good.
"""

from __future__ import annotations

import contextlib
import os
import re
import select
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tests.perf.random_runs import RandomRun, options_of, played, processes_of
from tests.perf.screen import set_window_size

START = """\
import faulthandler, signal, sys
faulthandler.register(signal.SIGUSR1, file=open({stacks!r}, "w"), all_threads=True)
from day6_tui.main import main
sys.argv[1:] = {words!r}
sys.exit(main())
"""
"""The installed command, which moreover writes its stacks on SIGUSR1."""

KEYS = (
    "\r", "\t", "\x1b", "\x1b[A", "\x1b[B", "\x1b[C", "\x1b[D", "\x1bOP", "\x1bOQ", "\x1bOR", "\x1bOS", "\x1b[15~",
    "\x1b[17~", "\x1b[18~", "\x1b[19~", "\x1b[20~", "\x1b[21~", "\x1b[23~", "\x1b[24~", "\x03", "\x04", "\x0c", "\x10",
    "\x12", "\x1a", "\x1c", "\x7f", "a", "b", "q", "y", "n", " ", "é", "中",
)  # fmt: skip
"""What random keys are taken from: all but ^Q, which ends."""
KINDS = ("line", "line", "line", "keys", "keys", "mouse", "resize", "paste", "stop", "wait")
PROGRAMS = {
    "stubborn": "import signal, time\nfor n in (1, 2, 15): signal.signal(n, signal.SIG_IGN)\nwhile True: time.sleep(9)\n",
    "forks": "import os, time\nfor _ in range(5):\n    if os.fork() == 0: os.setpgid(0, 0)\ntime.sleep(99)\n",
    "leaves": "import os, time\nif os.fork() == 0:\n    os.setsid()\n    time.sleep(99)\ntime.sleep(99)\n",
    "floods": "while True: print('x' * 70)\n",
    "raw": "import time, tty\ntty.setraw(0)\ntime.sleep(99)\n",
    "spins": "while True: pass\n",
    "node": "import rclpy\nfrom rclpy.node import Node\nrclpy.init()\nrclpy.spin(Node('n'))\n",
    "late": "import atexit, time\natexit.register(time.sleep, 60)\ntime.sleep(60)\n",
}
LINES = (
    *(f"python3 {name}.py" for name in PROGRAMS),
    *(f"python3 {name}.py &" for name in PROGRAMS),
    "ros2 run turtlesim turtlesim_node",
    "ros2 run demo_nodes_py talker &",
    "ros2 topic echo /chatter",
    "ros2 launch demo_nodes_py talker_listener.launch.py",
    "rqt_graph &",
    "rviz2 &",
    "nano talker.py",
    "while true; do :; done",
    "sleep 1000 | cat",
    "yes",
    "ros2 bag record -a",
)
DESK_LIMIT, SECOND_LIMIT = 8.0, 3.0
"""Seconds in which the desktop has to be gone, and after a second signal; generous, as the machine may have other work."""
SLOW = 4.0
"""Seconds after which what it does is written down: programs have two, the rest should be quick."""


@dataclass
class Run(RandomRun):
    """One start and end."""

    way: str = ""
    seconds: float = 0.0
    hung_up: bool = False
    """The terminal's window is gone, so that nothing can be seen of what was given back."""
    stuck: bool = False
    """Nothing can be written to the terminal any more."""

    # -- what a run does -----------------------------------------------------------------------------------------------

    def play(self) -> None:
        self.prepare(PROGRAMS)
        scene = self.random.choice([None, "turtle", "car", "world", "empty", "empty"])
        words = ["--home", str(self.home), "--lang", self.random.choice(["en", "zh"])]
        words += [] if scene is None else ["--scene", scene]
        columns, rows = self.random.choice([(80, 24), (120, 40), (40, 10)])
        self.note(f"scene {scene}, {columns}x{rows}")
        self.start(START, words, (columns, rows))
        early = self.random.random() < 0.2
        if early:
            self.wait_for_handlers()
            self.screen.read(self.random.uniform(0, 0.5))
            self.note("ended while it starts")
        else:
            with contextlib.suppress(TimeoutError, OSError):
                self.screen.first_frame()
            self.busy()
        name, statuses, limit = self.end()
        self.way = name
        began = time.monotonic()
        status = self.wait(min(limit, SLOW))
        if status is None:
            self.signal(signal.SIGUSR1)
            status = self.wait(limit - SLOW)
            if status is not None:
                self.troubles.append(f"took {time.monotonic() - began:.1f} s\n{self.stacks.read_text()}")
        self.seconds = time.monotonic() - began
        if status is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.screen.pid, signal.SIGUSR1)
            time.sleep(0.5)
            self.troubles.append(f"still runs after {limit} s\n{self.stacks.read_text()}")
            self.kill()
        else:
            self.check(status, statuses)
        self.look_for_leftovers()
        if not self.hung_up:
            os.close(self.screen._fd)

    def wait_for_handlers(self) -> None:
        """Until Python itself has started: what comes before our first line is not ours."""
        end = time.monotonic() + 10
        while time.monotonic() < end and not self.stacks.exists():
            time.sleep(0.005)

    def busy(self) -> None:
        """Do some random things."""
        for _ in range(self.random.randint(0, 6)):
            kind = self.random.choice(KINDS)
            if kind == "line":
                text = self.random.choice(LINES)
                self.type(text + "\r")
            elif kind == "keys":
                self.type("".join(self.random.choices(KEYS, k=self.random.randint(1, 12))))
            elif kind == "mouse":
                x, y = self.random.randint(1, 120), self.random.randint(1, 40)
                self.type(f"\x1b[<0;{x};{y}M\x1b[<0;{x};{y}m")
            elif kind == "resize":
                columns, rows = self.random.randint(2, 150), self.random.randint(2, 50)
                self.note(f"resize {columns}x{rows}")
                set_window_size(self.screen._fd, columns, rows)
            elif kind == "paste":
                self.type("\x1b[200~" + "echo pasted\n" * self.random.randint(1, 30) + "\x1b[201~")
            elif kind == "stop":
                number = self.random.choice([signal.SIGTSTP, signal.SIGSTOP, signal.SIGCONT])
                self.note(f"{number.name}, SIGCONT")
                self.signal(number)
                self.wait_for_stop(0 if number == signal.SIGCONT else 2)
                self.screen.read(self.random.uniform(0, 0.4))
                self.signal(signal.SIGCONT)
            self.screen.read(self.random.uniform(0, 0.6))
        self.screen.read(self.random.choice([0, 0.2, 1.0]))

    def wait_for_stop(self, limit: float) -> None:
        """Until it stands still: SIGCONT before that would be forgotten."""
        end = time.monotonic() + limit
        while time.monotonic() < end:
            if Path(f"/proc/{self.screen.pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "T":
                return
            self.screen.read(0.02)

    def type(self, text: str) -> None:
        self.note(f"type {text[:60]!r}")
        with contextlib.suppress(OSError):
            self.screen.send(text)

    # -- ways to end ---------------------------------------------------------------------------------------------------

    def end(self) -> tuple[str, set[int], float]:
        """End it; returns the name of the way, the statuses that belong to it and the seconds it may take."""
        way = self.random.choice(WAYS)
        self.note(way.__name__)
        statuses, limit = way(self)
        return way.__name__, statuses, limit

    def signal(self, number: int) -> None:
        if self.status is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.screen.pid, number)

    def wait(self, limit: float, *, read: bool = True) -> int | None:
        """Look on until it has ended; returns the status, None if it has not within `limit` seconds."""
        end = time.monotonic() + limit
        while self.status is None and time.monotonic() < end:
            if not self.hung_up and read:
                if select.select([self.screen._fd], [], [], 0.02)[0]:
                    with contextlib.suppress(OSError):
                        self.screen.output += os.read(self.screen._fd, 65536)
            else:
                time.sleep(0.02)
            pid, status = os.waitpid(self.screen.pid, os.WNOHANG)
            if pid:
                if not self.hung_up:
                    self.screen.read(0.05)
                self.status = os.waitstatus_to_exitcode(status)
        return self.status

    # -- what must hold ------------------------------------------------------------------------------------------------

    def check(self, status: int, statuses: set[int]) -> None:
        if (status if status >= 0 else 128 - status) not in statuses:  # a shell says the same of both
            self.troubles.append(f"status {status}, not one of {sorted(statuses)}")
        if self.hung_up:
            return
        self.check_terminal(modes=not self.stuck)
        output = self.screen.output.decode("utf-8", "replace")
        outside = re.sub(r"\x1b\[\?1049h.*?(?:\x1b\[\?1049l|\Z)", "", output, flags=re.DOTALL)
        if "Traceback" in outside or "Error" in outside or "Exception" in outside:
            self.troubles.append(f"printed\n{outside[-3000:]}")


Ended = tuple[set[int], float]


def quit_key(run: Run) -> Ended:
    run.type("\x11\x11")
    # A dialog or a full-screen program may have wanted the key: a person presses it again.
    if run.wait(2.0) is None:
        run.type("\x1b\x11\x11")
        if run.wait(4.0) is None:
            run.signal(signal.SIGTERM)
            return {0, 143}, DESK_LIMIT
    return {0}, DESK_LIMIT


def terminate(run: Run) -> Ended:
    run.signal(signal.SIGTERM)
    return {143}, DESK_LIMIT


def hang_up(run: Run) -> Ended:
    run.signal(signal.SIGHUP)
    return {129}, DESK_LIMIT


def interrupt(run: Run) -> Ended:
    run.signal(signal.SIGINT)
    return {130}, DESK_LIMIT


def close_window(run: Run) -> Ended:
    os.close(run.screen._fd)
    run.hung_up = True
    return {129}, DESK_LIMIT


def terminate_twice(run: Run) -> Ended:
    run.signal(signal.SIGTERM)
    time.sleep(run.random.uniform(0, 0.5))
    run.signal(signal.SIGTERM)
    return {143}, SECOND_LIMIT


def impatient(run: Run) -> Ended:
    """^Q, then Ctrl-C while it quits: a key first, a signal as soon as the terminal is given back."""
    run.type("\x11\x11")
    for _ in range(run.random.randint(1, 30)):
        run.wait(run.random.uniform(0, 0.1))
        with contextlib.suppress(OSError):
            run.screen.send("\x03")
    run.signal(signal.SIGINT)
    return {0, 130}, SECOND_LIMIT


def mixed_signals(run: Run) -> Ended:
    for _ in range(run.random.randint(2, 5)):
        run.signal(run.random.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP]))
        time.sleep(run.random.uniform(0, 0.2))
    return {129, 130, 143}, SECOND_LIMIT


def stopped(run: Run) -> Ended:
    run.signal(signal.SIGTSTP)
    run.wait_for_stop(2)
    run.signal(signal.SIGTERM)
    run.signal(signal.SIGCONT)
    return {143}, DESK_LIMIT


def stuck_terminal(run: Run) -> Ended:
    """Nobody reads what it draws (a connection that hangs), and it is told to go."""
    run.stuck = True
    run.type("yes\r")
    time.sleep(1.0)
    run.signal(signal.SIGTERM)
    if run.wait(DESK_LIMIT, read=False) is None:
        run.troubles.append("does not end while its terminal is stuck")
    return {143}, DESK_LIMIT


def child_killed(run: Run) -> Ended:
    """The shell that ends what we leave is killed first."""
    for pid, words in processes_of(run.runtime).items():
        if pid != run.screen.pid and run.random.random() < 0.7:
            run.note(f"kill {words[:50]}")
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
    return terminate(run)


WAYS: tuple[Callable[[Run], Ended], ...] = (
    quit_key,
    terminate,
    hang_up,
    interrupt,
    close_window,
    terminate_twice,
    impatient,
    mixed_signals,
    stopped,
    stuck_terminal,
    child_killed,
)


def main() -> int:
    """Play the runs; print a line for each that was not good, and how long each way took."""
    bad, ways, slowest = 0, Counter[str](), dict[str, float]()
    for run in played(Run, options_of(__doc__, runs=500, jobs=2)):
        ways[run.way] += 1
        slowest[run.way] = max(slowest.get(run.way, 0.0), run.seconds)
        if run.troubles:
            bad += 1
            print(f"run {run.number} ({run.way}): {'; '.join(run.deeds)}")
            for trouble in run.troubles:
                print(f"    {trouble}")
        elif run.number % 25 == 0:
            print(f"{run.number} …", flush=True)
    for name, count in sorted(ways.items()):
        print(f"| {name} | {count} times | {slowest[name]:.1f} s at most |")
    print(f"{sum(ways.values())} runs, {bad} not good", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
