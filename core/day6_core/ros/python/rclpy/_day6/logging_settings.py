"""Logging settings: levels, console format, colours, /rosout (rcutils/logging.c, rcl/logging_rosout.c).

A process has one set of settings, as real ROS has; a program inside day6-tui has its own.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from rclpy._day6.time_base import MACHINE_TIME, TimeBase

if TYPE_CHECKING:
    from rclpy._day6.log_file import LogFile
    from rclpy._day6.rosout import RosoutPublisher

NAMES = {0: "UNSET", 10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
INFO = 20
DEFAULT_FORMAT = "[{severity}] [{time}] [{name}]: {message}"
_RESET = "\033[0m"
_COLOURS = {10: "\033[32m", 20: _RESET, 30: "\033[33m", 40: "\033[31m", 50: "\033[31m"}


class LoggingSettings:
    """Levels and outputs. `write` takes whole lines; None is stderr (stdout with RCUTILS_LOGGING_USE_STDOUT=1)."""

    def __init__(self, time_source: TimeBase = MACHINE_TIME, env: Mapping[str, str] | None = None) -> None:
        self.time = time_source
        self.write: Callable[[str], Any] | None = None
        self.file: LogFile | None = None
        self.to_console = True
        self.to_rosout = True
        self.levels: dict[str, int] = {}
        self.default_level = INFO
        self.publishers: dict[str, RosoutPublisher] = {}
        """logger name -> the /rosout publisher its messages go out by"""
        self._effective: dict[str, int] = {}
        self._env = os.environ if env is None else env
        self._format: str | None = None

    def set_level(self, name: str, level: int) -> None:
        """Set the level of a logger; '' is the default of all."""
        if name:
            self.levels[name] = level
        else:
            self.default_level = level
        self._effective.clear()

    def level(self, name: str) -> int:
        """Return the level set for exactly that logger, 0 if none is."""
        return self.levels.get(name, 0) if name else self.default_level

    def effective_level(self, name: str) -> int:
        """Return the effective level of a logger: its own, else that of the nearest parent, else the default."""
        level = self._effective.get(name)
        if level is None:
            level = self._effective[name] = self._find_level(name)
        return level

    def _find_level(self, name: str) -> int:
        while name:
            level = self.levels.get(name, 0)
            if level:
                return level
            name = name.rpartition(".")[0]
        return self.default_level

    def reset(self) -> None:
        """Forget all levels."""
        self.levels.clear()
        self._effective.clear()
        self.default_level = INFO
        self._format = None

    def emit(self, severity: int, name: str, message: str, function: str, file: str, line: int) -> None:
        """Write one message to the console and publish it on /rosout; the caller has checked the level."""
        stamp = self.time.now_ns()
        if self.to_console or self.file is not None:
            text = self._line(severity, name, message, function, file, line, stamp)
            if self.file is not None:
                self.file.write(text)
            if self.to_console:
                self._print(severity, text)
        if self.to_rosout:
            publisher = self.publishers.get(name)
            if publisher is not None:
                flaw = publisher.log(stamp, severity, name, message, file, function, line)
                if flaw is not None:
                    self._write_to_stderr(f"Failed to publish log message to rosout: {flaw}\n")

    def _write_to_stderr(self, text: str) -> None:
        write = self.write
        if write is None:
            if sys.stderr is None:
                return
            write = sys.stderr.write
        _write_or_not(write, text)

    def _line(self, severity: int, name: str, message: str, function: str, file: str, line: int, stamp: int) -> str:
        form = self._format
        if form is None:
            form = self._format = self._env.get("RCUTILS_CONSOLE_OUTPUT_FORMAT") or DEFAULT_FORMAT
        if form is DEFAULT_FORMAT:
            seconds, rest = divmod(stamp, 1_000_000_000)
            return f"[{NAMES[severity]}] [{seconds}.{rest:09}] [{name}]: {message}"
        from rclpy._day6.console_format import expand

        return expand(form, severity, name, message, function, file, line, stamp)

    def _print(self, severity: int, text: str) -> None:
        write, stream = self.write, None
        if write is None:
            stream = sys.stdout if self._env.get("RCUTILS_LOGGING_USE_STDOUT") == "1" else sys.stderr
            if stream is None:
                return
            write = stream.write
        if self._colours(stream if stream is not None else getattr(write, "__self__", None)):
            text = f"{_COLOURS[severity]}{text}{_RESET}"
        _write_or_not(write, f"{text}\n")

    def _colours(self, stream: Any) -> bool:
        wish = self._env.get("RCUTILS_COLORIZED_OUTPUT")
        if wish in ("0", "1"):
            return wish == "1"
        isatty = getattr(stream, "isatty", None)
        return isatty is not None and isatty() and self._env.get("TERM") != "dumb"


def _write_or_not(write: Callable[[str], object], text: str) -> None:
    """Write to the console, as rcutils does: a full disk or a closed pipe never ends the program."""
    try:
        write(text)
    except (OSError, ValueError):  # ValueError: the program has closed its sys.stderr
        return


PROCESS = LoggingSettings()
"""The settings of this process."""
