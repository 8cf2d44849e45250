"""The console's check boxes: the severities; a ticked one is left out, as in the list of the real window."""

from __future__ import annotations

from collections.abc import Iterator

from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.content import Content
from textual.geometry import Size
from textual.widgets import Checkbox, Static

from day6_core.ros.programs.rqt_console.filters import SIDES, FilterChoice
from day6_core.ros.programs.rqt_console.model import SEVERITIES
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import plain
from day6_tui.panes.cells import cell_len, clip
from day6_tui.textual_private.survival import PersonMessage, Surviving
from day6_tui.windows.console.filters import brief

IN_FULL = sum(len(severity) + 5 for severity in SEVERITIES.values())
"""Columns that the boxes need with the severities in full; in fewer they have their letters."""


class SeverityBox(Checkbox, can_focus=False):
    """A severity: its letter is its key, so that the table keeps the keyboard."""

    def __init__(self, level: int) -> None:
        super().__init__(compact=True)
        self.level = level

    @property
    def _tick(self) -> Content:
        """The box: with Textual's, a tick would be told by its colour alone."""
        return Content("[x]" if self.value else "[ ]")

    def render(self) -> Content:
        word = self.label.stylize_before(self.get_visual_style("toggle--label"))
        return Content.assemble(self._tick, " " if len(word) > 1 else "", word, " ")

    def get_content_width(self, container: Size, viewport: Size) -> int:
        return len(self.render())

    def name_it(self, *, in_full: bool) -> None:
        """Show the severity in full, or its letter."""
        word = SEVERITIES[self.level] if in_full else SEVERITIES[self.level][:1]
        label = Content.assemble((word[:1], "bold $primary"), word[1:])
        if label != self.label:
            self.label = label


class Severities(Surviving, Horizontal):
    """The boxes, and beside them what else is left out or stands out."""

    messages_are_typed = True

    class Toggled(PersonMessage):
        """The user wants a severity left out, or shown again."""

        def __init__(self, level: int) -> None:
            super().__init__()
            self.level = level

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._title = Static()
        self._boxes = [SeverityBox(level) for level in SEVERITIES]
        self._others = Static(id="others")

    def compose(self) -> ComposeResult:
        yield self._title
        yield from self._boxes
        yield self._others

    def show(self, choice: FilterChoice, width: int) -> None:
        """Show what is left out, in so many cells."""
        title = " " + self._heading("excludes").rstrip() + " "
        self._title.update(plain(title))
        first = choice.first("excludes", "severity")
        others = list(self._told(choice))
        taken = cell_len(title) + sum(each.cell_length for each in others)
        for box in self._boxes:
            box.name_it(in_full=width >= IN_FULL + taken)
            with box.prevent(Checkbox.Changed):
                box.value = first.enabled and box.level in first.levels
        self._others.display = bool(others)
        self._others.update(Content("").join(others))

    def _told(self, choice: FilterChoice) -> Iterator[Content]:
        dots, boxes = self._look.glyphs.ellipsis, choice.first("excludes", "severity")
        for side in SIDES:
            said = [
                clip(brief(each), 30, dots) for each in getattr(choice, side) if each.is_active and each is not boxes
            ]
            if said:
                heading = self._heading(f"{side}.also")
                yield Content.assemble((f" {heading}", "$muted"), (", ".join(said), "bold $primary"))
        if choice.only_highlighted:
            yield Content.assemble((f" {self._look.texts('console.only.short')}", "bold $primary"))

    def _heading(self, key: str) -> str:
        return self._look.texts("list.head", name=self._look.texts(f"console.{key}"))

    @on(Checkbox.Changed)
    def toggle(self, event: Checkbox.Changed) -> None:
        event.stop()
        assert isinstance(event.checkbox, SeverityBox)
        self.post_message(self.Toggled(event.checkbox.level))
