"""The manual (F1) and the command palette, both made from the table of actions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

from day6_core.language import LANGUAGES
from day6_tui.actions import ACTIONS, Actions, Handlers
from day6_tui.features.explaining import Explaining
from day6_tui.locale import catalogue
from day6_tui.parts import Feature, Parts


def programs() -> Iterator[tuple[str, str]]:
    """Names of the programs that come with the desktop, and the commands that start them."""
    from day6_core.ros.program_index import COMMANDS, executables, packages

    yield from ((command, command) for command in COMMANDS if command.startswith(("rqt", "rviz")))
    known = set(COMMANDS.values())
    for package in packages():
        for executable in executables(package):
            if (package, executable) not in known:
                yield f"{package} {executable}", f"ros2 run {package} {executable}"


class Guidance(Feature):
    """Opens them over the desktop."""

    def __init__(self, parts: Parts, registry: Actions, explaining: Explaining) -> None:
        super().__init__(parts)
        self._explaining = explaining
        self._registry = registry

    def actions(self) -> Handlers:
        return {"help": self.toggle_help, "palette": self.open_palette}

    def toggle_help(self) -> None:
        """F1: the card of what a terminal said, or of a status; F1 again, or without a card: the manual; F1 closes that."""
        from day6_tui.overlays.manual import Manual

        overlay, pane = self._desktop.overlay, self._desktop.focused_pane
        if isinstance(overlay, Manual):
            self._desktop.close_overlay()
        elif pane is not None and (overlay is not None or not self._explaining.open_for(pane)):
            self._desktop.open_overlay(Manual(self._look, pane, self._keys_everywhere()))

    def _keys_everywhere(self) -> list[tuple[str, str]]:
        texts, hint = self._look.texts, self._look.hint
        found = [
            (action.label, texts("list.head", name=texts(f"action.{action.id}")) + texts(f"help.action.{action.id}"))
            for action in ACTIONS
            if action.label and action.id not in self._registry.hidden
        ]
        lines = [texts("help.panes"), *(() if self._look.alt else (texts("help.option"),))]
        found += [(key, what) for key, _, what in (line.partition("\t") for line in "\n".join(lines).split("\n"))]
        return [(key, what) for key, what in found if hint(key)]

    def open_palette(self) -> None:
        """Offer every action of the desktop, searchable by its name in either language, and every program."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        texts, entries = self._look.texts, []
        for action in ACTIONS:
            hidden = action.id in self._registry.hidden or (action.id == "language" and not self._look.chinese)
            if action.palette and not hidden:
                key = f"action.{action.id}"
                names = [word for language in LANGUAGES for word in _names(catalogue(language), action.id)]
                choose = self._registry[action.id]
                entries.append(
                    MenuEntry(texts(key), self._look.hint(action.label), choose, also=names, words=texts("help." + key))
                )
        entries += [
            MenuEntry(name, texts("menu.program"), partial(self._terminals.run, command))
            for name, command in programs()
        ]
        self._desktop.open_overlay(Menu(self._look, "menu.palette", entries))


def _names(texts: Mapping[str, str], id_: str) -> list[str]:
    """The name of an action, and the other words for it."""
    return [texts[f"action.{id_}"], *texts.get(f"sought.{id_}", "").split()]
