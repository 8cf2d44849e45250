"""Everything the desktop can do: the one table behind the key bindings, the key bar, the command palette and the help.

The name of an action is the text `action.<id>`, its help `help.action.<id>`. The object that owns what an action
changes offers its handler in `actions()`; the application collects the handlers in one `Actions`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from day6_core.lessons.scene import scenes


class DesktopAction(NamedTuple):
    """One thing the user can ask for."""

    id: str
    key: str = ""
    """Textual's name for the key; '' if the action is only in the palette."""
    label: str = ""
    """The key as the user knows it."""
    weight: int = 0
    """Its priority on the key bar when there is little room; 0: never shown there."""
    alone: int = 0
    """The same where the pane has no keys of its own; 0: it is no other."""
    palette: bool = True


ARROW_OF = {"left": "left", "right": "right", "above": "up", "below": "down"}
"""The arrow key of each direction."""

ACTIONS: tuple[DesktopAction, ...] = (
    DesktopAction("terminal", "f2", "F2", weight=5),
    DesktopAction("next", "f3", "F3", weight=7),
    DesktopAction("previous", "shift+f3", "Shift+F3", palette=False),
    DesktopAction("windows", "f4", "F4", weight=4),
    DesktopAction("lessons", "f5", "F5", weight=2, alone=5),
    DesktopAction("inspector", "f6", "F6", weight=1),
    DesktopAction("enlarge", "f8", "F8", weight=3),
    DesktopAction("pause", "f9", "F9", weight=2),
    DesktopAction("palette", "f7", "F7", weight=6, palette=False),
    DesktopAction("quit", "ctrl+q", "^Q", weight=8),
    DesktopAction("help", "f1", "F1"),
    DesktopAction("pupil"),
    *(DesktopAction(f"scene.{scene.name}") for scene in scenes().values() if scene.is_action),
    DesktopAction("split.right", "alt+backslash", "Alt+\\"),
    DesktopAction("split.below", "alt+minus", "Alt+-"),
    DesktopAction("close"),
    DesktopAction("copy"),
    DesktopAction("paste"),
    DesktopAction("find", "ctrl+shift+f", "^⇧F"),
    DesktopAction("clear"),
    DesktopAction("language"),
    DesktopAction("theme"),
    DesktopAction("distro"),
    DesktopAction("glyphs"),
    DesktopAction("letters"),
    DesktopAction("layout.load"),
    DesktopAction("layout.save"),
    DesktopAction("layout.lesson"),
    DesktopAction("layout.four"),
    DesktopAction("layout.presenter"),
    DesktopAction("stack"),
    *(DesktopAction(f"move.{side}") for side in ARROW_OF),
    DesktopAction("step"),
    DesktopAction("faster"),
    DesktopAction("slower"),
    DesktopAction("normal"),
    DesktopAction("fastest"),
    DesktopAction("back"),
    DesktopAction("motion"),
    DesktopAction("detach"),
    DesktopAction("class"),
    DesktopAction("hand"),
    DesktopAction("answer", "f10", "F10"),
    DesktopAction("sayings"),
    DesktopAction("take_back"),
    DesktopAction("stop_showing"),
    DesktopAction("see_shown"),
    DesktopAction("kitchen"),
    DesktopAction("record"),
    DesktopAction("layout.speaker"),
    *(DesktopAction(f"scene.{what}") for what in ("pause", "step", "faster", "slower")),
)

BY_ID = {action.id: action for action in ACTIONS}


def bar_actions() -> list[DesktopAction]:
    """What the key bar shows, in order."""
    return [action for action in ACTIONS if action.weight]


def bindings() -> list[tuple[str, str]]:
    """Pairs of key and action id, for every action that has a key."""
    return [(action.key, action.id) for action in ACTIONS if action.key]


def pane_bindings() -> list[tuple[str, str]]:
    """Pairs of key and the call it stands for, for the keys that name a direction or the number of a pane."""
    found = [(f"alt+{number}", f"go_to({number})") for number in range(1, 10)]
    for side, arrow in ARROW_OF.items():
        found += [(f"alt+{arrow}", f"focus_beside('{side}')"), (f"alt+shift+{arrow}", f"resize('{side}')")]
    return found


Handlers = Mapping[str, Callable[[], object]]
"""Handlers by action id."""


class Actions:
    """The handlers of all actions, collected from the objects that each own a part of the desktop."""

    def __init__(self) -> None:
        self._handlers: dict[str, Callable[[], object]] = {}
        self.hidden: set[str] = set()
        """Actions that cannot be done here, and are offered nowhere."""

    def offer(self, handlers: Handlers) -> None:
        """Add handlers. Raises ValueError for an id that is not an action, or is offered twice."""
        for id_, handler in handlers.items():
            if id_ not in BY_ID or id_ in self._handlers:
                raise ValueError(id_)
            self._handlers[id_] = handler

    def missing(self) -> set[str]:
        """The actions without a handler."""
        return BY_ID.keys() - self._handlers.keys()

    def __getitem__(self, id_: str) -> Callable[[], object]:
        return self._handlers[id_]
