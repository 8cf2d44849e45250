"""Measures a class on this machine: kept desktops, one a pupil, each looked at in a tab of 120x40. One table.

    python -m tests.perf.class [--pupils 1 8 16 30] [--seconds S] [--no-bomb] [--serve] [--busy N]

Every pupil has a home folder and a domain of his own; a tab speaks to the desktop's keeper as `day6-tui attach` does, without a
terminal of its own. For each number of pupils: memory (PSS of desktop and keeper), the seconds from the moment in which all come
until the first, the middle and the last desktop has started, and until one is seen again after a reload, CPU of a session with
the turtle standing and driving (ten commands a second), bytes for a tab, and the milliseconds from a key to its echo in one tab,
while all turtles stand, while those of the others drive, while all drive, and beside a pupil's fork bomb of 200 processes at
most, which ends by itself. Same user for all, without isolation. Linux only.

With --serve the tabs are those of a real `day6-tui serve`: a desktop has started when its tab has the first picture, and what the
server itself takes is told below each row. With --busy so many loops keep the machine busy. What is too slow to be measured is
named, the rest is measured all the same, and nothing is left running.

Below: how many pupils fit, by CPU (a core is 70 % full at most, half of the class drives) and by memory (1 GB for the rest).
"""

from __future__ import annotations

import argparse
import contextlib
import os
import select
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

RUNTIME = tempfile.mkdtemp(prefix="day6-class-")
os.environ["DAY6_RUNTIME_DIR"] = RUNTIME

from day6_tui.detached import meeting, view, wire  # noqa: E402
from tests.perf.load import PUBLISH, TURTLE  # noqa: E402  (the line above is read at import)
from tests.perf.runs import loops  # noqa: E402
from tests.perf.served import PATIENCE, Server, Tab, TooSlow  # noqa: E402

SIZE = [40, 120, 0, 0]
DRIVE = PUBLISH + " &\n"
KEYS = "zqwj"
"""Letters that nothing on the screen shows by itself."""
ECHOES = 40
PICTURE = 1500
"""Bytes that a first picture has at least."""
BOMB_SECONDS, BOMB_PROCESSES = 15, 200
BOMB = f"""
import os, time
end = time.time() + {BOMB_SECONDS}
made = 1
while made < {BOMB_PROCESSES} and os.fork():
    made += 1
while time.time() < end:
    pass
"""
"""Forks until there are 200, and every one of them keeps a core busy."""
FULL, DRIVING, REST_GB = 0.7, 0.5, 1.0


def wait_for(what: str, is_done: Callable[[], object], pause: Callable[[], object]) -> None:
    """Pause until it is done. Raises TooSlow."""
    began = time.perf_counter()
    while not is_done():
        if time.perf_counter() - began > PATIENCE:
            raise TooSlow(f"{what}: not within {PATIENCE:.0f} s, load {os.getloadavg()[0]:.0f}")
        pause()


class Pupil:
    """One kept desktop and the tab that shows it."""

    def __init__(self, number: int) -> None:
        self.home = Path(tempfile.mkdtemp(prefix="day6-class-"))
        (self.home / "bomb.py").write_text(BOMB, encoding="utf-8")
        env = {**os.environ, "TERM": "xterm-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8"}
        command = [sys.executable, "-m", "day6_tui.main", "--detach", "--home", str(self.home), "--lang", "en"]
        self.began = time.perf_counter()
        self.starting = subprocess.Popen(
            [*command, "--scene", "empty"],
            env={**env, "ROS_DOMAIN_ID": str(number)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )
        self.output = bytearray()
        self.received = 0
        self.line: wire.Connection | None = None

    def has_started(self) -> bool:
        """Whether the desktop is there."""
        if status := self.starting.poll():
            raise RuntimeError(f"a desktop did not start: status {status}")
        return status is not None

    def find_processes(self) -> list[int]:
        """Keeper and desktop."""
        self.processes = [
            int(folder.name)
            for folder in Path("/proc").iterdir()
            if folder.name.isdecimal() and os.fsencode(self.home) in _command_of(folder).split(b"\0")
        ]
        return self.processes

    def open(self) -> float:
        """Open a tab, as a reload does; the seconds until the whole screen was sent."""
        began = self._last = time.perf_counter()
        self.reload()
        self.output.clear()
        wait_for(f"{self.home.name} sees its desktop again", self._is_whole, lambda: None)
        return self._last - began

    def _is_whole(self) -> bool:
        """Whether nothing more comes for now."""
        assert self.line is not None
        if select.select([self.line], [], [], 0.15)[0]:
            self.take()
            self._last = time.perf_counter()
            return False
        return len(self.output) > PICTURE

    def reload(self) -> None:
        """Have the whole screen sent anew."""
        if self.line is not None:
            self.line.close()
        connection = meeting.connect(self.home)
        assert connection is not None, "the keeper does not answer"
        self.line = wire.Connection(connection)
        self.line.send(wire.HELLO, view.hello(SIZE))

    def take(self) -> None:
        """Read what has come."""
        assert self.line is not None
        for kind, data in self.line.receive():
            if kind == wire.OUTPUT:
                self.output += data
                self.received += len(data)

    def type(self, text: str) -> None:
        assert self.line is not None
        self.line.send(wire.INPUT, text.encode())

    def cpu_seconds(self) -> float:
        """What desktop and keeper have used."""
        total = 0
        for process in self.processes:
            for task in Path(f"/proc/{process}/task").iterdir():
                with contextlib.suppress(OSError):  # a thread that has ended meanwhile
                    total += int((task / "schedstat").read_text().split()[0])
        return total / 1e9

    def pss_mb(self) -> float:
        """The memory of both."""
        found = 0.0
        for process in self.processes:
            lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
            found += next(int(line.split()[1]) for line in lines if line.startswith("Pss:")) / 1024
        return found

    def end(self) -> None:
        """End the desktop, and wait for it."""
        if self.line is not None:
            self.line.close()
        for number in (signal.SIGTERM, signal.SIGKILL):
            for process in self.find_processes():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process, number)
            deadline = time.monotonic() + 20
            while self.find_processes() and time.monotonic() < deadline:
                time.sleep(0.1)


class ServedPupil(Pupil):
    """The same behind `day6-tui serve`."""

    def __init__(self, number: int, server: Server) -> None:
        self._server, self._name = server, f"pupil{number}"
        self.home = server.homes / self._name
        self.output = bytearray()
        self.received = 0
        self.began = time.perf_counter()
        self.tab = Tab(server, self._name)
        self.line = self.tab  # type: ignore[assignment]

    def has_started(self) -> bool:
        if len(self.output) <= PICTURE:
            return False
        (self.home / "bomb.py").write_text(BOMB, encoding="utf-8")
        return True

    def reload(self) -> None:
        self.tab.reload()

    def end(self) -> None:
        self.tab.close()  # the server ends the desktop


def _command_of(folder: Path) -> bytes:
    try:
        return (folder / "cmdline").read_bytes()
    except OSError:
        return b""


def look(pupils: list[Pupil], seconds: float) -> None:
    """Let all tabs read for so long."""
    lines = {each.line.fileno(): each for each in pupils if each.line is not None}
    deadline = time.perf_counter() + seconds
    while (left := deadline - time.perf_counter()) > 0:
        for number in select.select(list(lines), [], [], left)[0]:
            lines[number].take()


def starts(pupils: list[Pupil]) -> list[float]:
    """Wait for all desktops; the seconds in which each has started, in order."""
    left, seconds = list(pupils), []

    def is_done() -> bool:
        for pupil in [each for each in left if each.has_started()]:
            left.remove(pupil)
            seconds.append(time.perf_counter() - pupil.began)
        return not left

    try:
        wait_for("", is_done, lambda: look(pupils, 0.02))
    except TooSlow as error:
        raise TooSlow(f"{len(left)} of {len(pupils)} desktops start{error}") from None
    return sorted(seconds)


def usage(pupils: list[Pupil], seconds: float) -> tuple[float, float]:
    """Mean CPU in percent of a core, and bytes a second, of one session."""
    cpu, received = sum(each.cpu_seconds() for each in pupils), sum(each.received for each in pupils)
    began = time.perf_counter()
    look(pupils, seconds)
    seconds = (time.perf_counter() - began) * len(pupils)
    used = sum(each.cpu_seconds() for each in pupils) - cpu
    return 100 * used / seconds, (sum(each.received for each in pupils) - received) / seconds


def echoes(pupils: list[Pupil], count: int = ECHOES, most: float = 60.0) -> tuple[float, float]:
    """Type into the first tab while all read: milliseconds to the echo, median and the worst but one in twenty."""
    typist, times, began = pupils[0], [], time.perf_counter()
    for number in range(count):
        key = KEYS[number % len(KEYS)]
        look(pupils, 0.1)
        typist.output.clear()
        sent = time.perf_counter()
        typist.type(key)
        while key.encode() not in typist.output and time.perf_counter() - sent < 10:
            look(pupils, 0.002)
        times.append(1000 * (time.perf_counter() - sent))
        if time.perf_counter() - began > most:
            break
    typist.type("\x15")  # Ctrl-U
    return statistics.median(times), statistics.quantiles(times, n=20)[-1]


def a_class(count: int, seconds: float, bomb: bool, server: Server | None) -> list[str]:
    """Measure so many pupils; the cells of the row, and the figures for the extrapolation at the end."""
    pupils: list[Pupil] = []
    try:
        for number in range(1, count + 1):
            pupils.append(Pupil(number) if server is None else ServedPupil(number, server))
        started = starts(pupils)
        for pupil in pupils:
            pupil.find_processes()
        for pupil in pupils:
            pupil.open()
        look(pupils, 1)
        for pupil in pupils:
            pupil.type(TURTLE)
        look(pupils, 4 + count / 8)
        memory = statistics.mean(each.pss_mb() for each in pupils)
        before = server.cpu_seconds() if server is not None else 0.0
        standing, _ = usage(pupils, seconds)
        stands = server.cpu_seconds() - before if server is not None else 0.0
        alone = echoes(pupils)
        reloads = [pupil.open() for pupil in pupils]
        for pupil in pupils[1:]:
            pupil.type(DRIVE)
        look(pupils, 4 + count / 8)
        others_drive = echoes(pupils)
        pupils[0].type(DRIVE)
        look(pupils, 2)
        before = server.cpu_seconds() if server is not None else 0.0
        driving, sent = usage(pupils, seconds)
        if server is not None:
            SERVER[count] = 100 * stands / seconds, 100 * (server.cpu_seconds() - before) / seconds
        drives = echoes(pupils)
        beside = "-"
        if bomb and count > 1:
            pupils[-1].type("python3 bomb.py\n")
            look(pupils, 3)
            beside = "{:.0f} / {:.0f}".format(*echoes(pupils, most=BOMB_SECONDS - 4))
            look(pupils, BOMB_SECONDS / 2)
        RESULTS[count] = standing, driving, memory
        return [
            str(count),
            f"{memory:.1f}",
            f"{standing:.2f}",
            f"{driving:.2f}",
            f"{sent:.0f}",
            f"{started[0]:.1f} / {statistics.median(started):.1f} / {started[-1]:.1f}",
            f"{statistics.median(reloads):.2f} / {max(reloads):.2f}",
            "{:.0f} / {:.0f}".format(*alone),
            "{:.0f} / {:.0f}".format(*others_drive) if count > 1 else "-",
            "{:.0f} / {:.0f}".format(*drives),
            beside,
        ]
    finally:
        for pupil in pupils:
            pupil.end()


RESULTS: dict[int, tuple[float, float, float]] = {}
SERVER: dict[int, tuple[float, float]] = {}
HEADS = (
    "pupils",
    "PSS MB each",
    "CPU % standing",
    "driving",
    "bytes/s a tab",
    "started s first / median / last",
    "reload s median / worst",
    "key ms p50 / p95, all stand",
    "others drive",
    "all drive",
    "beside a fork bomb",
)


def main() -> int:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pupils", type=int, nargs="+", default=[1, 8, 16, 30], metavar="N")
    parser.add_argument("--seconds", type=float, default=8.0)
    parser.add_argument("--no-bomb", action="store_true")
    parser.add_argument("--serve", action="store_true")
    parser.add_argument("--busy", type=int, default=0, metavar="N")
    options = parser.parse_args()
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the beginning\n")
    print(f"| {' | '.join(HEADS)} |\n|{' --- |' * len(HEADS)}")
    slow = False
    for count in options.pupils:
        server = Server(Path(tempfile.mkdtemp(prefix="day6-served-"))) if options.serve else None
        try:
            with loops(options.busy):
                print(f"| {' | '.join(a_class(count, options.seconds, not options.no_bomb, server))} |", flush=True)
            if server is not None:
                print("(the server itself: {:.2f} % of a core standing, {:.2f} % driving)".format(*SERVER[count]))
        except TooSlow as error:
            slow = True
            print(f"({count} pupils: too slow: {error})", flush=True)
        finally:
            if server is not None and not server.close():
                slow = True
                print(f"({count} pupils: the server had to be killed)", flush=True)
    if not RESULTS:
        return 1
    standing, driving, memory = RESULTS[max(RESULTS)]
    mixed = DRIVING * driving + (1 - DRIVING) * standing
    print(
        f"\nBy the figures with {max(RESULTS)} pupils: half of them driving, a session takes {mixed:.1f} % of a core."
    )
    for cores, gigabytes in ((2, 4), (4, 8)):
        by_cpu, by_memory = cores * 100 * FULL / mixed, (gigabytes - REST_GB) * 1024 / memory
        print(f"{cores} cores, {gigabytes} GB: {by_cpu:.0f} pupils by CPU, {by_memory:.0f} by memory.")
    return int(slow)


if __name__ == "__main__":
    sys.exit(main())
