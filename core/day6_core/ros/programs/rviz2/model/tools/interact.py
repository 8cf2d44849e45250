"""Interact: interactive markers take mouse and keys (rviz_default_plugins/tools/interaction)."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, cast

from day6_core.ros.programs.rviz2.model.key_steps import FINE, FINE_TURN, TURN, step_at
from day6_core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_core.ros.programs.rviz2.model.tools.tool import Hit, Pointer, Tool

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.displays.interactive_markers import InteractiveMarkersDisplay

INTERACTIVE_MARKERS = "InteractiveMarkers"
"""The type of the display, which is imported only when somebody adds it."""

NEAR, IN_USE = 0.3, 0.5
"""How much brighter a control is that the mouse is over, or the keys are at, and one that is held."""


class Thing(NamedTuple):
    """A control: its display, the names of its marker and of itself."""

    display: InteractiveMarkersDisplay
    key: tuple[str, str]

    @property
    def there(self) -> bool:
        """Whether it can be used still."""
        return self.display.enabled and self.key in self.display.controls()

    @property
    def mode(self) -> int | None:
        """Its interaction mode; None if it is gone."""
        return self.display.mode_of(self.key)

    @property
    def has_menu(self) -> bool:
        """Whether its marker has a menu."""
        return self.display.has_menu(self.key)


class Interact(Tool):
    """Interactive markers take the mouse where they are; elsewhere it moves the view.

    Keys choose a control, hold it as the left button does, move it, and let it go.
    """

    type, title, short, key = "Interact", "Interact", "Interact", "i"
    grabs = True

    def build(self) -> None:
        self.hide = self.add(Property("Hide Inactive Objects", BOOL, True, on_change=self._hide_changed))
        self._held: Thing | None = None
        """What the mouse or the keys hold."""
        self._chosen: Thing | None = None
        """What the keys are at."""
        self._over: Thing | None = None
        """What the mouse is over."""

    def _hide_changed(self) -> None:
        if self.rviz.tools.current is not self:
            self.deactivate()
        self.rviz.touch()

    @property
    def status(self) -> str:
        if self._chosen is not None and (words := self._chosen.display.words_of(self._chosen.key)):
            return f"{'/'.join(self._chosen.key)}: {words}"
        thing = self._held or self._over
        return (thing.display.words_of(thing.key) if thing is not None else "") or self.rviz.view.help

    def activate(self) -> None:
        self.rviz.interaction = True

    def deactivate(self) -> None:
        self._over = None
        self.choose(None)
        self.rviz.interaction = not self.hide.value

    # -- the mouse -------------------------------------------------------------------------------------------------------

    def wants(self, pointer: Pointer) -> bool:
        return pointer.hit is not None and pointer.hit.owner.type == INTERACTIVE_MARKERS

    def hover(self, pointer: Pointer) -> bool:
        over = Thing(pointer.hit.owner, pointer.hit.key) if pointer.hit is not None and self.wants(pointer) else None
        if over != self._over:
            self._over = over
            self._light()
        return False

    def press(self, pointer: Pointer) -> bool:
        assert pointer.hit is not None
        self.choose(None)
        self._hold(Thing(pointer.hit.owner, pointer.hit.key), pointer)
        return False

    def menu(self, pointer: Pointer) -> bool:
        assert pointer.hit is not None
        pointer.hit.owner.open_menu(pointer.hit.key, pointer)
        return False

    def drag(self, pointer: Pointer) -> bool:
        if self._held is not None:
            self._held.display.drag(pointer)
        return False

    def wheel(self, notches: float) -> bool:
        if self._held is not None:
            self._held.display.wheel(notches)
        return False

    def release(self, pointer: Pointer) -> bool:
        self._let_go(pointer)
        return False

    def _hold(self, thing: Thing, pointer: Pointer) -> None:
        self._held = thing
        self.rviz.interaction = not self.hide.value
        self._light()
        thing.display.press(thing.key, pointer)

    def _let_go(self, pointer: Pointer) -> None:
        if self._held is not None:
            held, self._held = self._held, None
            held.display.release(pointer)
        self.rviz.interaction = True
        self._light()

    def _light(self) -> None:
        """Show what is in use."""
        for thing in self.things:
            thing.display.lights.clear()
        for lit, amount in ((self._over, NEAR), (self._chosen, NEAR), (self._held, IN_USE)):
            if lit is not None:
                lit.display.lights[lit.key] = amount

    # -- keys ------------------------------------------------------------------------------------------------------------

    @property
    def things(self) -> list[Thing]:
        """All controls that can be used; any thread."""
        found = []
        for display in self.rviz.displays:
            if display.type == INTERACTIVE_MARKERS and display.enabled:
                markers = cast("InteractiveMarkersDisplay", display)
                found += [Thing(markers, key) for key in markers.controls()]
        return found

    def choose(self, thing: Thing | None) -> bool:
        """Point to a control, or to none; what is held is let go."""
        if self._held is not None:
            self._let_go(self._pointer(self._held))
        self._chosen = thing
        self._light()
        return False

    def hold(self, thing: Thing) -> bool:
        """Take a control, as the left button does that goes down on it."""
        self._hold(thing, self._pointer(thing))
        return False

    def let_go(self) -> bool:
        """Let go, as the left button does that goes up."""
        if self._held is not None:
            self._let_go(self._pointer(self._held))
        return False

    def click(self, thing: Thing) -> bool:
        """Take a control and let it go."""
        self.hold(thing)
        return self.let_go()

    def open_menu(self, thing: Thing) -> bool:
        """Open the menu of a control, as the right button does."""
        thing.display.open_menu(thing.key, self._pointer(thing))
        return False

    def step(self, right: int, up: int, away: int, *, fine: bool, turning: bool) -> bool:
        """Move what is held to the right, up or away from the viewer, or turn it: -1, 0 or 1 of each."""
        from day6_core.ros.programs.rviz2.model.displays.control_keys import Steps

        if (thing := self._held) is not None:
            metres = step_at(self.rviz.view.camera(), thing.display.place_of(thing.key)) * (FINE if fine else 1)
            thing.display.step(Steps(right, up, away, metres, FINE_TURN if fine else TURN), turning)
        return False

    def _pointer(self, thing: Thing) -> Pointer:
        """As if the mouse were on a control."""
        camera, point = self.rviz.view.camera(), thing.display.place_of(thing.key)
        if camera.metres is not None:
            depth = sum((a - b) * c for a, b, c in zip(point, camera.position, camera.forward, strict=True))
            along, start = camera.forward, Pointer(point, camera.forward).at(-depth)
        else:
            start = camera.position
            along = (point[0] - start[0], point[1] - start[1], point[2] - start[2])
        return Pointer(start, along, Hit(point, thing.display, thing.key))
