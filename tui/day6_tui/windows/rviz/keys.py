"""What keys do in the RViz window: everywhere in it, in the panel, and in the view."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from day6_core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_core.ros.programs.rviz2.model.views import SavedView
from day6_tui.windows.rviz import dialogs
from day6_tui.windows.rviz.buttons import ADD, LABELS, PanelButton
from day6_tui.windows.rviz.control_keys import ControlKeys
from day6_tui.windows.rviz.hand import Hand
from day6_tui.windows.rviz.hints import Hints, panel_hints, view_hints

if TYPE_CHECKING:
    from day6_tui.windows.rviz.rviz2 import RVizPane

TURN = 0.1309
"""Radians an arrow key turns the view: 7.5 degrees."""

SHIFT = 0.06
"""Fraction of the picture's height by which Shift and an arrow key pan it."""

_ARROWS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
_END = 1_000_000


class WindowKeys:
    """The keys of a window; of those that grasp controls and those of the tools it asks their owners first."""

    def __init__(self, pane: RVizPane, hand: Hand) -> None:
        self._pane = pane
        self._rviz = pane.rviz
        self._hand = hand
        self.controls = ControlKeys(pane.rviz)

    def press(self, key: str) -> bool:
        """Use a key; False if it means nothing in the window."""
        return self._everywhere(key) or (self._panel_key(key) if self._pane.on_panel else self._view_key(key))

    def hints(self) -> Hints:
        """The keys worth naming now."""
        return panel_hints() if self._pane.on_panel else view_hints(self._rviz, self.controls)

    def _everywhere(self, key: str) -> bool:
        pane = self._pane
        if (tool := self._rviz.tools.with_key(key)) is not None:
            pane.use_tool(tool)
            return True
        actions: dict[str, Callable[[], object]] = {
            "tab": pane.to_view if pane.on_panel else pane.to_panel,
            "shift+tab": self._to_buttons,
            "d": pane.toggle_panel,
            "f": pane.focus_robot,
            "4": pane.from_above,
            "z": pane.zero,
            "v": pane.next_view,
            "k": pane.save_view,
            "l": pane.next_quality,
            "r": partial(pane.request, self._rviz.reset),
            "slash": self._find,
            "ctrl+n": partial(dialogs.add, pane),
            ADD.key: partial(dialogs.add, pane),
            "ctrl+s": partial(dialogs.save, pane),
            "ctrl+o": partial(dialogs.load, pane),
            "w": partial(dialogs.save_as, pane),
            "e": partial(dialogs.screenshot, pane),
            "plus": partial(self._zoom, 1),
            "equals_sign": partial(self._zoom, 1),
            "minus": partial(self._zoom, -1),
        }
        action = actions.get(key)
        if action is not None:
            action()
        return action is not None

    def _find(self) -> None:
        self._pane.to_panel()
        dialogs.find(self._pane)

    # -- the panel -----------------------------------------------------------------------------------------------------

    def _to_buttons(self) -> None:
        """Go to the buttons, and from there to the tree."""
        pane = self._pane
        on_buttons = pane.on_panel and pane.panel.buttons.chosen is not None
        if not pane.on_panel:
            pane.to_panel()
        if on_buttons or not pane.panel.buttons.display:
            pane.pass_keyboard()
        else:
            pane.panel.choose_button()

    def _panel_key(self, key: str) -> bool:
        """A key was pressed while the panel has the keyboard; False if it means nothing here."""
        panel = self._pane.panel
        tree, buttons = panel.properties, panel.buttons
        if buttons.chosen is not None:
            return self._button_key(key, buttons.chosen)
        if key == "down" and buttons.display and tree.at_the_end:
            panel.choose_button()
            return True
        page = max(1, tree.size.height - 1)
        steps = {"up": -1, "down": 1, "pageup": -page, "pagedown": page, "home": -_END, "end": _END}
        if key in steps:
            tree.move(steps[key])
            return True
        action = self._tree_actions().get(key)
        if action is not None:
            action()
        return action is not None

    def _button_key(self, key: str, button: PanelButton) -> bool:
        if key in ("left", "right"):
            self._pane.panel.choose_button(1 if key == "right" else -1)
        elif key in ("up", "escape"):
            self._pane.pass_keyboard()
        elif key in ("enter", "space"):
            button.press()
        else:
            return key == "down"
        return True

    def _tree_actions(self) -> dict[str, Callable[[], object]]:
        """Key -> what it does to the chosen line, and to the display it belongs to."""
        pane, tree = self._pane, self._pane.panel.properties
        prop, display = tree.prop, tree.chosen_display
        if prop is None:
            return {}
        actions: dict[str, Callable[[], object]] = {
            "right": partial(pane.open_branch, prop, True),
            "left": partial(self._close_or_up, prop),
            "enter": pane.edit,
            "space": partial(pane.toggle, prop) if prop.kind == BOOL else lambda: None,
        }
        if display is not None or isinstance(prop, SavedView):
            names = {label.key: label.name.lower() for label in LABELS}
            actions |= {key: partial(pane.push, name) for key, name in {**names, "delete": "remove"}.items()}
        if display is not None:
            for step, key in ((-1, "shift+up"), (1, "shift+down")):
                actions[key] = partial(pane.request, partial(self._rviz.move_display, display, step))
        return actions

    def _close_or_up(self, prop: Property) -> None:
        if prop.expanded and prop.children:
            self._pane.open_branch(prop, False)
        elif prop.parent is not None and prop.parent.parent is not None:
            self._pane.choose(prop.parent)

    # -- the view ------------------------------------------------------------------------------------------------------

    def _view_key(self, key: str) -> bool:
        pane = self._pane
        pane.used = True
        shifted, _, plain = key.rpartition("+")
        if plain in _ARROWS and shifted in ("", "shift"):
            self._arrow(*_ARROWS[plain], bool(shifted))
        elif plain in ("pageup", "pagedown"):
            nearer = 1 if plain == "pageup" else -1
            if not self.controls.step(0, 0, nearer, fine=bool(shifted)):
                self._zoom(nearer)
        elif key == "home":
            pane.zero()
        elif key == "escape":
            if not self.controls.leave():
                self._leave_tool()
        elif key in ("x", "X"):
            if not self.controls.next(1 if key == "x" else -1):
                pane.show_message(pane.look.texts("rviz.no_controls"))
        elif key == "enter":
            return self.controls.enter() or self._hand.enter()
        else:
            return key == "space" and self.controls.space()
        return True

    def _arrow(self, right: int, down: int, shift: bool) -> None:
        view = self._rviz.view
        if self.controls.step(right, -down, 0, fine=shift) or self._hand.arrow(right, down, fine=shift):
            return
        self._pane.view.turned()
        if shift:
            view.pan(right * SHIFT, down * SHIFT)
        else:
            view.rotate(right * TURN, down * TURN)

    def _leave_tool(self) -> None:
        """Back to the default tool; from there to the panel."""
        tools = self._rviz.tools
        if tools.current is tools.default:
            self._pane.to_panel()
        self._pane.request(tools.to_default)  # a letter pressed just before may not have been processed yet

    def _zoom(self, steps: float) -> None:
        self._pane.view.turned()
        self._rviz.view.zoom(steps)
