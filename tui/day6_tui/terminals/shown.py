"""The desk's terminals on the screen: opened, shown, and removed when their shell has ended."""

from __future__ import annotations

import threading
import weakref
from functools import partial
from typing import TYPE_CHECKING

from day6_tui.actions import Handlers
from day6_tui.appearance.look import Look
from day6_tui.bars.notices import NOTICE_SECONDS, Notices
from day6_tui.machine import Machine
from day6_tui.panes.desktop import Desktop
from day6_tui.panes.pane import Pane
from day6_tui.terminals.held_keys import HeldKeys
from day6_tui.terminals.pane import TerminalPane
from day6_tui.terminals.view import tab_name

if TYPE_CHECKING:
    from pathlib import Path

    from day6_core.shell.terminal import Terminal


CUT_LINE = "\x05\x15"
"""Ctrl-E and Ctrl-U: the line editor cuts what was typed; Ctrl-Y brings it back."""


class Terminals:
    """Keeps one pane for each terminal of the desk, and carries out the user's actions on terminals."""

    def __init__(self, machine: Machine, desktop: Desktop, notices: Notices, look: Look) -> None:
        self._machine = machine
        self._desktop = desktop
        self._notices = notices
        self._look = look
        self.held = HeldKeys()
        self._known: weakref.WeakSet[Terminal] = weakref.WeakSet()
        """All terminals that were ever shown."""

    def actions(self) -> Handlers:
        return {
            "terminal": self.open_in_front,
            "split.right": lambda: self.open_in_front("right"),
            "split.below": lambda: self.open_in_front("below"),
            "copy": self.copy,
            "paste": self.paste,
            "find": self.find,
            "clear": self.forget_history,
        }

    @property
    def panes(self) -> list[TerminalPane]:
        return list(self._desktop.terminals())

    @property
    def current(self) -> TerminalPane | None:
        """The terminal that has the keyboard, or had it last."""
        used = [self._desktop.slots[slot] for slot in self._desktop.recent]
        return next((pane for pane in used if isinstance(pane, TerminalPane)), None)

    def first_pane(self) -> TerminalPane:
        """A pane for the first terminal, which comes later."""
        pane = TerminalPane(self._look, self.held)
        self._desktop.add(pane)
        return pane

    # -- opening and closing -------------------------------------------------------------------------------------------

    def open(
        self, *, beside: Pane | None = None, side: str = "", cwd: Path | None = None, text: str = ""
    ) -> TerminalPane | None:
        """Open a terminal and show it; a notice and None if too many programs are running."""
        desk = self._machine.desk
        if desk is None:
            return None
        empty = next((pane for pane in self.panes if not pane.has_terminal), None)
        columns, rows = empty.terminal_size() if empty is not None else (80, 24)
        try:
            terminal = desk.open_terminal(columns, rows, cwd=cwd, text=text)
        except BlockingIOError:
            self._notices.show(self._look.texts("terminal.no_room"), NOTICE_SECONDS)
            return None
        return self._show(terminal, empty, beside=beside, side=side)

    def _show(
        self, terminal: Terminal, pane: TerminalPane | None = None, *, beside: Pane | None = None, side: str = ""
    ) -> TerminalPane:
        self._known.add(terminal)
        if pane is None:
            pane = TerminalPane(self._look, self.held)
            self._desktop.add(pane, beside=beside, side=side, takes_focus=True)
        pane.show(terminal)
        return pane

    def open_in_front(self, side: str = "") -> None:
        """Open a terminal that has the keyboard, at a `side` of the focused pane or where there is most room."""
        beside = self._desktop.focused_pane if side else None
        pane = self.open(beside=beside, side=side)
        if pane is not None:
            self._desktop.enlarged = False
            self._desktop.go_to_pane(pane)

    def close(self, pane: TerminalPane) -> None:
        """Close a terminal; ask first if something runs in it."""
        if not pane.has_terminal or not pane.view.terminal.running:
            self.end(pane)
            return
        from day6_tui.overlays.question import Answer, Question

        texts = self._look.texts
        what = texts("list.comma").join(map(tab_name, pane.view.terminal.running))
        end = Answer("y", texts("quit.end"), partial(self.end, pane))
        title, text = texts("terminal.close.title"), texts("terminal.close.ask", what=what)
        self._desktop.open_overlay(Question(self._look, title, text, [end]), about=pane)

    def end(self, pane: TerminalPane) -> None:
        """Close a terminal, and end what runs in it."""
        if pane.has_terminal:
            self._end_behind(pane.view.terminal)
        self._desktop.drop(pane)
        self._keep_one()

    @staticmethod
    def _end_behind(terminal: Terminal) -> None:
        # Ending what it runs may take seconds; the desktop does not wait for that.
        threading.Thread(target=terminal.close, name="day6-close-terminal", daemon=True).start()

    def _keep_one(self) -> None:
        if not self.panes and self._desktop.app.is_running:
            pane = self.open()
            if pane is not None and self._desktop.focused_pane is pane:
                self._desktop.focus_pane(pane)

    def run(self, command: str) -> None:
        """Run a command in a terminal that waits for one."""
        if (pane := self.use_idle()) is not None:
            pane.view.terminal.run_line(command)
            self._desktop.focus_pane(pane)

    def type(self, text: str) -> None:
        """Type a text into a terminal that waits for a command, without Return; what was typed there before is cut."""
        if (pane := self.use_idle()) is not None:
            terminal = pane.view.terminal
            terminal.send(text if terminal.idle else f"{CUT_LINE}{text}")
            self._desktop.focus_pane(pane)

    def use_idle(self) -> TerminalPane | None:
        """A terminal that waits for a command, brought to the front; a new one if there is none."""
        used = sorted(self.panes, key=lambda pane: self._desktop.recent.index(pane.slot))
        for pane in used:
            if (
                pane.has_terminal and not pane.view.terminal.busy
            ):  # its shell may still be starting: `at_prompt` says when it waits
                self._desktop.bring_to_front(pane)
                return pane
        return self.open()

    # -- text ----------------------------------------------------------------------------------------------------------

    def copy(self) -> None:
        if self.current is not None and self.current.copy_selection():
            self._notices.show(self._look.texts("terminal.copied"))

    def paste(self) -> None:
        if self.current is not None:
            self.current.paste(self._desktop.app.clipboard)

    def find(self) -> None:
        """Search the terminal used last."""
        from day6_tui.terminals.find import Find

        if (pane := self.current) is not None and pane.has_terminal:
            self._desktop.focus_pane(pane)
            self._desktop.open_overlay(Find(self._look, pane), about=pane)

    def forget_history(self) -> None:
        if self.current is not None:
            self.current.forget_history()

    # -- frames --------------------------------------------------------------------------------------------------------

    @property
    def in_flood(self) -> bool:
        """Whether any program prints more than frames can show."""
        return any(pane.in_flood for pane in self._desktop.terminals())

    def read_flood(self) -> float | None:
        """Between frames: read what programs print without end; the seconds until the next turn, None without a flood."""
        shown = self._desktop.plan_now().places
        flooded = [pane for pane in self._desktop.terminals() if pane.in_flood]
        turns = [pane.read_flood(shown=pane.slot in shown) for pane in flooded]
        return min((turn for turn in turns if turn is not None), default=None)

    def follow_desk(self) -> None:
        """Take away the terminals whose shell has ended, and show those that programs have opened (`xterm -e …`)."""
        for pane in self.panes:
            if pane.has_terminal and pane.view.terminal.closed:
                self.end(pane)
        for terminal in self._machine.terminals():
            if terminal not in self._known and not terminal.closed:
                here = self._desktop.focused_pane
                pane = self._show(terminal)
                if here is None or not here.keeps_focus:
                    self._desktop.focus_pane(pane)
