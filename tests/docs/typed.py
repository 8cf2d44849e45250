"""A terminal in which the blocks of a page are typed: `day6-tui exec`, which is given one command after the other."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from time import sleep

from tests.support.waiting import Deadline, until

LONGEST = 60.0
"""Seconds of a core that a command may take."""
RETRIED = 20.0
_LINES = 'while IFS= read -r line; do echo "$line" >> "$file.out"; done'
"""Keeps what comes through a pipe line by line: what goes to a file directly is there only when its program has ended."""
_READ = rf"""
while read -r how file; do
  case $how in
    run) . "$file" < /dev/null > "$file.out" 2>&1; echo $? > "$file.status" ;;
    start) {{ . "$file" & echo $! > "$file.pid"; wait $!; echo $? > "$file.code"; }} < /dev/null 2>&1 |
      {{ {_LINES}; mv "$file.code" "$file.status"; }} & ;;
    job) {{ . "$file"; }} < /dev/null 2>&1 | {_LINES} & ;;
    interrupt) kill -INT "$(cat "$file.pid")" ;;
  esac
done
"""
"""What the terminal runs: it reads names of files, each of which holds a command."""
_ENDED_BY_CTRL_C = re.compile(r"(KeyboardInterrupt|.*ExternalShutdownException.*|.*RCLError.*context is not valid.*)")


class Typed:
    """A command that was typed."""

    def __init__(self, file: Path) -> None:
        self.file = file
        file.with_suffix(".out").touch()

    @property
    def printed(self) -> str:
        """What it has printed so far, as lines without blanks at their ends."""
        return "".join(f"{line.rstrip()}\n" for line in self._read(".out").splitlines())

    @property
    def status(self) -> int | None:
        """The status with which it has ended; None while it runs, and of a job."""
        text = self._read(".status")
        return int(text) if text.endswith("\n") else None

    def failed_by_itself(self) -> bool:
        """Whether it ended with a traceback that Ctrl-C doesn't explain."""
        _, found, rest = self.printed.rpartition("Traceback (most recent call last):\n")
        return bool(found) and not any(map(_ENDED_BY_CTRL_C.fullmatch, rest.splitlines()))

    def _read(self, suffix: str) -> str:
        file = self.file.with_suffix(suffix)
        return file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""


class Terminal:
    """One simulated terminal with a home of its own, `folder`/home."""

    def __init__(self, folder: Path, runtime: Path, language: str) -> None:
        self.home, self.real, self._typed = (folder / name for name in ("home", "real", "typed"))
        for made in (self.home, self.real, self._typed):
            made.mkdir(parents=True)
        own = {f"XDG_{name}_HOME": str(folder / name.lower()) for name in ("DATA", "CONFIG", "CACHE", "STATE")}
        self.environment = {
            **os.environ,
            **own,
            "HOME": str(self.real),
            "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]),
            "DAY6_LINK": "",
            "DAY6_RUNTIME_DIR": str(runtime),
            "DAY6_LANG": language,
            "PYTHONUNBUFFERED": "1",  # what programs print goes to a file
        }
        self._count = 0
        self._process: subprocess.Popen[str] | None = None

    def type(self, command: str) -> Typed:
        """Run a command to its end."""
        typed = self._tell("run", command)
        until(lambda: typed.status is not None, LONGEST, told=lambda: f"it still runs: {command}\n{typed.printed}")
        return typed

    def start(self, command: str) -> Typed:
        """Start a command beside the next ones, as in another terminal."""
        return self._tell("start", command)

    def start_job(self, command: str) -> Typed:
        """Start a command as `command &` does."""
        return self._tell("job", command)

    def interrupt(self, typed: Typed) -> Typed:
        """Press Ctrl-C, unless it has ended, and wait for its end."""
        until(lambda: typed._read(".pid").endswith("\n"))
        if typed.status is None:
            self._say("interrupt", typed.file)
        until(lambda: typed.status is not None, told=lambda: f"Ctrl-C did not end it: {typed.printed}")
        return typed

    def interrupt_after(self, typed: Typed, seconds: float) -> Typed:
        """Press Ctrl-C after so many seconds of a core, unless it has ended by itself."""
        deadline = Deadline(seconds)
        while typed.status is None and not deadline.is_over():
            sleep(0.05)
        return self.interrupt(typed)

    def close(self) -> None:
        """Close the terminal; what still runs in it ends."""
        if self._process is not None:
            assert self._process.stdin is not None
            self._process.stdin.close()
            try:
                self._process.wait(10)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()

    def _tell(self, how: str, command: str) -> Typed:
        self._count += 1
        file = self._typed / f"{self._count}"
        file.write_text(f"{command}\n", encoding="utf-8")
        self._say(how, file)
        return Typed(file)

    def _say(self, how: str, file: Path) -> None:
        if self._process is None:
            program = shutil.which("day6-tui", path=self.environment["PATH"])
            assert program is not None, "day6-tui is not installed"
            command = [program, "exec", "--home", str(self.home), "-c", _READ]
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, encoding="utf-8", cwd=self.home, env=self.environment
            )
        assert self._process.stdin is not None
        self._process.stdin.write(f"{how} {file.as_posix()}\n")
        self._process.stdin.flush()
