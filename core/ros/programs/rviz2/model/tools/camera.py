"""Move Camera and Interact: the mouse moves the view (rviz_default_plugins/tools/move, interaction)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_tui.core.ros.programs.rviz2.model.tools.tool import Pointer, Tool

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rviz2.model.displays.interactive_markers import InteractiveMarkersDisplay


class MoveCamera(Tool):
    """The view's own rules for the mouse."""

    type, title, short, key = "MoveCamera", "Move Camera", "Move", "m"

    @property
    def status(self) -> str:
        return self.rviz.view.help


class Interact(Tool):
    """Interactive markers take the mouse where they are; elsewhere it moves the view."""

    type, title, short, key = "Interact", "Interact", "Interact", "i"
    grabs = True

    def build(self) -> None:
        self.hide = self.add(Property("Hide Inactive Objects", BOOL, True, on_change=self._hide_changed))
        self._held: InteractiveMarkersDisplay | None = None
        self._words = ""

    def _hide_changed(self) -> None:
        if self.rviz.tools.current is not self:
            self.deactivate()
        self.rviz.touch()

    @property
    def status(self) -> str:
        return self._words or self.rviz.view.help

    def activate(self) -> None:
        self.rviz.interaction = True

    def deactivate(self) -> None:
        self.rviz.interaction = not self.hide.value
        self._held, self._words = None, ""

    def wants(self, pointer: Pointer) -> bool:
        return pointer.hit is not None and pointer.hit.owner.type == "InteractiveMarkers"

    def press(self, pointer: Pointer) -> bool:
        assert pointer.hit is not None
        held: InteractiveMarkersDisplay = pointer.hit.owner
        self._held, self._words = held, held.words_of(pointer.hit.key)
        held.press(pointer.hit.key, pointer)
        return False

    def menu(self, pointer: Pointer) -> bool:
        assert pointer.hit is not None
        pointer.hit.owner.open_menu(pointer.hit.key, pointer)
        return False

    def drag(self, pointer: Pointer) -> bool:
        if self._held is not None:
            self._held.drag(pointer)
        return False

    def release(self, pointer: Pointer) -> bool:
        if self._held is not None:
            self._held.release(pointer)
        self._held, self._words = None, ""
        return False
