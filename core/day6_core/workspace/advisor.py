"""Below everything colcon prints, on a terminal: a hint for each package that failed, where its fault is certain."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path

from day6_core.workspace.events import INTERRUPTED, BuildEvent, Console


class Advisor:
    """Collects what failed packages wrote to standard error. It is not one of colcon's own handlers."""

    def __init__(self, console: Console, variables: Mapping[str, str], cwd: Path) -> None:
        self._console = console
        self._variables, self._cwd = variables, cwd
        self._lines: dict[str, list[str]] = defaultdict(list)
        self._failed: list[str] = []
        self._jobs = 0
        self._printed: list[str] = []
        """What setup.py files wrote past colcon."""

    def print_error(self, text: str) -> None:
        """Print what a setup.py wrote to standard error: it appears at once, and belongs to no package's output."""
        self._printed.append(text)
        self._console.err(text)

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if not self._console.stderr.isatty():
            return
        self._jobs += event.kind == "queued"
        if event.kind == "stderr":
            self._lines[event.job].append(event.text)
        elif event.kind == "ended" and event.result not in (0, INTERRUPTED):
            self._failed.append(event.job)

    def advise(self, *, building: bool) -> None:
        """Print the hints, when everything else has been printed."""
        if not self._console.stderr.isatty():
            return
        from day6_core.advice.below import first_line_below
        from day6_core.advice.rules import Surroundings, dimmed, hint_about_folder, hint_below

        around = Surroundings(self._variables, self._cwd)
        texts = [*self._printed, *("".join(self._lines[job]) for job in self._failed)] if self._failed else []
        hints = [hint_below(text, around) for text in texts]
        if not any(hints):
            hints = [next(filter(None, (first_line_below(text, around) for text in texts)), "")]
        if building:
            hints.append(hint_about_folder(self._jobs, around))
        for hint in dict.fromkeys(filter(None, hints)):
            self._console.err(f"{dimmed(hint)}\n")
