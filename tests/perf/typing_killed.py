"""Types into an editor without a pause, kills the desktop (SIGKILL) at a random moment, and looks what comes back. By hand.

    python -m tests.perf.typing_killed [--runs 200] [--jobs 1] [--seed 1] [--only N]

A run is good when the text that comes back is the beginning of what was typed, and nothing is missing that was typed longer than
KEEP_SECONDS before the kill (and the time that keys took to appear, and SLACK). Prints how much was missing, in seconds of
typing. The exit status is 1 if any run was not good.
"""

from __future__ import annotations

import re
import signal
import sys
import time
from statistics import median

from day6_core.shell.editing.model import Editor
from day6_tui.windows.editor.editor import KEEP_SECONDS
from tests.e2e.place import DAY6
from tests.e2e.terminal import Terminal
from tests.perf.random_runs import RandomRun, options_of, played

SLACK = 0.5
"""Seconds for the frame in which a copy is due, and for writing it."""


class TypingKilled(RandomRun):
    """Types a word a line, `w0`, `w1` …, for a random time."""

    missing = 0.0
    """How long before the kill the first word was typed that did not come back."""
    slowest = 0.0
    """How long a word took to appear at most."""

    def play(self) -> None:
        self.prepare({})
        env = {"DAY6_RUNTIME_DIR": str(self.runtime), "TMPDIR": str(self.temporary)}
        env["XDG_DATA_HOME"] = str(self.folder / "data")
        words = [*DAY6, "--scene", "empty", "--lang", "en", "--home", str(self.home)]
        with Terminal(words, 90, 24, cwd=self.folder, env=dict(env)) as screen:
            self.screen = screen
            screen.wait("$")
            screen.line("nano work.txt")
            screen.wait("work.txt", "^X close")
            sent, seen, killed = self._type(screen)
            self.kill()
            screen.status = -signal.SIGKILL
        self._compare(sent, seen, killed)
        self.look_for_leftovers()

    def _type(self, screen: Terminal) -> tuple[list[float], list[float], float]:
        """Type until the random moment; return when each word was sent, when it was seen, and that moment."""
        sent: list[float] = []
        seen: list[float] = []
        end = time.monotonic() + self.random.uniform(0.2, 9.0)
        while (now := time.monotonic()) < end:
            sent.append(now)
            screen.send(f"w{len(sent) - 1}\r")
            shown = [int(each) for each in re.findall(r"w(\d+)", screen.look(self.random.uniform(0.02, 0.3)))]
            for at in range(len(seen), max(shown, default=-1)):  # the last one may still be growing
                seen.append(time.monotonic())
                self.slowest = max(self.slowest, seen[at] - sent[at])
        return sent, seen, time.monotonic()

    def _compare(self, sent: list[float], seen: list[float], killed: float) -> None:
        editor = Editor(self.home, self.folder / "data" / "day6-tui" / "unsaved", "nano")
        editor.open(self.home / "work.txt")
        back = editor.text.split("\n")
        whole = [f"w{at}" for at in range(len(sent))]
        if "\n".join(whole)[: len(editor.text.rstrip("\n"))] != editor.text.rstrip("\n"):
            self.troubles.append(f"what comes back is not what was typed: {back[-3:]}")
        kept = len([word for word in back[:-1] if word])
        if kept < len(sent):
            self.missing = killed - sent[kept]
        self.note(
            f"{killed - sent[0]:.1f} s, {len(sent)} words typed, {len(seen)} seen, {kept} kept: {self.missing:.2f} s"
        )
        if self.missing > KEEP_SECONDS + SLACK + self.slowest:
            self.troubles.append(f"{self.missing:.2f} s are missing ({kept} words of {len(sent)})")


def main() -> int:
    """Play the runs and print what was missing; return the exit status."""
    options = options_of(__doc__, runs=200, jobs=1)
    missing, slowest, bad = [], 0.0, 0
    for run in played(TypingKilled, options):
        missing.append(run.missing)
        slowest = max(slowest, run.slowest)
        bad += bool(run.troubles)
        for trouble in run.troubles:
            print(f"run {run.number}: {trouble}", flush=True)
    print(
        f"{len(missing)} kills while typing: missing at most {max(missing):.2f} s, in the middle {median(missing):.2f} s;"
    )
    print(f"slowest key {slowest:.2f} s; {bad} not good")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
