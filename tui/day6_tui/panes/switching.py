"""Moving between panes and moving panes: the round of F3, Alt with arrows and numbers, the list of F4, borders."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from day6_tui import actions
from day6_tui.panes.pane import Pane
from day6_tui.panes.splits import SIDES, Extent
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane
from day6_tui.terminals.teleop_keys import keys_of
from day6_tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.overlays.menu import MenuEntry

STEP = Extent(4, 2)
"""Columns and rows a border moves at a key press."""

DIRECTIONS = SIDES[:4]


class Switching(Feature):
    """Decides which pane is next, and where panes go."""

    def __init__(self, parts: Parts) -> None:
        super().__init__(parts)

    def actions(self) -> actions.Handlers:
        handlers: dict[str, Callable[[], object]] = {
            "next": lambda: self.cycle(1),
            "previous": lambda: self.cycle(-1),
            "windows": self.list_all,
            "inspector": self.toggle_inspector,
            "kitchen": self.toggle_kitchen,
            "stack": self.stack_or_spread,
            "close": self.close_focused,
        }
        for side in DIRECTIONS:
            handlers[f"move.{side}"] = partial(self.move, side)
        return handlers

    # -- the round -----------------------------------------------------------------------------------------------------

    def cycle(self, step: int) -> None:
        """Through all panes, as they stand on the screen, with the tabs of each place."""
        target = self._stop(step)
        if target is not None:
            self._desktop.go_to_pane(target)

    def _stop(self, step: int) -> Pane | None:
        keys = self._desktop.split_tree.keys
        pane = self._desktop.focused_pane
        if pane is None or pane.slot not in keys:
            return self._desktop.slots[keys[0]] if keys else None
        return self._desktop.slots[keys[(keys.index(pane.slot) + step) % len(keys)]]

    def key_to(self, pane: Pane) -> str:
        """The key that leads from here to a pane."""
        keys = {1: actions.BY_ID["next"].label, -1: actions.BY_ID["previous"].label}
        found = next((key for step, key in keys.items() if self._stop(step) is pane), "")
        if not found and 1 <= pane.slot <= 9:
            found = self._look.hint(f"Alt+{pane.slot}")
        return found or actions.BY_ID["windows"].label

    def go_to(self, number: int) -> None:
        """Give the pane with this number the keyboard."""
        if (pane := self._desktop.slots.get(number)) is not None:
            self._desktop.go_to_pane(pane)

    def focus_beside(self, side: str) -> None:
        """Give the pane on this side the keyboard."""
        if (pane := self._beside(side)) is not None:
            self._desktop.go_to_pane(pane)

    def _beside(self, side: str) -> Pane | None:
        desktop, pane = self._desktop, self._desktop.focused_pane
        if pane is None or desktop.enlarged:
            return None
        slot = desktop.plan_now().neighbour(pane.slot, side, desktop.recent)
        return desktop.slots[slot] if slot is not None else None

    def tell_where_arrows_drive(self) -> None:
        """An arrow key was pressed where it drives nothing: name the keys that do, and the terminal in which, if there is one."""
        texts, here = self._look.texts, self._desktop.focused_pane
        if isinstance(here, TerminalPane) and here.has_terminal and here.view.reading_keys:
            self._notices.show(texts("terminal.not_arrows", keys=keys_of(here.view.terminal.title, texts)))
            return
        for pane in self._terminals.panes:
            if pane.drives:
                keys, key = keys_of(pane.view.terminal.title, texts), self.key_to(pane)
                self._notices.show(texts("terminal.arrows", keys=keys, number=pane.slot, key=key))
                return

    # -- moving panes --------------------------------------------------------------------------------------------------

    def move(self, side: str) -> None:
        """Let the focused pane and the one on this side change places."""
        pane, other = self._desktop.focused_pane, self._beside(side)
        if pane is not None and other is not None:
            self._desktop.split_tree.swap(pane.slot, other.slot)
            self._desktop.go_to_pane(pane)

    def resize(self, side: str) -> None:
        """Move the border of the focused pane that lies in this direction, or else the one behind it, that way."""
        desktop, pane = self._desktop, self._desktop.focused_pane
        found = desktop.plan_now()
        place = found.places.get(pane.slot) if pane is not None else None
        if place is None:
            return
        across = side in ("left", "right")
        low, high = (place.x, place.right) if across else (place.y, place.bottom)
        crossing = (place.y, place.bottom) if across else (place.x, place.right)
        step = (STEP.columns if across else STEP.rows) * (1 if side in ("right", "below") else -1)
        beside = [
            border
            for border in found.borders
            if border.split.across == across
            and border.at in (low, high)
            and border.first < crossing[1]
            and border.end > crossing[0]
        ]
        # The border at the right or the bottom, if there is one: it goes where the arrow points.
        if beside:
            border = max(beside, key=lambda each: each.at)
            desktop.split_tree.drag(border, border.at + step)
            desktop.rearrange()

    def stack_or_spread(self) -> None:
        """Put the focused pane behind its neighbour as a tab, or, if it is one of several tabs, beside them."""
        desktop, pane = self._desktop, self._desktop.focused_pane
        if pane is None or not desktop.holds(pane):
            return
        stack = desktop.split_tree.stack_of(pane.slot)
        place = desktop.plan_now().places.get(pane.slot)
        if len(stack.keys) > 1 and place is not None:
            other = next(key for key in stack.keys if key != pane.slot)
            desktop.split_tree.move(pane.slot, other, "right" if place.width >= 2 * place.height else "below")
        else:
            beside = next((found for side in DIRECTIONS if (found := self._beside(side)) is not None), None)
            if beside is None:
                return
            desktop.split_tree.move(pane.slot, beside.slot, "tab")
        desktop.go_to_pane(pane)

    # -- lists ---------------------------------------------------------------------------------------------------------

    def list_all(self) -> None:
        """Offer all windows and terminals, to go to or to close."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        texts = self._look.texts
        windows: list[MenuEntry] = []
        terminals: list[MenuEntry] = []
        for slot, pane in sorted(self._desktop.slots.items()):
            if pane is self._desktop.welcome:
                continue
            kind, found = ("menu.terminal", terminals) if isinstance(pane, TerminalPane) else ("menu.window", windows)
            found.append(
                MenuEntry(f"{slot} {pane.label}", texts(kind), partial(self._desktop.focus_pane, pane), pane.close)
            )
        self._desktop.open_overlay(Menu(self._look, "menu.windows", [*windows, *terminals]))

    def toggle_inspector(self) -> None:
        """Open the inspector, or close the one that is open."""
        self._toggle_tool("inspector", "day6_inspector", "inspector")

    def _toggle_tool(self, kind: str, package: str, executable: str) -> None:
        for pane in self._desktop.panes.values():
            if pane.window.kind == kind:
                pane.window.close_by_user()
                return
        self._machine.run_tool(package, executable)

    def toggle_kitchen(self) -> None:
        """Open the kitchen, or close the one that is open."""
        self._toggle_tool("kitchen", "day6_kitchen", "kitchen")

    def close_focused(self) -> None:
        """Close the window or the terminal that has the keyboard."""
        pane = self._desktop.focused_pane
        if isinstance(pane, TerminalPane):
            self._terminals.close(pane)
        elif isinstance(pane, WindowPane) or pane is self._desktop.welcome:
            pane.close()
