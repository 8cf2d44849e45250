"""Everything the desktop can do: one table from which key bindings, key bar, command palette and help are made.

The name of an action is the text `action.<id>`, its help `help.action.<id>`. The handler is the method `do_<id>` of the
application (dots become underscores), so a missing one is found by a test.
"""

from __future__ import annotations

from typing import NamedTuple


class Action(NamedTuple):
    """One thing the user can ask for."""

    id: str
    key: str = ""
    """Textual's name of the key, '' if it is only in the palette."""
    label: str = ""
    """The key as the user knows it."""
    weight: int = 0
    """How long it stays on the key bar when there is little room; 0: never there."""
    palette: bool = True

    @property
    def handler(self) -> str:
        return "do_" + self.id.replace(".", "_")


ACTIONS: tuple[Action, ...] = (
    Action("terminal", "f2", "F2", weight=5),
    Action("next", "f3", "F3", weight=7),
    Action("previous", "shift+f3", "Shift+F3", palette=False),
    Action("windows", "f4", "F4", weight=4),
    Action("inspector", "f6", "F6", weight=1),
    Action("enlarge", "f8", "F8", weight=3),
    Action("pause", "f9", "F9", weight=2),
    Action("palette", "ctrl+p", "^P", weight=6, palette=False),
    Action("quit", "ctrl+q", "^Q", weight=8),
    Action("help", "f1", "F1"),
    Action("scene.turtle"),
    Action("scene.car"),
    Action("scene.world"),
    Action("close"),
    Action("copy"),
    Action("paste"),
    Action("clear"),
    Action("language"),
    Action("theme"),
    Action("glyphs"),
    Action("grow", "alt+up", "Alt+↑"),
    Action("shrink", "alt+down", "Alt+↓"),
    Action("step"),
    Action("faster"),
    Action("slower"),
    Action("normal"),
    Action("motion"),
)

BY_ID = {action.id: action for action in ACTIONS}


def bar_actions() -> list[Action]:
    """What the key bar shows, in order."""
    return [action for action in ACTIONS if action.weight]


def bindings() -> list[tuple[str, str]]:
    """Pairs of key and action id, for every action that has a key."""
    return [(action.key, action.id) for action in ACTIONS if action.key]
