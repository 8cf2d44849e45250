"""The windows of rqt_msg and rqt_srv: the fields of types, and the texts that define them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.pane import Piece
from day6_tui.windows.fields.field_list import FieldLine
from day6_tui.windows.fields.pane import FieldPane, Model
from day6_tui.windows.fields.rows import columns_in
from day6_tui.windows.parts.buttons import Button

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_msg.model import TypeBrowser

TREE = "#"
"""Before the number of a tree, in the keys of lines."""


class BrowsingPane(FieldPane[Model]):
    """What the three type browsers share. Enter on a line shows the text of its type."""

    def __init__(self, window: Window[Model], look: Look) -> None:
        super().__init__(window, look, columns_in)
        self._sought: int | None = None
        """The tree that was just added: the cursor goes there."""

    def pull(self, now: float) -> bool:
        again = super().pull(now)
        if self._sought is not None:
            key, self._sought = f"{TREE}{self._sought}", None
            self.list.choose(key)
            self.call_after_refresh(self.list.show_branch, key)
        return again

    @property
    def browser(self) -> TypeBrowser:
        """The part of the model that has the types."""
        raise NotImplementedError

    def state(self) -> tuple[object, ...]:
        return (self.browser.version,)

    def bar(self) -> Sequence[Segment | Button]:
        texts, mark = self.look.texts, " ▾" if self.look.glyphs.chinese else " v"
        buttons = [
            Button("p", self.browser.package or texts("types.no_package"), self.choose_package, mark=mark),
            Button("a", texts("types.add"), self.choose_type),
        ]
        if self.browser.trees:
            buttons += [
                Button("v", texts("types.text"), self._show_chosen),
                Button("d", texts("types.remove"), self._remove_chosen),
            ]
        return buttons

    def lines(self) -> list[FieldLine]:
        texts, browser = self.look.texts, self.browser
        lines = [
            FieldLine("", tuple(texts(f"types.columns.{each}") for each in ("tree", "type", "path")), is_head=True)
        ]
        for tree in browser.trees:
            key = f"{TREE}{tree.number}"
            lines.append(FieldLine(key, (tree.name, tree.type, tree.type), is_branch=bool(tree.rows)))
            lines += [
                FieldLine(
                    key + row.path,
                    (row.name, row.type, tree.type + row.path),
                    row.depth,
                    is_branch=row.is_branch,
                    begins_closed=row.elements > 0,  # all elements are of one type
                )
                for row in tree.rows
            ]
        if not browser.trees:
            lines.append(self.remark(texts(f"types.none.{browser.kind}")))
        return lines + [self.remark(line, warns=True) for line in browser.message.splitlines()]

    def take(self, line: FieldLine, text: str) -> None:
        """Nothing here is typed into."""

    def status(self) -> list[Piece]:
        chosen = self.list.chosen
        if chosen is None or chosen.problem or not chosen.key:
            return super().status()
        # The path of a field, or the name of what is above the types; in its column there may not be room for all of it.
        name = chosen.cells[2 if chosen.key.startswith(TREE) else 0]
        kind = f"{chosen.cells[1]} " if chosen.cells[1] != name else ""
        return [Piece(f" {name} ", self.look.colours.text), Piece(kind, self.look.colours.muted)]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def usual_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        hints = [("a", texts("types.add")), ("p", texts("types.package"))]
        if self.browser.trees:
            hints += [("v", texts("types.text")), ("d", texts("types.remove"))]
        return hints

    def more_key_hints(self) -> list[tuple[str, str]]:
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        return [("Enter", self.look.texts("types.text")), (arrows, self.look.texts("topics.open"))]

    def used(self, event: events.Key) -> bool:
        line = self.list.chosen
        if event.character == "a":
            self.choose_type()
        elif event.character == "p":
            self.choose_package()
        elif line is None or not line.key.startswith(TREE):
            return False
        elif event.character == "v":
            self._show_chosen()
        elif event.character == "d" or event.key == "delete":
            self._remove_chosen()
        else:
            return False
        return True

    def _show_chosen(self) -> None:
        line = self.list.chosen
        if line is not None and line.key.startswith(TREE):
            self.show_text(line)

    def _remove_chosen(self) -> None:
        line = self.list.chosen
        if line is not None and line.key.startswith(TREE):
            self.browser.remove(int(line.key.removeprefix(TREE).partition("/")[0]))
            self.look.wake()

    def enter(self, line: FieldLine) -> None:
        if line.key.startswith(TREE):
            self.show_text(line)

    def show_text(self, line: FieldLine) -> None:
        """Show the text of the type of a line; of a plain field that of the type which has it."""
        from day6_tui.overlays.message import LogModal

        kind = line.cells[1]
        if "/" not in kind:
            parent = line.key.rpartition("/")[0]
            kind = next((each.cells[1] for each in self.list.lines_shown if each.key == parent), kind)
        self.lay_over(LogModal(self.look, kind, self.browser.text(kind).splitlines(), from_top=True))

    def choose_package(self) -> None:
        """Open the list of packages, then that of the chosen one's types."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        def chosen(package: str) -> None:
            self.browser.choose_package(package)
            self.call_after_refresh(self.choose_type)

        names = self.browser.packages()
        entries = [MenuEntry(name, "", lambda name=name: chosen(name)) for name in names]  # type: ignore[misc]
        at = names.index(self.browser.package) if self.browser.package in names else 0
        self.lay_over(Menu(self.look, "types.package", entries, chosen=at))

    def choose_type(self) -> None:
        """Open the list of the package's types."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        def chosen(name: str) -> None:
            before = {tree.number for tree in self.browser.trees}
            self.browser.add(name)
            self._sought = next((tree.number for tree in self.browser.trees if tree.number not in before), None)
            self.look.wake()

        entries = [MenuEntry(name, "", lambda name=name: chosen(name)) for name in self.browser.types()]  # type: ignore[misc]
        self.lay_over(Menu(self.look, f"types.choose.{self.browser.kind}", entries))


class TypeBrowserPane(BrowsingPane["TypeBrowser"]):
    """rqt_msg's and rqt_srv's."""

    @property
    def browser(self) -> TypeBrowser:
        return self.model
