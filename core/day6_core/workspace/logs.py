"""The `log` folder: a subfolder for each call of colcon, `latest` pointing to the last one, and the files in them."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import IO

from day6_core.reason import reason_and_name
from day6_core.workspace.events import BuildEvent
from day6_core.workspace.files import BuildOutput
from day6_core.workspace.packages import IGNORE_MARKER, refuse_sources


def mark_ignored(output: BuildOutput, base: Path) -> None:
    """Write the marker into a base that keeps colcon from searching for packages there."""
    if not os.path.lexists(base / IGNORE_MARKER):
        output.write_text(base / IGNORE_MARKER, "")


class LogFolder:
    """`log/build_2026-11-21_14-32-05`, created when the first file is written to it. `base` may be os.devnull: no logs.

    `warn` is called once if the logs cannot be written.
    """

    def __init__(self, base: Path, verb: str, warn: Callable[[str], None]) -> None:
        self._base = base
        self._warn = warn
        self._warned = False
        self._verb = verb
        self._path: Path | None = None
        self._output = BuildOutput([base])

    @property
    def bases(self) -> list[Path]:
        """The folder of all logs as a list, empty without logs."""
        return [] if str(self._base) == os.devnull else [self._base]

    @property
    def path(self) -> Path | None:
        """The folder of this call, None without logs. Raises OSError if it cannot be created."""
        if self._path is None and str(self._base) != os.devnull:
            self._path = self._make()
        return self._path

    def _make(self) -> Path:
        refuse_sources(self._base)
        self._base.mkdir(parents=True, exist_ok=True)
        mark_ignored(self._output, self._base)
        stamp = f"{self._verb}_{time.strftime('%Y-%m-%d_%H-%M-%S')}"
        path = self._base / stamp
        number = 1
        while True:
            try:
                path.mkdir()
                break
            except FileExistsError:
                number += 1
                path = self._base / f"{stamp}_{number}"
        self._point(self._base / f"latest_{self._verb}", path.name)
        self._point(self._base / "latest", f"latest_{self._verb}")
        return path

    def _point(self, link: Path, target: str) -> None:
        # Windows lets only some users make links; the folders work without. Anything that isn't a link is not ours.
        with suppress(OSError, NotImplementedError):
            if link.is_symlink():
                self._output.remove(link)
            link.symlink_to(target, target_is_directory=True)

    def folder_of(self, job: str) -> Path | None:
        """Create and return the folder of one package, None without logs.

        Raises:
            OSError: it cannot be created, or the name leads outside the log folder.
        """
        if self.path is None:
            return None
        self._output.make_folder(self.path / job)
        return self.path / job

    def give_up(self, error: OSError) -> None:
        """Warn, the first time, that the logs of this run are incomplete."""
        if not self._warned:
            self._warned = True
            self._warn(f"the log cannot be written: {reason_and_name(error)}")

    def write(self, name: str, text: str) -> None:
        """Append to a file of the folder."""
        if self.path is not None:
            with open(self.path / name, "a", encoding="utf-8", errors="surrogateescape") as file:
                file.write(text)


class _Logging:
    """A handler that writes files.

    If it cannot (a full disk), it warns once and gives up: a build must not fail because of its log.
    """

    def __init__(self, folder: LogFolder) -> None:
        self._folder = folder
        self._given_up = False

    def handle(self, event: BuildEvent) -> None:
        if self._given_up:
            return
        try:
            self._log(event)
        except OSError as error:
            self._given_up = True
            self._folder.give_up(error)

    def _log(self, event: BuildEvent) -> None:
        raise NotImplementedError


class EventLog(_Logging):
    """`events.log`: every event with its time."""

    def __init__(self, folder: LogFolder) -> None:
        super().__init__(folder)
        self._began = time.monotonic()
        self._file: IO[str] | None = None

    def _log(self, event: BuildEvent) -> None:
        if self._file is None:
            if self._folder.path is None or event.kind == "end":
                return
            self._file = open(self._folder.path / "events.log", "w", encoding="utf-8", buffering=1)  # noqa: SIM115 (closed at the end)
        if event.kind != "tick":
            what = f"{event.text!r}" if event.text else f"{event.result!r}" if event.kind.endswith("ended") else ""
            line = f"[{time.monotonic() - self._began:.6f}] ({event.job or '-'}) {event.kind}: {what}".rstrip()
            self._file.write(f"{line}\n")
        if event.kind == "end":
            self._file.close()
            self._file = None


_FILES = {
    "command": ("command.log", "streams.log"),
    "command_ended": ("command.log", "streams.log"),
    "stdout": ("stdout.log", "stdout_stderr.log", "streams.log"),
    "stderr": ("stderr.log", "stdout_stderr.log", "streams.log"),
}
_ALL_FILES = ("command.log", "stderr.log", "stdout.log", "stdout_stderr.log", "streams.log")


class JobLogs(_Logging):
    """A folder for each package with its commands and its output."""

    def __init__(self, folder: LogFolder) -> None:
        super().__init__(folder)
        self._began: dict[str, float] = {}
        self._files: dict[str, dict[str, IO[str]]] = {}

    def _log(self, event: BuildEvent) -> None:
        if event.kind == "started":
            self._began[event.job] = time.monotonic()
        elif event.kind == "ended":
            for file in self._files.pop(event.job, {}).values():
                file.close()
        elif event.kind in _FILES and (folder := self._folder.folder_of(event.job)) is not None:
            files = self._files.get(event.job) or self._open(folder, event.job)
            text = event.text
            for name in _FILES[event.kind]:
                stamp = f"[{time.monotonic() - self._began[event.job]:.3f}s] " if name == "streams.log" else ""
                files[name].write(stamp + text)
                files[name].flush()

    def _open(self, folder: Path, job: str) -> dict[str, IO[str]]:
        self._files[job] = {
            name: open(folder / name, "w", encoding="utf-8", errors="surrogateescape")  # noqa: SIM115 (closed at the end)
            for name in _ALL_FILES
        }
        return self._files[job]
