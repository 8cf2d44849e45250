"""Moving between panes: the cycle of F3, the list of F4, and how much room the panes get."""

from __future__ import annotations

from functools import partial

from day6_tui.tui import actions
from day6_tui.tui.desktop import Desktop
from day6_tui.tui.look import Look
from day6_tui.tui.machine import Machine
from day6_tui.tui.notices import Notices
from day6_tui.tui.pane import Pane
from day6_tui.tui.terminal_view import tab_name
from day6_tui.tui.terminals import Terminals
from day6_tui.tui.windows import WindowPane

SHARE_STEP = 0.05
SMALLEST_SHARE, LARGEST_SHARE = 0.2, 0.8


class Switching:
    """Decides which pane is next; remembers where a cycle through the windows begins."""

    def __init__(self, desktop: Desktop, terminals: Terminals, machine: Machine, notices: Notices, look: Look) -> None:
        self._desktop = desktop
        self._pane = desktop.terminals
        self._terminals = terminals
        self._machine = machine
        self._notices = notices
        self._look = look
        self._front: int | None = None
        """The window in front when the keyboard was in a terminal last: a round of F3 through the windows begins there."""

    def actions(self) -> actions.Handlers:
        return {
            "next": lambda: self.cycle(1),
            "previous": lambda: self.cycle(-1),
            "windows": self.list_all,
            "inspector": self.toggle_inspector,
            "enlarge": self._desktop.toggle_enlarged,
            "grow": lambda: self._change_share(SHARE_STEP),
            "shrink": lambda: self._change_share(-SHARE_STEP),
            "close": self.close_focused,
        }

    # -- the round -----------------------------------------------------------------------------------------------------

    def cycle(self, step: int) -> None:
        """Through all terminals and then all windows, beginning with the one that is in front."""
        if self._desktop.focused_pane is self._pane:
            self._front = self._desktop.active
        target, index = self._stop(step)
        if target is self._pane and self._pane.views:
            self._pane.activate(index)
        self._desktop.focus_pane(target)

    def _stop(self, step: int) -> tuple[Pane, int]:
        """Where that leads: a pane, and which of the terminals if it is theirs."""
        stops: list[tuple[Pane, int]] = [(self._pane, index) for index in range(len(self._pane.views))]
        pane = self._desktop.focused_pane
        numbers = self._desktop.numbers
        front = self._desktop.active if pane is self._pane else self._front
        first = numbers.index(front) if front in numbers else 0
        windows = [self._desktop.pane(number) for number in numbers[first:] + numbers[:first]]
        stops += [(window, 0) for window in windows if window is not None]
        here = (pane, self._pane.active if pane is self._pane else 0)
        if here in stops:
            return stops[(stops.index(here) + step) % len(stops)]
        return stops[0] if stops else here

    def key_to_terminal(self, index: int | None = None) -> str:
        """The key that leads from here to a terminal, without an index to the one that is shown."""
        wanted = (self._pane, self._pane.active if index is None else index)
        keys = {1: actions.BY_ID["next"].label, -1: actions.BY_ID["previous"].label}
        return next((key for step, key in keys.items() if self._stop(step) == wanted), actions.BY_ID["windows"].label)

    def tell_where_arrows_drive(self) -> None:
        """An arrow key was pressed where it drives nothing: name the terminal in which it would, if there is one."""
        for index, view in enumerate(self._pane.views):
            if view.reading_keys and "teleop" in view.terminal.title:
                key = self.key_to_terminal(index)
                self._notices.show(self._look.texts("terminal.arrows", number=index + 1, key=key))
                return

    # -- lists and sizes -----------------------------------------------------------------------------------------------

    def list_all(self) -> None:
        """Offer all terminals and windows, to go to or to close."""
        from day6_tui.tui.menu import Entry, Menu

        texts, entries = self._look.texts, []
        for index, view in enumerate(self._pane.views):
            name = f"{index + 1} {tab_name(view.terminal.title)}"
            go = partial(self._terminals.go_to, index)
            entries.append(Entry(name, texts("menu.terminal"), go, view.terminal.hang_up))
        for pane in self._desktop.panes.values():
            go = partial(self._desktop.focus_pane, pane)
            entries.append(Entry(pane.label, texts("menu.window"), go, pane.close))
        self._desktop.open_overlay(Menu(self._look, "menu.windows", entries))

    def toggle_inspector(self) -> None:
        """Open the inspector, or close the one that is open."""
        for pane in self._desktop.panes.values():
            if pane.window.kind == "inspector":
                pane.window.close_by_user()
                return
        self._machine.run_tool("day6_inspector", "inspector")

    def _change_share(self, step: float) -> None:
        self._desktop.share = max(SMALLEST_SHARE, min(LARGEST_SHARE, self._desktop.share + step))
        self._desktop.rearrange()

    def close_focused(self) -> None:
        """Close the window or the terminal that has the keyboard."""
        pane = self._desktop.focused_pane
        if pane is self._pane:
            if self._pane.view is not None:
                self._pane.view.terminal.hang_up()
        elif isinstance(pane, WindowPane):
            pane.close()
