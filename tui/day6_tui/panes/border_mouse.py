"""The mouse on the frames of panes: dragging a border gives room, dragging a title moves the pane."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual import events

from day6_tui.panes.pane import Pane
from day6_tui.panes.splits import Border, Layout, PanePlace

if TYPE_CHECKING:
    from day6_tui.panes.desktop import Desktop

MIDDLE = 0.3
"""This far from every edge (as a part of the pane) a pane that is dropped becomes a tab."""


class FrameMouse:
    """Understands the mouse events that the panes of a desktop have not used."""

    def __init__(self, desktop: Desktop) -> None:
        self._desktop = desktop
        self._border: Border | None = None
        """The border that is dragged."""
        self._moved: Pane | None = None
        """The pane whose title is dragged."""
        self._from = (0, 0)
        """Where it was taken: a click changes the layout under the mouse, and is no drag for that."""

    def press(self, event: events.MouseDown) -> None:
        """Take hold of a border or a title."""
        self._border = self._moved = None
        if event.button != 1:
            return
        x, y = self._at(event)
        found = self._desktop.plan_now()
        slot = _under(found, x, y)
        if slot is None or (pane := self._desktop.slots.get(slot)) is None:
            return
        place = found.places[slot]
        if pane.hit(x - place.x, y - place.y) is None:
            self._border = next((border for border in found.borders if _is_on(border, x, y)), None)
        if self._border is not None:
            self._desktop.capture_mouse()
        elif y == place.y and x < place.right - 4:
            self._moved, self._from = pane, (x, y)

    def drag(self, event: events.MouseMove) -> tuple[Pane, Pane, str] | None:
        """Move the border, or return the pane that is dragged, and the one and the side of it where it would fall."""
        x, y = self._at(event)
        if self._border is not None:
            self._desktop.split_tree.drag(self._border, x if self._border.split.across else y + 1)
            self._desktop.rearrange()
        elif self._moved is not None:
            if not event.button:
                self._moved = None  # it was let go where we could not see it
            elif (target := self._target(x, y, self._moved)) is not None:
                return (self._moved, *target)
        return None

    def release(self, event: events.MouseUp) -> None:
        """Let go: a pane falls where it is."""
        desktop = self._desktop
        if self._border is not None:
            self._border = None
            desktop.release_mouse()
        pane, self._moved = self._moved, None
        place = self._at(event)
        if pane is None or not desktop.holds(pane) or place == self._from:
            return
        if (target := self._target(*place, pane)) is not None:
            desktop.split_tree.move(pane.slot, target[0].slot, target[1])
            desktop.focus_pane(pane)

    def _at(self, event: events.MouseEvent) -> tuple[int, int]:
        region = self._desktop.region
        return int(event.screen_x - region.x), int(event.screen_y - region.y)

    def _target(self, x: int, y: int, pane: Pane) -> tuple[Pane, str] | None:
        """Another pane under the mouse, and the side of it that is nearest; 'tab' in its middle and on its title."""
        found = self._desktop.plan_now()
        slot = _under(found, x, y)
        target = self._desktop.slots.get(slot) if slot is not None else None
        if slot is None or target is None or target is pane:
            return None
        return target, _side(found.places[slot], x, y)


def _under(found: Layout, x: int, y: int) -> int | None:
    return next(
        (slot for slot, place in found.places.items() if place.x <= x < place.right and place.y <= y < place.bottom),
        None,
    )


def _is_on(border: Border, x: int, y: int) -> bool:
    """Whether a cell is the border: both frames beside each other, or the lower edge of the upper pane."""
    if border.split.across:
        return border.at - 1 <= x <= border.at and border.first <= y < border.end
    return y == border.at - 1 and border.first <= x < border.end


def _side(place: PanePlace, x: int, y: int) -> str:
    across, down = (x - place.x + 0.5) / place.width, (y - place.y + 0.5) / place.height
    distances = {"left": across, "right": 1 - across, "above": down, "below": 1 - down}
    side = min(distances, key=lambda each: distances[each])
    return "tab" if distances[side] > MIDDLE or y == place.y else side
