"""A stranger declares thousands of nodes behind the desktop's open door: what it costs, and that it is forgotten. Linux, by hand.

    python -m tests.perf.hostile_machine [--nodes 20000] [--ways close,kill,stop,end]

For each way of parting a desktop with `--listen` on this machine's loopback, a pupil's process beside it and a stranger that
speaks plain Zenoh. Printed are the seconds of CPU that the desktop and the pupil spend while the stranger declares, how many
remote nodes the pupil sees, how long a new node of the pupil's takes to be seen by a second pupil meanwhile, and how long after
the parting nothing of the stranger is left (all of its tokens have been read by then; Zenoh reads a flood to its end even
when the sender is dead): `close` undeclares and closes, `kill` is kill -9, `stop` a pulled cable (the
process sleeps, Zenoh's lease runs out), `end` is SIGTERM to the desktop, whose end is timed. Status 1 if one
is over its budget (`budgets.py`).
"""

from __future__ import annotations

import argparse
import json
import os
import pty
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.link.link_harness import HERE as LINK_TESTS
from tests.link.link_harness import ProcessPeer
from tests.perf.budgets import ENDED, FORGOTTEN
from tests.support.free_port import free_port

NODES = "@ros2_lv/0/ffffffffffffffff/{}/{}/NN/%/%/flood{}"
TICK = os.sysconf("SC_CLK_TCK")


def cpu(pid: int) -> float:
    """Seconds of CPU that a process has used."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def memory(pid: int) -> float:
    """Megabytes that a process has in memory."""
    return int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1]) * 4096 / 1e6


def seconds_until(condition: Callable[[], Any], most: float) -> float:
    """Seconds until `condition` is true; infinite if not within `most`."""
    started = time.monotonic()
    while not condition():
        if time.monotonic() - started > most:
            return float("inf")
        time.sleep(0.02)
    return time.monotonic() - started


def wait_until_quiet(pid: int) -> None:
    """Wait until a process uses less than a tenth of a core."""
    used = -1.0
    while (now := cpu(pid)) - used > 0.1:
        used = now
        time.sleep(1.0)


class Desktop:
    """The desktop at a terminal of 80x24, with a door on `port`."""

    def __init__(self, runtime: Path, home: Path, port: int, words: list[str]) -> None:
        screen, terminal = pty.openpty()
        environment = {**os.environ, "DAY6_RUNTIME_DIR": str(runtime), "TERM": "xterm-256color", "LANG": "C.UTF-8"}
        command = [
            str(Path(sys.executable).with_name("day6-tui")),
            "--home",
            str(home),
            "--listen",
            f"tcp/127.0.0.1:{port}",
            *words,
        ]
        self.process = subprocess.Popen(
            command, stdin=terminal, stdout=terminal, stderr=terminal, env=environment, start_new_session=True
        )
        os.close(terminal)
        threading.Thread(target=self._swallow, args=(screen,), daemon=True).start()

    @staticmethod
    def _swallow(screen: int) -> None:
        try:
            while os.read(screen, 65536):
                pass
        except OSError:
            pass  # the end of a terminal

    def seconds_to_end(self) -> float:
        """Send SIGTERM; return how long the end takes."""
        started = time.monotonic()
        self.process.terminate()
        try:
            self.process.wait(60)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            return float("inf")
        return time.monotonic() - started


class Stranger:
    """tests/link/hostile_peer.py in a process of its own."""

    def __init__(self, port: int) -> None:
        script = [sys.executable, str(LINK_TESTS / "hostile_peer.py"), str(port)]
        self.process = subprocess.Popen(script, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout is not None and self.process.stdout.readline() == "ready\n"

    def declare(self, nodes: int) -> None:
        """Declare so many nodes; return when Zenoh has taken them."""
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.write(json.dumps(["tokens", [NODES, nodes], {}]) + "\n")
        self.process.stdin.flush()
        self.process.stdout.readline()

    def part(self, way: str) -> None:
        """Be gone."""
        if way == "close":
            assert self.process.stdin is not None
            self.process.stdin.close()
            self.process.wait()  # Zenoh first takes all back, which takes long
        else:
            self.process.send_signal(signal.SIGKILL if way == "kill" else signal.SIGSTOP)

    def bury(self) -> None:
        """End whatever is left."""
        self.process.kill()
        self.process.wait()


def flooded(pupil: Any) -> int:
    return sum(name.startswith("/flood") for name in pupil.nodes())


def play(way: str, nodes: int, folder: Path, words: list[str]) -> bool:
    """Play one way of parting and print what it cost; say whether it was within the budgets."""
    runtime, port = folder / "r", free_port()
    desktop = Desktop(runtime, folder / "home", port, words)
    settings = {"DAY6_RUNTIME_DIR": str(runtime), "DAY6_LINK": "on"}
    door = socket.socket()
    seconds_until(lambda: door.connect_ex(("127.0.0.1", port)) == 0, 20)
    door.close()
    pupils: list[Any] = [ProcessPeer(settings, folder / "stderr") for _ in range(2)]
    pupils[0].node("first")
    seconds_until(lambda: "/first" in pupils[1].nodes(), 20)
    pids = [desktop.process.pid, pupils[0].pid()]
    stranger = Stranger(port)
    before = [cpu(pid) for pid in pids]
    started = time.monotonic()
    stranger.declare(nodes)
    declared = time.monotonic() - started
    pupils[0].node("second")
    seen = seconds_until(lambda: "/second" in pupils[1].nodes(), 60)
    if way != "end":
        wait_until_quiet(desktop.process.pid)  # what the stranger costs is not over with its last word
    there = flooded(pupils[1])
    spent = [cpu(pid) - past for pid, past in zip(pids, before, strict=True)]
    size = [memory(pid) for pid in pids]
    if way == "end":
        took, budget = desktop.seconds_to_end(), ENDED
    else:
        stranger.part(way)
        took, budget = seconds_until(lambda: all(flooded(pupil) == 0 for pupil in pupils), 60), FORGOTTEN
    left = [pupil.nodes() for pupil in pupils]
    print(
        f"{way:6} {nodes} declared in {declared:.1f} s; CPU desktop {spent[0]:.1f} s, pupil {spent[1]:.1f} s; memory "
        f"{size[0]:.0f}, {size[1]:.0f} MB; {there} seen; a new node seen after {seen:.2f} s; "
        f"{'ended' if way == 'end' else 'forgotten'} after {took:.1f} s; stay {[len(names) for names in left]}",
        flush=True,
    )
    stranger.bury()
    if way != "end":
        desktop.seconds_to_end()
    for pupil in pupils:
        pupil.kill()
    return budget.keeps(took)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nodes", type=int, default=20_000)
    parser.add_argument("--ways", default="close,kill,stop,end")
    parser.add_argument("words", nargs="*", help="more for the desktop, such as -- --secret FILE")
    options = parser.parse_args()
    good = True
    for way in options.ways.split(","):
        with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
            good &= play(way, options.nodes, Path(folder), options.words)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
