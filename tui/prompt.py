"""One line to type (a filter, a file name, a number) or one key to answer with. Esc leaves everything as it was."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from rich.segment import Segment
from textual import events

from day6_tui.tui.cells import cell_len, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.overlay import Overlay
from day6_tui.tui.pane import Piece

Taken = Callable[[str], str | None]
"""Receives the typed text; returns what is wrong with it (then the prompt stays open), or None."""


def before_replacing(look: Look, path_of: Callable[[str], Path], taken: Taken) -> Taken:
    """Wrap `taken` for a file name to save under: if the file exists, Enter has to be pressed again."""
    asked = ""

    def checked(text: str) -> str | None:
        nonlocal asked
        path = path_of(text)
        if asked != text and path.is_file():
            asked = text
            return look.texts("prompt.replaces", file=path.name)
        return taken(text)

    return checked


class Prompt(Overlay):
    """Asks for `title`; `note` is shown below the line until `taken` returns a complaint."""

    def __init__(self, look: Look, title: str, value: str, taken: Taken, *, note: str = "") -> None:
        super().__init__(look)
        self._title = title
        self._taken = taken
        self._note = note
        self._complaint = ""
        self.value = value
        self._cursor = len(value)

    def wanted_height(self, width: int) -> int:
        return 1 + max(1, len(wrap(self._complaint or self._note, width - 2)))

    def title(self) -> list[Piece]:
        return [Piece(f" {self._title} ", self.look.colours.title_focus)]

    def status(self) -> list[Piece]:
        return [Piece(f" {self.look.texts('prompt.keys')} ", self.look.colours.overlay_muted)]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        colours = self.look.colours
        if y == 0:
            before, at, after = self._window(width - 2)
            return [
                Segment(" " + before, colours.overlay_strong),
                Segment(at, colours.choice),
                Segment(after, colours.overlay_strong),
            ]
        lines = wrap(self._complaint or self._note, width - 2)
        style = colours.warning if self._complaint else colours.overlay_muted
        return [Segment(" " + lines[y - 1], style)] if y <= len(lines) else []

    def _window(self, width: int) -> tuple[str, str, str]:
        """The visible part of the line: before, at and after the cursor."""
        before, at, after = self.value[: self._cursor], self.value[self._cursor :][:1], self.value[self._cursor + 1 :]
        while before and cell_len(before) > width - 1:
            before = before[1:]
        while after and cell_len(before) + cell_len(at or " ") + cell_len(after) > width:
            after = after[:-1]
        return before, at or " ", after

    def handle_overlay_key(self, event: events.Key) -> None:
        key = event.key
        if key == "enter":
            self._take()
            return
        if key in ("left", "right", "home", "end"):
            steps = {"left": self._cursor - 1, "right": self._cursor + 1, "home": 0, "end": len(self.value)}
            self._cursor = max(0, min(len(self.value), steps[key]))
        elif key == "backspace" and self._cursor:
            self._set(self.value[: self._cursor - 1] + self.value[self._cursor :], self._cursor - 1)
        elif key == "delete":
            self._set(self.value[: self._cursor] + self.value[self._cursor + 1 :], self._cursor)
        elif key == "ctrl+u":
            self._set(self.value[self._cursor :], 0)
        elif event.character and event.character.isprintable():
            self._insert(event.character)
        self.touch()

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self._insert(" ".join(event.text.split()))
        self.touch()

    def _insert(self, text: str) -> None:
        self._set(self.value[: self._cursor] + text + self.value[self._cursor :], self._cursor + len(text))

    def _set(self, value: str, cursor: int) -> None:
        self.value, self._cursor, self._complaint = value, cursor, ""

    def _take(self) -> None:
        complaint = self._taken(self.value)
        if complaint:
            self._complaint = complaint
            if self.parent is not None:
                self.parent.refresh(layout=True)
            self.touch()
        else:
            self.dismiss()


class Question(Overlay):
    """Asks for one of a few keys: `answers` holds their actions, `keys` describes them to the user."""

    def __init__(self, look: Look, title: str, keys: str, answers: Mapping[str, Callable[[], object]]) -> None:
        super().__init__(look)
        self._title = title
        self._keys = keys
        self._answers = answers

    def wanted_height(self, width: int) -> int:
        return len(wrap(self._keys, width - 2))

    def title(self) -> list[Piece]:
        return [Piece(f" {self._title} ", self.look.colours.title_focus)]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        lines = wrap(self._keys, width - 2)
        return [Segment(" " + lines[y], self.look.colours.overlay_strong)] if y < len(lines) else []

    def handle_overlay_key(self, event: events.Key) -> None:
        answer = self._answers.get((event.character or "").lower())
        if answer is not None:
            self.dismiss()
            answer()
