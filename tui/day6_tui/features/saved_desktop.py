"""What was on the desktop when it was left, and how it comes back: terminals with their folders and texts, and the layout.

The programs that ran are offered to be started again; their windows then find their old places.
"""

from __future__ import annotations

import json
import logging
import threading
import time
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.whole_file import write_private
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.json_file import read_object
from day6_tui.panes.arranging import Arranging
from day6_tui.panes.layouts import VERSION, roles_in
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane

if TYPE_CHECKING:
    from day6_core.shell.terminal import Terminal

_log = logging.getLogger(__name__)

FILE = "session.json"

LARGEST = 20_000_000
"""More bytes than a session can have."""

MOST_TERMINALS = 50

WAITED = 60.0
"""Seconds for which windows of programs that were started again go to their old places."""


class Left(NamedTuple):
    """What a terminal was when the desktop was left."""

    folder: Path
    text: str
    commands: list[str]
    """What ran in it: commands in the background first, each with its `&`."""


class SavedDesktop(Feature):
    """Saves the desktop when it is left, and brings it back."""

    def __init__(self, parts: Parts, arranging: Arranging) -> None:
        super().__init__(parts)
        self._arranging = arranging
        self._layout: object = None
        """The layout that windows of programs that were started again come into, and until when."""
        self._until = 0.0
        self._views: dict[str, str] = {}
        """What the windows showed that have not come back yet, by their roles in the layout."""
        self._state: object = None
        """What there was when it was saved last."""
        self.in_lesson = False
        """Whether somebody was in the middle of a lesson; known once it was restored."""
        self._foreign = False
        """The file is not one of ours: it is left as it is."""

    # -- leaving -------------------------------------------------------------------------------------------------------

    def save(self) -> None:
        """Write down what is there. A disk that is full is no reason to stay: the log says so."""
        path, data = self._machine.own_file(FILE), self._taken()
        if path is not None and data is not None:
            _write(path, data)

    def save_meanwhile(self) -> None:
        """Write down what is there while the desktop goes on, if something has changed: after a crash that is what comes back."""
        state = [(pane.slot, pane.view.terminal.version) for pane in self._terminals.panes if pane.has_terminal]
        path = self._machine.own_file(FILE)
        if path is None or state == self._state:
            return
        self._state = state
        if (data := self._taken()) is not None:
            threading.Thread(target=_write, args=(path, data), name="day6-save-session", daemon=True).start()

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
            terminals.append({"folder": str(terminal.shell.cwd), "text": text, "commands": _commands(terminal)})
        focused, roles = self._desktop.focused_pane, self._arranging.roles()
        found = {
            "version": VERSION,
            "time": time.time(),
            "layout": self._arranging.described(),
            "terminals": terminals,
            "focus": roles.get(focused.slot, "") if focused is not None else "",
            "views": {roles[pane.slot]: view for pane in self._desktop.panes.values() if (view := pane.kept_view())},
        }
        return json.dumps(found, ensure_ascii=False).encode(errors="replace")

    # -- coming back ---------------------------------------------------------------------------------------------------

    def restore(self) -> bool:
        """Open the terminals of the last session, if there was more than one idle terminal, and offer to start its programs.

        A file that cannot be understood is told, and left as it is.
        """
        path = self._machine.own_file(FILE)
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
            self._notices.show(self._look.texts("layout.unreadable", file=FILE, reason=reason), NOTICE_SECONDS)
            return False
        if len(left) < 2 and not any(each.commands for each in left):
            return False
        when = time.strftime("%Y-%m-%d %H:%M", time.localtime(found["time"]))
        panes = []
        for each in left[:MOST_TERMINALS]:
            mark = f"\n\x1b[2m[{self._look.texts('session.restored', when=when)}]\x1b[0m" if each.text else ""
            pane = self._terminals.open(cwd=each.folder if each.folder.is_dir() else None, text=each.text + mark)
            if pane is not None:
                panes.append((pane, each.commands))
        self._layout, self._views = found["layout"], views
        self._arranging.apply(self._layout)
        self._focus(str(found.get("focus", "")))
        self.in_lesson = "lesson 1" in views
        self._until = time.monotonic() + WAITED
        self._offer([(pane, commands) for pane, commands in panes if commands])
        return True

    def _focus(self, role: str) -> None:
        slot = next((slot for slot, each in self._arranging.roles().items() if each == role), None)
        pane = self._desktop.slots[slot] if slot is not None else self._terminals.current
        if pane is not None:
            self._desktop.focus_pane(pane)

    def _offer(self, stopped: list[tuple[TerminalPane, list[str]]]) -> None:
        if not stopped:
            return
        from day6_tui.overlays.question import Answer, Question

        texts = self._look.texts
        names = "\n".join(command for _, commands in stopped for command in commands)

        def start() -> None:
            self._until = time.monotonic() + WAITED
            for pane, commands in stopped:
                if pane.has_terminal:
                    for command in commands:
                        pane.view.terminal.run_line(command)

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

    def place_windows(self) -> None:
        """A window was opened: if it belongs to the layout that was left, it goes to its old place and shows what it showed."""
        if self._layout is None or time.monotonic() >= self._until:
            return
        self._arranging.apply(self._layout)
        roles = self._arranging.roles()
        for pane in self._desktop.panes.values():
            if view := self._views.pop(roles[pane.slot], ""):
                try:
                    pane.take_view(view)
                except ValueError as error:
                    _log.warning("%s: its view cannot be understood: %s", roles[pane.slot], error)


def _write(path: Path, data: bytes) -> None:
    try:
        write_private(path, data)
    except OSError as error:
        _log.warning("the session could not be saved: %s", error)


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
    if not isinstance(folder, str) or not isinstance(text, str) or not all(isinstance(each, str) for each in commands):
        raise ValueError("no session")
    return Left(Path(folder), text, ["".join(filter(str.isprintable, each)) for each in commands])
