"""The RViz window: the Displays panel on the left, the 3-D view on the right, a line of words below.

Here is what keys and mouse do; `rviz/pane.py` draws.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from textual import events

from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_tui.core.ros.programs.rviz2.model.views import NOMINAL_HEIGHT
from day6_tui.tui.windows.rviz import dialogs, panel
from day6_tui.tui.windows.rviz.pane import PicturePane, in_ascii

TURN = 0.1309
"""Radians an arrow key turns the view: 7.5 degrees."""

SHIFT = 0.06
"""Part of the picture's height by which Shift and an arrow push it."""

_ARROWS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
_BUTTONS = {1: "left", 2: "middle", 3: "right"}
_END = 1_000_000


class RVizPane(PicturePane):
    """The window of an `RViz`."""

    # -- what keys do --------------------------------------------------------------------------------------------------

    def focus_robot(self) -> None:
        """Look at what there is: the robot, or everything solid."""
        found = dialogs.extent(self.rviz.scene)
        if found is None:
            self.say(self.look.texts("rviz.nothing_to_focus"))
        else:
            aspect = self.view.columns / max(1, self.view.rows) / 2
            centre, radius = found
            self.rviz.view.look_at(centre, radius / min(1.0, max(0.2, aspect)))
            self.look.wake()

    def from_above(self) -> None:
        self.rviz.view.from_above()
        self.look.wake()

    def zero(self) -> None:
        self.rviz.view.zero()
        self.look.wake()

    def toggle_panel(self) -> None:
        self.panel_open = not self.panel_open
        self.on_panel = self.panel_open
        self._lay_out()
        self.touch()

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        hints = [("Tab", texts("rviz.key.view" if self.on_panel else "rviz.key.panel"))]
        if self.on_panel:
            hints += [("Enter", texts("rviz.key.edit")), ("^N", texts("rviz.key.add")), ("f", texts("rviz.key.focus"))]
        else:
            arrows = "←↑↓→" if self.look.glyphs.unicode else "arrows"
            hints += [(arrows, texts("rviz.key.turn")), ("+ -", texts("rviz.key.zoom"))]
            hints += [("f", texts("rviz.key.focus")), ("4", texts("rviz.key.above"))]
        return hints if self.look.glyphs.unicode else [(key, in_ascii(text)) for key, text in hints]

    def on_key(self, event: events.Key) -> None:
        key = event.key
        used = self._everywhere_key(key) or (self._panel_key(key) if self.on_panel else self._view_key(key))
        if used:
            event.stop()
            event.prevent_default()
            self.look.wake()

    def _everywhere_key(self, key: str) -> bool:
        actions: dict[str, Callable[[], object]] = {
            "tab": self._other_part,
            "d": self.toggle_panel,
            "f": self.focus_robot,
            "4": self.from_above,
            "z": self.zero,
            "v": self.next_view,
            "p": self.next_quality,
            "r": lambda: self.request(self.rviz.reset),
            "ctrl+n": lambda: dialogs.add(self),
            "a": lambda: dialogs.add(self),
            "ctrl+s": lambda: dialogs.save(self),
            "ctrl+o": lambda: dialogs.load(self),
            "w": lambda: dialogs.save_as(self),
            "g": lambda: dialogs.screenshot(self),
            "plus": lambda: self._zoom(1),
            "equals_sign": lambda: self._zoom(1),
            "minus": lambda: self._zoom(-1),
        }
        action = actions.get(key)
        if action is None:
            return False
        action()
        return True

    def _other_part(self) -> None:
        if not self.panel_open:
            self.panel_open = True
            self.on_panel = True
        else:
            self.on_panel = not self.on_panel
            if self.panel_width == self.inner_width:
                self.panel_open = self.on_panel
        self._words_at = -10.0
        self.touch()

    def _panel_key(self, key: str) -> bool:
        page = max(1, self.body_height - 1)
        steps = {"up": -1, "down": 1, "pageup": -page, "pagedown": page, "home": -_END, "end": _END}
        prop = self.prop
        if key in steps:
            self.chosen += steps[key]
            self._keep_chosen_in_sight()
            self._words_at = -10.0
            return True
        if prop is None:
            return False
        display = self.chosen_display()
        if key == "right":
            self.open_branch(prop, True)
        elif key == "left":
            self._close_or_up(prop)
        elif key == "enter":
            self.edit()
        elif key == "space":
            if prop.kind == BOOL:
                self.toggle(prop)
        elif display is not None and key in ("ctrl+x", "delete"):
            self.request(partial(self.rviz.remove_display, display))
        elif display is not None and key == "ctrl+d":
            self.request(partial(self.rviz.duplicate_display, display))
        elif display is not None and key == "ctrl+r":
            dialogs.rename(self, display)
        elif display is not None and key in ("shift+up", "shift+down"):
            self.request(partial(self.rviz.move_display, display, -1 if key == "shift+up" else 1))
        else:
            return False
        return True

    def _close_or_up(self, prop: Property) -> None:
        if prop.expanded and prop.children:
            self.open_branch(prop, False)
        elif prop.parent is not None and prop.parent.parent is not None:
            self.choose(prop.parent)

    def _view_key(self, key: str) -> bool:
        view = self.rviz.view
        self._used = True
        shifted, _, arrow = key.rpartition("+")
        if arrow in _ARROWS and shifted in ("", "shift"):
            right, down = _ARROWS[arrow]
            if shifted:
                view.pan(right * SHIFT, down * SHIFT)
            else:
                view.rotate(right * TURN, down * TURN)
        elif key in ("pageup", "pagedown"):
            self._zoom(1 if key == "pageup" else -1)
        elif key == "home":
            view.zero()
        elif key == "escape" and self.panel_open:
            self.on_panel = True
        else:
            return False
        return True

    def _zoom(self, steps: float) -> None:
        self.rviz.view.zoom(steps)

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _cell(self, event: events.MouseEvent) -> tuple[int, int]:
        return event.x - self.inner_offset, event.y - self.inner_offset

    def _in_view(self, event: events.MouseEvent) -> bool:
        x, y = self._cell(event)
        return self.view_left <= x < self.inner_width and 0 <= y < self.body_height and bool(self.view.columns)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        button = _BUTTONS.get(event.button)
        if button is None or not self._in_view(event):
            return
        event.stop()
        if not self.has_focus:
            self.focus(scroll_visible=False)
        self.on_panel = False
        self._used = True
        self._drag = (button, bool(event.shift), bool(event.ctrl), event.screen_x, event.screen_y)
        self.view.dragging = True
        self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._drag is None:
            return
        event.stop()
        button, shift, control, x, y = self._drag
        self._drag = (button, shift, control, event.screen_x, event.screen_y)
        # The height of the picture is 600 pixels to RViz's rules; a cell is half as wide as high.
        step = NOMINAL_HEIGHT / max(1, self.view.rows)
        dx, dy = (event.screen_x - x) * step / 2, (event.screen_y - y) * step
        aspect = self.view.columns / max(1, self.view.rows) / 2
        if control and button == "left":
            # The article's way to push the picture.
            button, shift = "middle", False
        elif control and button == "middle":
            button = "left"
        self.rviz.view.drag(button, shift, dx, dy, aspect)
        self.look.wake()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag is not None:
            event.stop()
            self._drag = None
            self.view.dragging = False
            self.release_mouse()
            self.look.wake()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._scroll(event, 1)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._scroll(event, -1)

    def _scroll(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        if self._in_view(event):
            self.rviz.view.wheel(notches, bool(event.shift))
        else:
            self.top = max(0, min(len(self.lines) - self.body_height, self.top - 3 * notches))
            self.chosen = max(self.top, min(self.chosen, self.top + self.body_height - 1))
        self.look.wake()

    def on_click(self, event: events.Click) -> None:
        x, y = self._cell(event)
        if not (0 <= x < self.panel_width and 0 <= y < self.body_height):
            super().on_click(event)
            return
        event.stop()
        index = self.top + y
        self.on_panel = True
        if index >= len(self.lines):
            return
        self.chosen = index
        line = self.lines[index]
        zone = panel.zones(line, self.panel_width)
        if line.can_open and zone.opener <= x <= zone.opener + 1:
            self.open_branch(line.prop, not line.prop.expanded)
        elif zone.box is not None and zone.box <= x < zone.box + 3:
            self.toggle(line.prop)
        elif x >= zone.value or event.chain > 1:
            self.edit()
        self.look.wake()
