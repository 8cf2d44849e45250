"""Layouts by name: the ready ones, those the user has saved, and the roles that panes play in them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial

from day6_core.reason import reason
from day6_core.whole_file import write_private
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.json_file import read_object
from day6_tui.panes.layouts import VERSION, Description, build, describe, grid, presenter, roles_in, speaker
from day6_tui.panes.pane import Pane
from day6_tui.panes.placement import WIDE, arranged
from day6_tui.panes.splits import Key
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane
from day6_tui.windows import WindowPane

FOUR = 4

FILE = "layouts.json"

LARGEST = 1_000_000
"""More bytes than layouts can have: the file is something else."""


class Arranging(Feature):
    """Arranges the panes of the desktop anew."""

    def __init__(self, parts: Parts) -> None:
        super().__init__(parts)
        self._speaks = False
        """Whether the layout is the speaker's, which lasts until another one is chosen."""
        self._arranged: set[Key] = set()
        self._enlarged_at: Pane | None = None
        """What gets the keyboard back when the window is put back that was enlarged in its place."""

    def actions(self) -> Handlers:
        return {
            "layout.lesson": self.tidy,
            "layout.four": self.four_terminals,
            "layout.presenter": self.presenter,
            "layout.speaker": self.speaker,
            "enlarge": self.enlarge,
            "layout.save": self.ask_for_name,
            "layout.load": self.list_saved,
        }

    # -- roles ---------------------------------------------------------------------------------------------------------

    def roles(self) -> dict[Key, str]:
        """What each pane is in a layout: 'terminal 2', 'rviz2 1'; windows without a program of their own are left out."""
        found: dict[Key, str] = {}
        counts: dict[str, int] = {}
        for slot, pane in sorted(self._desktop.slots.items()):
            if isinstance(pane, WindowPane):
                kind = pane.window.kind
            elif isinstance(pane, TerminalPane):
                kind = "terminal"
            else:
                continue
            counts[kind] = counts.get(kind, 0) + 1
            found[slot] = f"{kind} {counts[kind]}"
        return found

    def described(self) -> Description | None:
        """The layout as it is now."""
        roles = self.roles()
        return describe(self._desktop.split_tree, lambda key: roles.get(key, ""))

    def apply(self, description: object) -> None:
        """Arrange the panes as described, as far as they are there. Raises ValueError for what is no description."""
        self._speaks = False
        keys = {role: key for key, role in self.roles().items()}
        self._desktop.arrange_as(build(description, keys.get))

    # -- the ready ones ------------------------------------------------------------------------------------------------

    def _sorts(self) -> tuple[list[Key], list[Key]]:
        """The numbers of the terminals and of the windows, those used last first."""
        slots = self._desktop.slots
        recent = self._desktop.recent
        terminals = [slot for slot in recent if isinstance(slots[slot], TerminalPane)]
        return terminals, [slot for slot in recent if isinstance(slots[slot], WindowPane)]

    @property
    def _is_wide(self) -> bool:
        return self._desktop.size.width >= WIDE

    def tidy(self) -> None:
        """Every pane where it is seen best, windows first."""
        self._speaks = False
        terminals, windows = self._sorts()
        desktop = self._desktop
        order = [*terminals[:1], *windows, *terminals[1:]]
        desktop.arrange_as(arranged(order, desktop.room()))

    def four_terminals(self) -> None:
        """Two by two; opens those that are missing."""
        self._speaks = False
        self._open_up_to(FOUR)
        _, windows = self._sorts()
        self._desktop.arrange_as(grid([pane.slot for pane in self._terminals.panes], windows, wide=self._is_wide))

    def presenter(self) -> None:
        """A big picture and one terminal."""
        self._speaks = False
        self._desktop.arrange_as(presenter(*self._sorts(), wide=self._is_wide))

    def speaker(self) -> None:
        """A big terminal and one picture, for a hall; what opens from now on takes its place in it."""
        self._speaks = True
        terminals, windows = self._sorts()
        self._arranged = {*terminals, *windows}
        self._desktop.arrange_as(speaker(terminals, windows, wide=self._is_wide))

    @property
    def speaks(self) -> bool:
        """Whether the layout is the speaker's, in which everything has its place."""
        return self._speaks

    def follow(self) -> None:
        """Give what has been opened or closed its place, while somebody speaks."""
        if self._speaks:
            terminals, windows = self._sorts()
            if {*terminals, *windows} != self._arranged:
                self.speaker()

    def enlarge(self) -> None:
        """Make the focused pane, or the window that is meant, fill the desktop; or put it back, and the keyboard, too."""
        desktop, here = self._desktop, self._desktop.focused_pane
        if isinstance(here, TerminalPane) and not desktop.enlarged and (picture := self._meant_at(here)) is not None:
            self._enlarged_at = here
            desktop.focus_pane(picture)
            desktop.toggle_enlarged()
            return
        if not desktop.enlarged:
            self._enlarged_at = None  # whose window has gone
        desktop.toggle_enlarged()
        if self._enlarged_at is not None and not desktop.enlarged:
            if desktop.holds(self._enlarged_at):
                desktop.focus_pane(self._enlarged_at)
            self._enlarged_at = None

    def show_large(self, pane: Pane, is_large: bool) -> None:
        """Make a pane fill the desktop that nobody has asked for here, or put it back; the keyboard comes back with that."""
        desktop, here = self._desktop, self._desktop.focused_pane
        if is_large and not (desktop.enlarged and here is pane):
            desktop.focus_pane(pane)
            if not desktop.enlarged:
                desktop.toggle_enlarged()
            self._enlarged_at = here
        elif not is_large and desktop.enlarged and here is pane:
            self.enlarge()

    def _meant_at(self, terminal: TerminalPane) -> Pane | None:
        """The window that whoever is at a terminal wants to see larger, None if that is the terminal.

        While somebody speaks it is the picture. Else the newest one of the command that occupies the terminal: nothing can be
        typed there until that window is closed, which, unlike an editor, has not got the keyboard, lest it swallow what is typed.
        """
        desktop = self._desktop
        if self._speaks:
            return next((desktop.slots[slot] for slot in self._sorts()[1]), None)
        commands = terminal.commands
        return next((pane for pane in [*desktop.panes.values()][::-1] if pane.window.command in commands), None)

    # -- saved ones ----------------------------------------------------------------------------------------------------

    def saved(self) -> dict[str, Description]:
        """The saved layouts by name.

        Raises:
            OSError: the file cannot be read.
            ValueError: it is not one of ours, or of another version.
        """
        path = self._machine.own_file(FILE)
        if path is None or not path.exists():
            return {}
        foreign = ValueError(self._look.texts("layout.foreign", version=VERSION))
        try:
            found = read_object(path, LARGEST)
        except ValueError:
            raise foreign from None
        layouts = found.get("layouts")
        if found.get("version") != VERSION or not isinstance(layouts, Mapping):
            raise foreign
        for layout in layouts.values():
            roles_in(layout)
        return dict(layouts)

    def _saved_or_told(self) -> dict[str, Description] | None:
        try:
            return self.saved()
        except (OSError, ValueError) as error:
            self._notices.show(self._complaint(error), NOTICE_SECONDS)
            return None

    def _complaint(self, error: OSError | ValueError) -> str:
        return self._look.texts("layout.unreadable", file=FILE, reason=reason(error).partition("\n")[0])

    def ask_for_name(self) -> None:
        """Ask under which name to save the layout."""
        from day6_tui.overlays.prompt import Prompt

        texts = self._look.texts
        self._desktop.open_overlay(Prompt(self._look, texts("layout.name"), "", self._save))

    def _save(self, name: str) -> str | None:
        name = name.strip()
        layout, path = self.described(), self._machine.own_file(FILE)
        if not name or layout is None or path is None:
            return self._look.texts("layout.no_name")
        try:
            layouts = {**self.saved(), name: layout}
            write_private(path, json.dumps({"version": VERSION, "layouts": layouts}, ensure_ascii=False).encode())
        except (OSError, ValueError) as error:  # never over a file that is not ours
            return self._complaint(error)
        self._notices.show(self._look.texts("layout.saved", name=name))
        return None

    def list_saved(self) -> None:
        """Offer the ready and the saved layouts."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        texts = self._look.texts
        ready = {"layout.lesson": self.tidy, "layout.four": self.four_terminals, "layout.presenter": self.presenter}
        ready["layout.speaker"] = self.speaker
        entries = [MenuEntry(texts(f"action.{name}"), "", choose) for name, choose in ready.items()]
        for name, layout in (self._saved_or_told() or {}).items():
            entries.append(MenuEntry(name, texts("layout.own"), partial(self._load, layout)))
        self._desktop.open_overlay(Menu(self._look, "menu.layouts", entries))

    def _load(self, layout: Description) -> None:
        self._open_up_to(sum(role.startswith("terminal ") for role in roles_in(layout)))
        self.apply(layout)

    def _open_up_to(self, count: int) -> None:
        """Open terminals until there are so many, or there is no room for more programs."""
        while len(self._terminals.panes) < count and self._terminals.open() is not None:
            pass
