"""What was on the desktop when it was left, and how it comes back: terminals with folders, workspaces and texts, and the layout.

The programs that ran are offered to be started again; their windows then find their old places.
"""

from __future__ import annotations

import json
import logging
import os
import shlex
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.places import SESSION_FILE
from day6_core.reason import reason
from day6_core.session.threads import Newest
from day6_core.whole_file import write_private
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.json_file import read_object
from day6_tui.panes.arranging import Arranging
from day6_tui.panes.layouts import VERSION, roles_in
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane

if TYPE_CHECKING:
    from day6_core.shell.language.jobs import Job
    from day6_core.shell.terminal import Terminal

_log = logging.getLogger(__name__)

LARGEST = 20_000_000
"""More bytes than a session can have."""

MOST_TERMINALS = 50

PREFIXES = "COLCON_PREFIX_PATH"
"""The variable with the workspaces that were sourced, the last one first."""

INTERRUPTED = 130
"""The status after Ctrl-C."""

WAITED = 60.0
"""Seconds for which windows of programs that were started again go to their old places."""


class Left(NamedTuple):
    """What a terminal was when the desktop was left."""

    folder: Path
    text: str
    commands: list[str]
    """What ran in it: commands in the background first, each with its `&`."""
    sourced: list[Path]
    """The install folders of the workspaces it knew, in the order in which they are to be sourced."""
    again: str = ""
    """A line that is typed in it again, without a question."""


@dataclass
class Returning:
    """A terminal that comes back."""

    pane: TerminalPane
    left: Left
    to_type: list[str] = field(default_factory=list)
    """Commands that are to be started again as soon as its workspaces are sourced."""
    is_sourced: bool = False
    lines_before: int = 0
    """How many lines had been run in it when they were started."""
    jobs: list[Job] = field(default_factory=list)
    """Those in the background: the shell forgets them when they have ended."""

    def type(self, home: Path) -> bool:
        """Type what is due, once the prompt waits; return whether nothing is left."""
        if not self.pane.has_terminal or self.pane.view.terminal.closed:
            return True
        terminal = self.pane.view.terminal
        if not self.is_sourced:
            if not self.pane.view.at_prompt:
                return False
            self.is_sourced = True
            known = terminal.shell.environment.get(PREFIXES, "").split(os.pathsep)  # some have it in their .bashrc
            for install in self.left.sourced:
                if str(install) not in known and (install / "setup.bash").is_file():
                    terminal.run_line(_source(install, terminal.shell.cwd, home))
        if self.to_type:
            self.lines_before = terminal.runs.count
            for command in self.to_type:
                terminal.run_line(command)
            self.to_type = []
        return True

    def has_failed(self) -> bool:
        """Whether a command that was started again has ended with an error."""
        if not self.pane.has_terminal:
            return False
        terminal = self.pane.view.terminal
        self.jobs += [job for job in list(terminal.shell.jobs.jobs) if job not in self.jobs]
        runs = [run for run in terminal.runs.all if run.number > self.lines_before]
        ended = [run.status for run in runs if run.source.strip() in self.left.commands]
        ended += [job.status for job in self.jobs if job.finished]
        return any(status not in (None, 0, INTERRUPTED) for status in ended)


class SavedDesktop(Feature):
    """Saves the desktop when it is left, and brings it back."""

    def __init__(self, parts: Parts, arranging: Arranging) -> None:
        super().__init__(parts)
        self._arranging = arranging
        self._layout: object = None
        """The layout that windows of programs that were started again come into, and until when."""
        self._until = 0.0
        self._returning: list[Returning] = []
        """The terminals in which something is still to be typed."""
        self._started: list[Returning] = []
        """Those in which programs were started again."""
        self._failed: list[TerminalPane] = []
        """Those of them in which one did not start."""
        self._views: dict[str, str] = {}
        """What the windows showed that have not come back yet, by their roles in the layout."""
        self._state: object = None
        """What there was when it was saved last."""
        self._unwritten = ""
        """Why it could not be saved the last time; '' if it was."""
        self._told = ""
        """What of that the user has been told."""
        self.in_lesson = False
        """Whether somebody was in the middle of a lesson; known once it was restored."""
        self._again: tuple[Terminal, str] | None = None
        """A terminal, and the line that is to be typed in it again."""
        self._foreign = False
        """The file is not one of ours: it is left as it is."""
        self._newest = Newest()

    # -- leaving -------------------------------------------------------------------------------------------------------

    def save(self) -> str:
        """Write down what is there; return why that was impossible, or ''. A disk that is full is no reason to stay."""
        path, data = self._machine.own_file(SESSION_FILE), self._taken()
        if path is not None and data is not None:
            self._newest.of(partial(self._write, path, data))()
        return self._unwritten

    def type_again(self, terminal: Terminal, line: str) -> None:
        """Have a line typed again in a terminal that comes back: the desktop starts again because of it."""
        self._again = terminal, line

    def save_meanwhile(self) -> None:
        """Write down what is there while the desktop goes on, if something has changed: after a crash that is what comes back."""
        terminals = [(pane.slot, pane.view.terminal.version) for pane in self._terminals.panes if pane.has_terminal]
        focused = self._desktop.focused_pane
        state = terminals, self._arranging.described(), self._views_now(), focused.slot if focused is not None else ""
        path = self._machine.own_file(SESSION_FILE)
        if path is None or (state == self._state and not self._unwritten):
            return
        if self._unwritten != self._told:
            self._told = self._unwritten
            if self._told:
                self._notices.show(self._look.texts("session.not_kept", reason=self._told), NOTICE_SECONDS)
        self._state = state
        if (data := self._taken()) is not None:
            write = self._newest.of(partial(self._write, path, data))
            threading.Thread(target=write, name="day6-save-session", daemon=True).start()

    def _write(self, path: Path, data: bytes) -> None:
        try:
            write_private(path, data)
        except OSError as error:
            _log.warning("the session could not be saved: %s", error)
            self._unwritten = reason(error)
        else:
            self._unwritten = ""

    def _taken(self) -> bytes | None:
        """What is there, as the file has it; None if there is nothing to write."""
        panes = [pane for pane in self._terminals.panes if pane.has_terminal]
        if not panes or self._foreign:
            return None
        from day6_core.shell.screen.transcript import transcript

        terminals = []
        for pane in panes:
            terminal = pane.view.terminal
            if terminal.closed:
                continue
            text = transcript(terminal.screen, without_last=not terminal.busy)
            prefixes = terminal.shell.environment.get(PREFIXES, "").split(os.pathsep)
            sourced = [prefix for prefix in reversed(prefixes) if prefix]
            found_there = {"folder": str(terminal.shell.cwd), "text": text, "commands": _commands(terminal)}
            again = {"again": self._again[1]} if self._again is not None and self._again[0] is terminal else {}
            terminals.append({**found_there, "sourced": sourced, **again})
        focused, roles = self._desktop.focused_pane, self._arranging.roles()
        found = {
            "version": VERSION,
            "time": time.time(),
            "layout": self._arranging.described(),
            "terminals": terminals,
            "focus": roles.get(focused.slot, "") if focused is not None else "",
            "views": {roles[slot]: view for slot, view in self._views_now().items()},
        }
        return json.dumps(found, ensure_ascii=False).encode(errors="replace")

    def _views_now(self) -> dict[int, str]:
        """What the windows show, by their slots, without those that have nothing to keep or fail to say it."""
        views = {}
        for pane in self._desktop.panes.values():
            try:
                view = pane.kept_view()
            except Exception:
                _log.exception("%s cannot say what it shows", pane.label)
            else:
                views.update({pane.slot: view} if view else {})
        return views

    # -- coming back ---------------------------------------------------------------------------------------------------

    def restore(self) -> bool:
        """Open the terminals of the last session, if there was more than one idle terminal, and offer to start its programs.

        A file that cannot be understood is told, and left as it is.
        """
        path = self._machine.own_file(SESSION_FILE)
        if path is None or not path.exists():
            return False
        try:
            found = _read(path)
            left = [_left(each) for each in found["terminals"]]
            views = _views(found.get("views", {}))
            roles_in(found["layout"])
        except (OSError, ValueError, KeyError, TypeError) as error:
            self._foreign = not isinstance(error, OSError)
            reason = error.strerror if isinstance(error, OSError) else self._look.texts("session.foreign")
            self._notices.show(self._look.texts("layout.unreadable", file=SESSION_FILE, reason=reason), NOTICE_SECONDS)
            return False
        if len(left) < 2 and not any(each.commands or each.again for each in left):
            return False
        when = time.strftime("%Y-%m-%d %H:%M", time.localtime(found["time"]))
        for each in left[:MOST_TERMINALS]:
            mark = f"\n\x1b[2m[{self._look.texts('session.restored', when=when)}]\x1b[0m" if each.text else ""
            pane = self._terminals.open(cwd=each.folder if each.folder.is_dir() else None, text=each.text + mark)
            if pane is not None:
                self._returning.append(Returning(pane, each, [each.again] if each.again else []))
        self._layout, self._views = found["layout"], views
        self._arranging.apply(self._layout)
        self._focus(str(found.get("focus", "")))
        self.in_lesson = "lesson 1" in views
        self._until = time.monotonic() + WAITED
        self._offer([each for each in self._returning if each.left.commands])
        return True

    def _focus(self, role: str) -> None:
        slot = next((slot for slot, each in self._arranging.roles().items() if each == role), None)
        pane = self._desktop.slots[slot] if slot is not None else self._terminals.current
        if pane is not None:
            self._desktop.focus_pane(pane)

    def _offer(self, stopped: list[Returning]) -> None:
        if not stopped:
            return
        from day6_tui.overlays.question import Answer, Question

        texts = self._look.texts
        names = "\n".join(command for each in stopped for command in each.left.commands)

        def start() -> None:
            self._until = time.monotonic() + WAITED
            for each in stopped:
                each.to_type += each.left.commands
            self._started = stopped
            self._returning += [each for each in stopped if each not in self._returning]
            self._look.wake()

        again = Answer("y", texts("session.start"), start)
        self._desktop.open_overlay(
            Question(
                self._look,
                texts("session.title"),
                texts("session.ask", what=names),
                [again],
                back=texts("session.back"),
            )
        )

    def advance(self) -> bool:
        """At every frame: type what is due in the terminals that come back, and show where something failed; True to go on."""
        desk = self._machine.desk
        if desk is not None and self._returning:
            self._returning = [each for each in self._returning if not each.type(desk.home)]
        if self._started and time.monotonic() >= self._until:
            self._started = []
        for each in [each for each in self._started if each.has_failed()]:
            self._started.remove(each)
            self._failed.append(each.pane)
            self._show(each.pane)
        return bool(self._returning)

    def _show(self, pane: TerminalPane) -> None:
        """Bring a terminal in front, with the keyboard if it would cover the pane that has it."""
        desktop = self._desktop
        if not desktop.holds(pane) or desktop.is_shown(pane):
            return
        here = desktop.focused_pane
        if here is not None and here.slot in desktop.split_tree.stack_of(pane.slot).keys:
            desktop.focus_pane(pane)
        else:
            desktop.bring_to_front(pane)

    def place_windows(self) -> None:
        """A window was opened: if it belongs to the layout that was left, it goes to its old place and shows what it showed."""
        if self._layout is None or time.monotonic() >= self._until:
            return
        self._arranging.apply(self._layout)
        for terminal in self._failed:
            self._show(terminal)
        roles = self._arranging.roles()
        for pane in self._desktop.panes.values():
            if view := self._views.pop(roles[pane.slot], ""):
                try:
                    pane.take_view(view)
                except ValueError as error:
                    _log.warning("%s: its view cannot be understood: %s", roles[pane.slot], error)


def _source(install: Path, folder: Path, home: Path) -> str:
    """The command that sources a workspace, as one types it in a folder."""
    script = install / "setup.bash"
    if install.parent == folder:
        return f"source {shlex.quote(str(script.relative_to(folder)))}"
    if script.is_relative_to(home):
        return f"source ~/{shlex.quote(str(script.relative_to(home)))}"
    return f"source {shlex.quote(str(script))}"


def _commands(terminal: Terminal) -> list[str]:
    jobs = [f"{job.source.rstrip(' &')} &" for job in terminal.shell.jobs.jobs if not job.finished]
    front = terminal.shell.front
    return [*jobs, *([front.source] if front is not None else [])]


def _read(path: Path) -> Mapping[str, Any]:
    found = read_object(path, LARGEST)
    if found.get("version") != VERSION or not isinstance(found.get("time"), float):
        raise ValueError("no session")
    return found


def _views(found: object) -> dict[str, str]:
    if not isinstance(found, dict) or not all(isinstance(each, str) for pair in found.items() for each in pair):
        raise ValueError("no session")
    return dict(found)


def _left(found: Mapping[str, Any]) -> Left:
    folder, text, commands = found["folder"], found["text"], found["commands"]
    sourced, again = found.get("sourced", []), found.get("again", "")
    strings = [folder, text, again, *commands, *sourced]
    if not isinstance(commands, list) or not isinstance(sourced, list) or not all(isinstance(s, str) for s in strings):
        raise ValueError("no session")
    printable = [["".join(filter(str.isprintable, each)) for each in lines] for lines in (commands, sourced, [again])]
    return Left(Path(folder), text, printable[0], [Path(each) for each in printable[1]], printable[2][0])
