"""Performs the actions of a lesson on a machine, as somebody at the keyboard would: in terminals, files and windows."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.lessons.actions import presses
from day6_core.lessons.checks import condition_of
from day6_core.lessons.live import OutsideHome
from day6_core.lessons.player import LONGEST_WAIT, LOOK, Player, StageError
from day6_core.session.threads import in_thread
from day6_core.whole_file import replace_file

if TYPE_CHECKING:
    from day6_core.lessons.live import Live
    from day6_core.session.session import Session
    from day6_core.shell.terminal import Terminal

ENDS_WITHIN = 5.0
"""Seconds that a program may take to end after Ctrl-C."""

_EDITORS = re.compile(r"\s*(nano|pico|vi|vim|edit|code|ide)\b")
"""What is left open when a lesson is begun with a clear desk: text may not be saved."""

LINE_TAKES = 8.0
"""A line of a file is shown for the time of so many characters."""


class Stage(Player):
    """Performs actions on one machine; the terminals it opened are numbered from 1.

    Where it is seen (`steering`) files are written by typing them, too. That may be shown to a pupil, in whose home folder it
    happens: a file that is not this stage's own is copied before it is changed.
    """

    def __init__(self, live: Live, session: Session) -> None:
        super().__init__(session.sleep)
        self.spares = False
        """Whether `write` leaves files alone that are there."""
        self._live = live
        self._session = session
        self._terminals: list[Terminal] = []
        self._terminal: Terminal | None = None
        self._written: dict[Path, bytes] = {}
        """Files as they were left here."""

    @property
    def _here(self) -> Terminal:
        if self._terminal is None or self._terminal.closed:
            self._use("idle")
        assert self._terminal is not None
        return self._terminal

    def _use(self, which: str | int) -> None:
        if isinstance(which, int):
            if which > len(self._terminals):
                raise StageError(f"terminal {which} was not opened")
            self._terminal = self._terminals[which - 1]
            return
        idle = next(filter(self._is_free, self._live.terminals), None) if which == "idle" else None
        if idle is None:
            idle = self._live.desk.open_terminal()
        if idle not in self._terminals:
            self._terminals.append(idle)
        self._terminal = idle

    def _is_free(self, terminal: Terminal) -> bool:
        """Whether it waits for a command, or will as soon as its shell has started."""
        return terminal.idle or (terminal in self._terminals and not terminal.runs.count and not terminal.busy)

    async def _until(self, holds: Any, what: str) -> None:
        if not await self._session.until(holds, LONGEST_WAIT, LOOK):
            raise StageError(what)

    async def clear_up(self) -> None:
        """End what runs in the terminals as a person would: Ctrl-C, and `kill` for what runs in the background."""
        for terminal in self._live.terminals:
            if not any(_EDITORS.match(line) for line in terminal.running):
                if terminal.busy:
                    terminal.send("\x03")
                    await self._session.until(_is_idle(terminal), ENDS_WITHIN, LOOK)
                numbers = [job.number for job in terminal.shell.jobs.jobs if not job.finished and job.number]
                if terminal.idle and numbers:
                    terminal.run_line(f"kill {' '.join(f'%{number}' for number in numbers)}")

    # -- the actions ---------------------------------------------------------------------------------------------------

    async def _do_terminal(self, which: str | int | Mapping[str, str]) -> None:
        if isinstance(which, Mapping):
            self._terminal = self._busy_with(which["running"])
        else:
            self._use(which)

    def _busy_with(self, pattern: str) -> Terminal:
        for terminal in self._live.terminals:
            if any(re.search(pattern, " ".join(line.split())) for line in terminal.running):
                return terminal
        raise StageError(f"no terminal runs  {pattern}")

    async def _do_line(self, line: str) -> None:
        terminal = self._here
        await self._until_idle(terminal, line)
        before = terminal.runs.count
        await self._type(terminal.send, line)
        await self._until(
            lambda: terminal.runs.count != before or not terminal.idle, f"the terminal did not take  {line}"
        )

    async def _until_idle(self, terminal: Terminal, line: str) -> None:
        if not await self._session.until(_is_idle(terminal), LONGEST_WAIT, LOOK):
            runs = "; ".join(terminal.running) or "a program"
            raise StageError(f"'{line}' was not typed: the terminal was busy for {LONGEST_WAIT:g} s, it runs  {runs}")

    async def until_line_ends(self) -> None:
        """Wait for the end of the line that was typed last. Raises StageError."""
        terminal = self._here
        if not await self._session.until(_is_idle(terminal), LONGEST_WAIT, LOOK):
            line = "; ".join(terminal.running) or "a program"
            raise StageError(
                f"it ends with  {line}  which has not ended after {LONGEST_WAIT:g} s: wait for what it starts"
            )

    async def _type_file(self, name: str, text: str) -> None:
        """Write a file where everybody sees it: `cat > FILE << 'EOF'`."""
        end = "EOF"
        while end in text.split("\n"):
            end += "_"
        folder = name.rpartition("/")[0]
        await self._do_type(f"{f'mkdir -p {folder} && ' if folder not in ('', '~') else ''}cat > {name} << '{end}'")
        terminal = self._here
        for line in [*text.removesuffix("\n").split("\n"), end]:
            await self._while_held()
            terminal.send(line + "\r")
            await self._rest(LINE_TAKES)
        await self._until(lambda: terminal.idle, f"the terminal did not take {name}")

    async def _do_keys(self, keys: str) -> None:
        terminal = self._here
        for key in presses(keys):
            terminal.send(key)
            await self._session.sleep(LOOK)

    def _own(self, name: str) -> Path:
        """A file that may be changed: one of the home folder, not what a link leads to outside. Raises OutsideHome."""
        path = self._live.path(name)
        if self._live.home.resolve() not in path.resolve().parents:
            raise OutsideHome(name)
        return path

    async def _do_write(self, file: Mapping[str, str]) -> None:
        path = self._own(file["file"])
        if self.spares and path.exists():
            return
        await self._keep(file["file"], path)
        if self.steering.seen and _can_be_typed(file["text"]):
            await self._type_file(file["file"], file["text"])
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            await _replace(path, file["text"])
        self._written[path] = path.read_bytes()

    async def _keep(self, name: str, path: Path) -> None:
        """Copy somebody's file, where everybody sees it, before it is changed."""
        if not self.steering.seen or not path.exists() or self._written.get(path) == path.read_bytes():
            return
        kept = (f"{name}.mine{number or ''}" for number in count())
        copy = next(each for each in kept if not self._live.path(each).exists())
        await self._do_type(f"cp {name} {copy}")
        await self._until(lambda: self._here.idle, f"the terminal did not copy {name}")
        if not self._live.path(copy).is_file():
            raise StageError(f"{name} could not be copied, so it was left as it is")

    async def _do_replace(self, change: Mapping[str, str]) -> None:
        path = self._own(change["file"])
        if not path.is_file():
            raise StageError(f"there is no {change['file']}")
        text = path.read_text(encoding="utf-8")
        if text.count(change["old"]) != 1:
            raise StageError(f"{change['file']} has {change['old']!r} {text.count(change['old'])} times")
        await self._keep(change["file"], path)
        if self.steering.seen:
            for word, lines in (("-", change["old"]), ("+", change["new"])):
                for line in lines.strip("\n").split("\n"):
                    await self._do_type(f"# {change['file'].rpartition('/')[2]} {word} {line.strip()}")
        await _replace(path, text.replace(change["old"], change["new"]))
        self._written[path] = path.read_bytes()

    async def _do_wait(self, given: object) -> None:
        condition = condition_of(given)
        assert not isinstance(condition, str)
        await self._until(
            lambda: condition.judge(self._live).ok, f"waited in vain: {condition.judge(self._live).text('en')}"
        )

    async def _do_rviz(self, change: Mapping[str, str]) -> None:
        await self._until(lambda: self._live.windows("rviz2"), "RViz is not open")
        model: Any = self._live.windows("rviz2")[-1].model
        if "fixed_frame" in change:
            model.edit(model.fixed, change["fixed_frame"])
        if "add" in change:
            kind = change["add"]
            topic = "/robot_description" if kind == "RobotModel" else ""
            model.request(lambda: model.add_display(kind, topic))
        await self._session.sleep(LOOK)

    async def _do_close(self, kind: str) -> None:
        for window in self._live.windows(kind):
            window.close_by_user()

    async def _do_answer(self, letter: str) -> None:
        self._live.answer = letter


async def _replace(path: Path, text: str) -> None:
    """Write a file without waiting for the disk. Raises OSError."""
    await in_thread(lambda: replace_file(path, text.encode(), sync=False))


def _can_be_typed(text: str) -> bool:
    """Whether a terminal takes the text as it is: a tab would complete names."""
    return all(char == "\n" or char.isprintable() for char in text)


def _is_idle(terminal: Terminal) -> Callable[[], bool]:
    return lambda: terminal.idle
