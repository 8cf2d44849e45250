"""The desk's terminals on the screen: opened, shown, and removed when their shell has ended."""

from __future__ import annotations

import threading

from day6_tui.tui.actions import Handlers
from day6_tui.tui.desktop import Desktop
from day6_tui.tui.look import Look
from day6_tui.tui.machine import Machine
from day6_tui.tui.notices import Notices
from day6_tui.tui.terminal_view import TerminalView


class Terminals:
    """Keeps the terminal pane in step with the desk, and carries out the user's actions on terminals."""

    def __init__(self, machine: Machine, desktop: Desktop, notices: Notices, look: Look) -> None:
        self._machine = machine
        self._desktop = desktop
        self._pane = desktop.terminals
        self._notices = notices
        self._look = look

    def actions(self) -> Handlers:
        return {
            "terminal": self.open_in_front,
            "copy": self.copy,
            "paste": lambda: self._pane.paste(self._pane.app.clipboard),
            "clear": self.forget_history,
        }

    def open(self) -> None:
        """Open a terminal and show it, or a notice if too many programs are running."""
        if self._machine.desk is not None:
            columns, rows = self._pane.terminal_size()
            try:
                self._pane.add(self._machine.desk.open_terminal(columns, rows))
            except BlockingIOError:
                self._notices.show(self._look.texts("terminal.no_room"), 10.0)

    def open_in_front(self) -> None:
        """Open a terminal that has the keyboard."""
        self.open()
        self._desktop.focus_pane(self._pane)

    def go_to(self, index: int) -> None:
        """Show the terminal with this index and give it the keyboard."""
        if index < len(self._pane.views):
            self._pane.activate(index)
            self._desktop.focus_pane(self._pane)

    def use_idle(self) -> TerminalView:
        """Show a terminal that waits for a command, a new one if there is none."""
        for index, view in enumerate(self._pane.views):
            if not view.terminal.busy:  # its shell may still be starting: `at_prompt` says when it waits
                self._pane.activate(index)
                return view
        self.open()
        return self._pane.views[-1]

    def copy(self) -> None:
        if self._pane.copy_selection():
            self._notices.show(self._look.texts("terminal.copied"))

    def forget_history(self) -> None:
        if self._pane.view is not None:
            self._pane.view.forget_history()
            self._pane.touch()

    # -- what happened on the desk -------------------------------------------------------------------------------------

    def follow_desk(self) -> None:
        """Take away the terminals whose shell has ended, and show those that programs have opened (`xterm -e …`)."""
        self._bury_ended()
        for terminal in self._machine.terminals():
            if terminal not in self._pane.known:
                self._pane.add(terminal)
                self._desktop.focus_pane(self._pane)

    def _bury_ended(self) -> None:
        for view in [view for view in self._pane.views if view.terminal.closed]:
            self._pane.forget(view)
            # Ending what it still runs may take seconds; the desktop does not wait for that.
            threading.Thread(target=view.terminal.close, name="day6-close-terminal", daemon=True).start()
        if not self._pane.views and self._pane.app.is_running:
            self.open()
