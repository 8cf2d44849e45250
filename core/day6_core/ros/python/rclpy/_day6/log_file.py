"""The log file of a process: `<program>_<pid>_<milliseconds>.log` in the logging directory (rcl_logging_spdlog).

Each line is written at once, so that `tail -f` shows it; the real one buffers lines for up to five seconds.
"""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from pathlib import Path


def logging_directory(env: Mapping[str, str]) -> Path:
    """Return the folder for log files: ROS_LOG_DIR, else `log` in ROS_HOME, else ~/.ros/log."""
    named = env.get("ROS_LOG_DIR")
    if named:
        return _expanded(named, env)
    return _expanded(env.get("ROS_HOME") or "~/.ros", env) / "log"


def _expanded(path: str, env: Mapping[str, str]) -> Path:
    home = env.get("HOME")
    if home and (path == "~" or path.startswith("~/")):
        return Path(home + path[1:])
    return Path(path).expanduser()


class LogFile:
    """The file of one program; it appears with `open`, or with the first line."""

    def __init__(self, program: str, pid: int, env: Mapping[str, str]) -> None:
        self.program = program
        """The prefix of the file's name."""
        self.enabled = True
        self._pid = pid
        self._env = env
        self._descriptor: int | None = None
        """Not a file object: one that is still open when the interpreter ends warns of that, which a real rclpy never does."""

    def open(self) -> None:
        """Make folder and file. Raises OSError."""
        if self._descriptor is None:
            folder = self.folder
            folder.mkdir(parents=True, exist_ok=True)
            name = f"{self.program}_{self._pid}_{time.time_ns() // 1_000_000}.log"
            self._descriptor = os.open(
                folder / name, os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o666
            )

    @property
    def folder(self) -> Path:
        """Where the file is, or will be."""
        return logging_directory(self._env)

    @property
    def is_wanted(self) -> bool:
        """Whether the user has chosen the folder for log files."""
        return bool(self._env.get("ROS_LOG_DIR") or self._env.get("ROS_HOME"))

    def write(self, line: str) -> None:
        """Write a line. A full or read-only disk must not end the program: it goes on without a file."""
        if not self.enabled:
            return
        try:
            self.open()
            assert self._descriptor is not None
            os.write(self._descriptor, f"{line}\n".encode("utf-8", "backslashreplace"))
        except OSError:
            self.enabled = False

    def close(self) -> None:
        """Close the file; the next line starts a new one."""
        if self._descriptor is not None:
            descriptor, self._descriptor = self._descriptor, None
            try:
                os.close(descriptor)
            except OSError:
                self.enabled = False


def of_process() -> LogFile:
    """Return the log file of this process, named by the program as it was started."""
    import sys

    started = sys.orig_argv[0] if sys.orig_argv else sys.executable or "python3"
    return LogFile(os.path.basename(started).removesuffix(".exe"), os.getpid(), os.environ)
