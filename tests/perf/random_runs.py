"""Numbered random runs of the desktop at a real terminal, each in a folder of its own: what `ends.py` and `attack.py` share."""

from __future__ import annotations

import argparse
import contextlib
import itertools
import os
import random
import shutil
import signal
import sys
import tempfile
import termios
import time
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from tests.perf.screen import Screen

ON_OFF = {
    "alternate screen": ("\x1b[?1049h", "\x1b[?1049l"),
    "cursor": ("\x1b[?25l", "\x1b[?25h"),
    "mouse": ("\x1b[?1000h", "\x1b[?1000l"),
    "mouse moves": ("\x1b[?1003h", "\x1b[?1003l"),
    "paste marks": ("\x1b[?2004h", "\x1b[?2004l"),
    "focus": ("\x1b[?1004h", "\x1b[?1004l"),
    "line wrap": ("\x1b[?7l", "\x1b[?7h"),
    "keyboard protocol": ("\x1b[>", "\x1b[<u"),
}


def modes_left(output: str) -> list[str]:
    """Return what was turned on in the terminal and not taken back."""
    return [name for name, (on, off) in ON_OFF.items() if output.rfind(on) > output.rfind(off)]


def processes_of(runtime: Path) -> dict[int, str]:
    """Return the command lines of the processes whose DAY6_RUNTIME_DIR that is, by their ids."""
    mark = f"DAY6_RUNTIME_DIR={runtime}".encode()
    found = {}
    for entry in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if mark in (entry / "environ").read_bytes().split(b"\0"):
                found[int(entry.name)] = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode()
    return found


@dataclass
class RandomRun:
    """One run: `deeds` tells what was done, `troubles` what was not good."""

    number: int
    random: random.Random
    folder: Path
    verbose: bool = False
    deeds: list[str] = field(default_factory=list)
    troubles: list[str] = field(default_factory=list)
    status: int | None = None

    def play(self) -> None:
        """Do everything, in the order that the random numbers give."""
        raise NotImplementedError

    def note(self, text: str) -> None:
        self.deeds.append(text)
        if self.verbose:
            print(f"  {text}", flush=True)

    def prepare(self, programs: Mapping[str, str]) -> None:
        """Make the folders, and a file for each program."""
        self.home, self.runtime, self.temporary = (self.folder / name for name in ("h", "r", "t"))
        self.stacks = self.folder / "stacks"
        for each in (self.home, self.runtime, self.temporary):
            each.mkdir(mode=0o700)
        for name, code in programs.items():
            (self.home / f"{name}.py").write_text(code, encoding="utf-8")

    def start(self, code: str, words: list[str], size: tuple[int, int], **env: str) -> None:
        """Start the desktop by Python `code`, in which {stacks!r} and {words!r} are filled in."""
        command = [sys.executable, "-c", code.format(stacks=str(self.stacks), words=words)]
        env = {"DAY6_RUNTIME_DIR": str(self.runtime), "TMPDIR": str(self.temporary), **env}
        self.screen = Screen(command, *size, cwd=str(self.folder), **env)
        self.before = termios.tcgetattr(self.screen._fd)

    def kill(self) -> None:
        os.kill(self.screen.pid, signal.SIGKILL)
        os.waitpid(self.screen.pid, 0)

    def check_terminal(self, *, modes: bool = True) -> None:
        """The terminal is as it was before."""
        if modes and (left := modes_left(self.screen.output.decode("utf-8", "replace"))):
            self.troubles.append(f"not given back: {', '.join(left)}")
        if termios.tcgetattr(self.screen._fd) != self.before:
            self.troubles.append("the terminal's settings are not given back")

    def look_for_leftovers(self) -> None:
        """Neither a process nor a temporary file is there any more."""
        end = time.monotonic() + 5
        while (left := processes_of(self.runtime)) and time.monotonic() < end:
            time.sleep(0.05)
        for pid, words in left.items():
            self.troubles.append(f"process {pid} is left: {words}")
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        for path in self.temporary.iterdir():
            self.troubles.append(f"temporary file {path.name} is left")


AnyRun = TypeVar("AnyRun", bound=RandomRun)


def options_of(
    description: str | None, *, runs: int | None, jobs: int, minutes: float | None = None
) -> argparse.Namespace:
    """Read the command line; with `minutes` a number of runs need not be given."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    if minutes is not None:
        parser.add_argument("--minutes", type=float, default=minutes)
    parser.add_argument("--runs", type=int, default=runs, help="so many runs")
    parser.add_argument("--jobs", type=int, default=jobs)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, metavar="N", help="begin with run N")
    parser.add_argument("--only", type=int, metavar="N", help="play run N alone and say what it does")
    return parser.parse_args()


def played(kind: type[AnyRun], options: argparse.Namespace) -> Iterator[AnyRun]:
    """Play `--only` one run, `--runs` many, or as many as begin within `--minutes`; yield each, in order, when it has ended."""
    for number in (
        signal.SIGINT,
        signal.SIGHUP,
    ):  # a script's `&` and `nohup` have these ignored, and so would the desktop
        signal.signal(number, signal.SIG_DFL)
    endless = options.only is None and options.runs is None
    end = time.monotonic() + 60 * options.minutes if endless else float("inf")

    def play(number: int) -> AnyRun:
        folder = Path(tempfile.mkdtemp(prefix="d6-", dir="/tmp"))
        try:
            run = kind(number, random.Random(f"{options.seed}/{number}"), folder, verbose=options.only is not None)
            run.play()
        finally:
            shutil.rmtree(folder, ignore_errors=True)
        return run

    first: int = options.first
    waves: Iterable[Iterable[int]]
    if options.only is not None:
        waves = [[options.only]]
    elif options.runs is not None:
        waves = [range(first, first + options.runs)]
    else:
        waves = (range(each, each + options.jobs) for each in itertools.count(first, options.jobs))
    with ThreadPoolExecutor(options.jobs) as pool:
        for wave in waves:
            if time.monotonic() > end:
                break
            yield from pool.map(play, wave)
