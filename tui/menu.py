"""A list to choose from, searched by typing: the command palette and the list of windows."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from textual import events

from day6_tui.tui.cells import cell_len, clip, fit
from day6_tui.tui.look import Look
from day6_tui.tui.overlay import Overlay
from day6_tui.tui.pane import Piece

if TYPE_CHECKING:
    from textual.fuzzy import FuzzySearch


class Entry(NamedTuple):
    """One line: its name, the note to the right of it, what choosing and deleting it do."""

    name: str
    note: str
    choose: Callable[[], object]
    delete: Callable[[], object] | None = None
    also: Sequence[str] = ()
    """Its names in other languages."""
    words: str = ""
    """More text to search in: its explanation."""


MOST_WAYS = 10_000
"""FuzzySearch looks at every way in which letters can stand in a name; that of a topic may be anybody's."""


def _is_quick(letters: str, name: str) -> bool:
    """Return whether a search for letters in a name ends soon: what occurs as it is does at once."""
    return letters in name or math.prod(name.count(letter) for letter in letters) <= MOST_WAYS


def _rank(entry: Entry, typed: Sequence[str], search: FuzzySearch) -> tuple[int, float] | None:
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
    )
    return (fits.index(True), -score) if any(fits) else None


class Menu(Overlay):
    """Shows `entries`; typing narrows them, Enter chooses."""

    def __init__(self, look: Look, title: str, entries: Sequence[Entry], *, chosen: int = 0) -> None:
        super().__init__(look)
        self._title = title
        self._entries = list(entries)
        self._filter = ""
        self._chosen = chosen
        self._search: FuzzySearch | None = None
        self._found: tuple[tuple[str, int], list[Entry]] = (("", -1), [])
        """What `matches` found last, and for what: every line of the menu asks."""

    def matches(self) -> list[Entry]:
        """The entries that what was typed may mean, the likeliest first: those whose name begins so, those with such a word
        in their name, in the note, in the explanation, and last those in whose name the letters occur in this order."""
        key = (self._filter, len(self._entries))
        if self._found[0] != key:
            self._found = key, self._ranked(self._filter.lower().split())
        return self._found[1]

    def _ranked(self, typed: Sequence[str]) -> list[Entry]:
        if not typed:
            return list(self._entries)
        from textual.fuzzy import FuzzySearch  # not before somebody searches

        search = self._search = self._search or FuzzySearch()
        ranked = [
            (rank, at) for at, each in enumerate(self._entries) if (rank := _rank(each, typed, search)) is not None
        ]
        return [self._entries[at] for _, at in sorted(ranked)]

    def wanted_height(self, width: int) -> int:
        return len(self._entries) + 2

    def title(self) -> list[Piece]:
        return [Piece(f" {self.look.texts(self._title)} ", self.look.colours.title_focus)]

    def status(self) -> list[Piece]:
        deletable = any(entry.delete is not None for entry in self._entries)
        keys = self.look.texts("menu.keys.close" if deletable else "menu.keys")
        return [Piece(f" {keys} ", self.look.colours.overlay_muted)]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        colours, texts = self.look.colours, self.look.texts
        if y == 0:
            self._hits.clear()
            if self._filter:
                return [Segment(f" {self._filter}", colours.overlay_strong), Segment("_", colours.overlay_key)]
            return [Segment(f" {texts('menu.filter')}", colours.overlay_muted)]
        if y == 1:
            return [Segment(self.look.glyphs.border.horizontal * width, colours.overlay_muted)]
        matches = self.matches()
        if not matches:
            return [Segment(f" {texts('menu.none')}", colours.overlay_muted)] if y == 2 else []
        index = y - 2 + self._first(len(matches))
        if index >= len(matches):
            return []
        entry = matches[index]
        on = index == self._chosen
        self.add_hit(y + 1, 1, width + 1, lambda: self._choose(index))
        marker = self.look.glyphs.marker if on else " "
        note = clip(entry.note, width // 2)
        name = fit(f" {marker} {entry.name}", width - cell_len(note) - 2, self.look.glyphs.ellipsis)
        style = colours.choice if on else colours.overlay
        return [Segment(name + "  ", style), Segment(note, style if on else colours.overlay_muted)]

    def _first(self, count: int) -> int:
        room = max(1, self.inner_height - 2)
        return max(0, min(self._chosen - room // 2, count - room))

    def _choose(self, index: int) -> None:
        matches = self.matches()
        if index < len(matches):
            self.dismiss()
            matches[index].choose()

    def handle_overlay_key(self, event: events.Key) -> None:
        count = len(self.matches())
        if event.key in ("down", "tab"):
            self._chosen = (self._chosen + 1) % max(1, count)
        elif event.key in ("up", "shift+tab"):
            self._chosen = (self._chosen - 1) % max(1, count)
        elif event.key in ("pagedown", "end"):
            self._chosen = max(0, count - 1)
        elif event.key in ("pageup", "home"):
            self._chosen = 0
        elif event.key == "enter":
            self._choose(self._chosen)
            return
        elif event.key == "delete":
            self._delete()
        elif event.key == "backspace":
            self._narrow(self._filter[:-1])
        elif event.key == "ctrl+u":
            self._narrow("")
        elif event.character and event.character.isprintable():
            self._narrow(self._filter + event.character)
        self.touch()

    def _narrow(self, text: str) -> None:
        self._filter = text
        self._chosen = 0

    def _delete(self) -> None:
        matches = self.matches()
        if self._chosen < len(matches) and (delete := matches[self._chosen].delete) is not None:
            self._entries.remove(matches[self._chosen])
            self._chosen = max(0, min(self._chosen, len(matches) - 2))
            delete()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._chosen = min(max(0, len(self.matches()) - 1), self._chosen + 1)
        self.touch()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._chosen = max(0, self._chosen - 1)
        self.touch()
