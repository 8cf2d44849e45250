"""A list to choose from, searched by typing: the command palette, the list of windows, RViz's displays."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from rich.segment import Segment
from textual.app import ComposeResult
from textual.binding import Binding
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions, Visual
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, plain
from day6_tui.panes.cells import cell_len, clip, fit

if TYPE_CHECKING:
    from textual.fuzzy import FuzzySearch
    from textual.widgets import OptionList


class MenuEntry(NamedTuple):
    """One line: its name, the note to the right of it, what choosing and deleting it do."""

    name: str
    note: str
    choose: Callable[[], object]
    delete: Callable[[], object] | None = None
    also: Sequence[str] = ()
    """Its names in other languages, and other words for it."""
    words: str = ""
    """More text to search in: its explanation."""


MOST_WAYS = 10_000
"""FuzzySearch looks at every way in which letters can stand in a name; that of a topic may be anybody's."""


def ranked(entries: Sequence[MenuEntry], typed: str) -> list[MenuEntry]:
    """The entries that what was typed may mean, the likeliest first: those whose name begins so, those with such a word in
    their name, in the note, in the explanation, then those in whose name the letters occur in this order, and last those with a
    Chinese word, which no blanks set apart, somewhere in what was typed."""
    words = typed.lower().split()
    if not words:
        return list(entries)
    from textual.fuzzy import FuzzySearch  # not before somebody searches

    search = FuzzySearch()
    found = [(rank, at) for at, each in enumerate(entries) if (rank := _rank(each, words, search)) is not None]
    return [entries[at] for _, at in sorted(found)]


def _is_quick(letters: str, name: str) -> bool:
    """Return whether a search for letters in a name ends soon: what occurs as it is does at once."""
    return letters in name or math.prod(name.count(letter) for letter in letters) <= MOST_WAYS


def _rank(entry: MenuEntry, typed: Sequence[str], search: FuzzySearch) -> tuple[int, float] | None:
    """How well an entry fits the words that were typed, the lowest best; None if it does not."""
    names = [name.lower() for name in (entry.name, *entry.also)]
    notes = f"{' '.join(names)} {entry.note.lower()}"
    letters = "".join(typed)
    score = max((search.match(letters, name)[0] for name in names if _is_quick(letters, name)), default=0.0)
    fits = (
        any(name.startswith(" ".join(typed)) for name in names),
        any(all(any(word.startswith(each) for word in re.findall(r"\w+", name)) for each in typed) for name in names),
        any(all(each in name for each in typed) for name in names),
        all(each in notes for each in typed),
        all(each in f"{notes} {entry.words.lower()}" for each in typed),
        score > 0,
        any(not name.isascii() and name in letters for name in names),
    )
    return (fits.index(True), -score) if any(fits) else None


class MenuRow(Visual):
    """An entry as Textual draws it in a list: the name at the left, the note at the right end."""

    def __init__(self, entry: MenuEntry, look: Look, options: OptionList, index: int) -> None:
        self._entry = entry
        self._look = look
        self._options = options
        self._index = index

    def render_strips(self, width: int, height: int | None, style: Style, options: RenderOptions) -> list[Strip]:
        ellipsis = self._look.glyphs.ellipsis
        note = clip(self._entry.note, width // 2, ellipsis)
        size = cell_len(note) + 2 if note else 1
        marker = (
            self._look.glyphs.marker if self._options.highlighted == self._index else " "
        )  # for eyes without colour
        name = fit(f" {marker} {self._entry.name}", width - size, ellipsis)
        front = style.foreground
        faint = style if front is None or front.ansi is not None else style + Style(foreground=front.with_alpha(0.7))
        segments = [Segment(name + " ", style.rich_style), Segment(f"{note} " if note else "", faint.rich_style)]
        return [Strip(segments, width)]

    def get_optimal_width(self, rules: Any, container_width: int) -> int:
        return container_width

    def get_minimal_width(self, rules: Any) -> int:
        return 1

    def get_height(self, rules: Any, width: int) -> int:
        return 1


class SearchedList(Modal):
    """A line to type in, and a list of `entries` that it narrows; a subclass lays them out."""

    def __init__(self, look: Look, title: str, keys: str, entries: Sequence[MenuEntry]) -> None:
        super().__init__(look, title, keys)
        self._entries = list(entries)
        self._matches = self._entries
        self._typed = ""

    def _make_widgets(self, placeholder: str, *, id: str | None = None) -> None:  # noqa: A002 - Textual's name
        """Make the line and the list, which gets no keys itself."""
        from textual.widgets import OptionList

        from day6_tui.overlays.input_line import InputLine

        self._line = InputLine(self.look, placeholder=placeholder)
        self._list = OptionList(compact=True, markup=False, id=id)
        self._list.can_focus = False

    @property
    def keyboard(self) -> Widget:
        return self._line

    def matches(self) -> list[MenuEntry]:
        """The entries that are shown, the likeliest first."""
        if self._line.value != self._typed:  # keys may be quicker than Textual's news of them
            self._typed = self._line.value
            self._show(ranked(self._entries, self._typed), 0)
        return self._matches

    def _show(self, entries: list[MenuEntry], chosen: int) -> None:
        self._matches = list(entries)
        self._list.set_options([MenuRow(entry, self.look, self._list, at) for at, entry in enumerate(entries)])
        self._list.highlighted = min(chosen, len(entries) - 1) if entries else None

    def on_input_changed(self) -> None:
        self.matches()

    def move(self, step: int) -> None:
        """The next or previous entry, in a circle."""
        if count := len(self.matches()):
            self._list.highlighted = ((self._list.highlighted or 0) + step) % count


class Menu(SearchedList):
    """Shows `entries`; typing narrows them, Enter or a click chooses."""

    BINDINGS = [
        Binding("down,tab", "move(1)", show=False),
        Binding("up,shift+tab", "move(-1)", show=False),
        Binding("pagedown", "page(1)", show=False),
        Binding("pageup", "page(-1)", show=False),
    ]

    def __init__(
        self, look: Look, title: str, entries: Sequence[MenuEntry], *, chosen: int = 0, keys: str = "menu.keys.close"
    ) -> None:
        """`keys`: what is said of the keys where entries can be deleted."""
        deletable = any(entry.delete is not None for entry in entries)
        super().__init__(look, look.texts(title), look.texts(keys if deletable else "menu.keys"), entries)
        self._chosen = chosen

    def inside(self) -> ComposeResult:
        from textual.widgets import Static

        self._make_widgets(self.look.texts("menu.filter"))
        yield self._line
        yield self._list
        self._nothing = Static(plain(self.look.texts("menu.none")), id="nothing")
        yield self._nothing
        self._show(self._entries, self._chosen)

    def on_resize(self) -> None:
        self._list.styles.height = max(1, min(len(self._entries), self.size.height - 5))

    def _show(self, entries: list[MenuEntry], chosen: int) -> None:
        super()._show(entries, chosen)
        self._list.display, self._nothing.display = bool(entries), not entries

    def action_move(self, step: int) -> None:
        """The next or previous entry."""
        self.move(step)

    def action_page(self, step: int) -> None:
        """The entries of the next or previous page."""
        if self.matches():
            at = (self._list.highlighted or 0) + step * max(1, self._list.size.height - 1)
            self._list.highlighted = max(0, min(len(self._matches) - 1, at))

    def accept(self) -> None:
        """Enter."""
        if self.matches():
            self._choose(self._list.highlighted or 0)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        self._choose(event.option_index)

    def _choose(self, index: int) -> None:
        if self.is_active and index < len(self._matches):
            self.close()
            self._matches[index].choose()

    def delete(self) -> None:
        """Del."""
        matches, index = self.matches(), self._list.highlighted or 0
        if index < len(matches) and (delete := matches[index].delete) is not None:
            self._entries.remove(matches[index])
            self._show([entry for entry in matches if entry is not matches[index]], index)
            delete()
