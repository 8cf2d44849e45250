"""A window that shows messages as trees of fields and lets them be filled in: base of four of rqt's plugins."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Sequence
from functools import partial
from typing import Generic, TypeVar

from rich.segment import Segment
from textual import events, on
from textual.widget import Widget

from day6_core.ros.programs.rqt_py_common.message_form import SEQUENCE
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.pane import Action, Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows.fields.entry import FieldEntry
from day6_tui.windows.fields.field_list import Columns, FieldLine, FieldList
from day6_tui.windows.parts.buttons import Button, button_line
from day6_tui.windows.parts.pane_list import ListPane

Model = TypeVar("Model")

BEGINS = frozenset("0123456789.-'\"[(")
"""What is typed on a line begins its value anew, if it is no key of the window."""

BOOLEAN = "boolean"
"""The type of a field that a key switches."""


class FieldPane(ListPane[Model, FieldList], Generic[Model]):
    """Draws its first line and the frame. A subclass says what the lines are, and what becomes of what is typed there."""

    needs = PaneNeeds(Extent(36, 9), Extent(60, 14), Extent(100, 24))

    DEFAULT_CSS = """
    FieldPane { layers: list entry; layout: vertical; }
    FieldPane > FieldList, FieldPane > FieldList:focus { layer: list; margin: 2 1 1 1; }
    """

    key_weight = 3  # one more of its keys where there is no room for F8, too

    def __init__(self, window: Window[Model], look: Look, columns: Columns) -> None:
        super().__init__(window, look, FieldList(look, columns))
        self._entry: FieldEntry | None = None
        """Where something is typed at present."""
        self._shown: tuple[object, ...] = ()
        self._subject: object = None

    # -- for subclasses ------------------------------------------------------------------------------------------------

    @abstractmethod
    def state(self) -> tuple[object, ...]:
        """What the lines depend on."""

    @abstractmethod
    def lines(self) -> list[FieldLine]:
        """The lines."""

    @abstractmethod
    def take(self, line: FieldLine, text: str) -> None:
        """Something was typed over the cell of a line."""

    @abstractmethod
    def bar(self) -> Sequence[Segment | Button]:
        """The first line: texts and buttons."""

    def subject(self) -> object:
        """What the lines are about: of something else, the cursor goes to the first line that can be typed into."""
        return None

    def usual_hints(self) -> list[tuple[str, str]]:
        """The keys for the key bar while nothing is typed."""
        return []

    def resize(self, line: FieldLine, step: int) -> None:
        """Give a sequence one element more (1) or less (-1)."""

    def line_hints(self) -> list[tuple[str, str]]:
        """The keys for the chosen line."""
        texts, line = self.look.texts, self.list.chosen
        if line is None or (line.edited is None and not line.is_branch):
            return []
        if line.edited is None:
            return [("Enter", texts("topics.open"))]
        if line.cells[1] == BOOLEAN:
            return [("Space", texts("reconfigure.switch"))]
        return [("Enter", texts("fields.edit"))]

    def tick(self, line: FieldLine) -> None:
        """The check box of a line was clicked."""

    def enter(self, line: FieldLine) -> None:
        """Enter on a line that cannot be typed into."""
        if line.is_branch:
            self.toggle(line)

    def toggle(self, line: FieldLine) -> None:
        """Open a branch, or close it."""
        self.list.toggle(line)

    def used(self, event: events.Key) -> bool:
        """Handle a key of this window; return False for one that is none of its."""
        return False

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (*self.state(), self.extent, self.look.texts.language)
        if state != self._shown and self.list.is_attached:
            self._shown = state
            is_new = self.subject() != self._subject
            self._subject = self.subject()
            self.list.show(self.lines(), anew=is_new)
            self.touch_lines([0])
            self.touch_frame()
        self._place_entry()
        return False

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        return [] if y else button_line(self, y, self.bar(), width)

    def status(self) -> list[Piece]:
        chosen, colours = self.list.chosen, self.look.colours
        if chosen is not None and self.list.hides_type(chosen):
            name = self.look.texts("list.head", name=chosen.cells[0].rpartition("/")[2] or chosen.cells[0])
            return [Piece(f" {name}{chosen.cells[1]} ", colours.muted)]
        return []

    @on(FieldList.Moved)
    def show_problem(self, event: FieldList.Moved) -> None:
        event.stop()
        self.touch_status()

    def restyle(self) -> None:
        self._shown = ()
        self.list.lines_shown = []
        super().restyle()

    # -- typing --------------------------------------------------------------------------------------------------------

    @property
    def focus_target(self) -> Widget:
        return self._entry if self._entry is not None and self._entry.is_attached else super().focus_target

    def type_over(self, line: FieldLine, begun: str | None = None) -> None:
        """Let the cell of a line be typed into, from its text, or from what was `begun`."""
        self.list.choose(line.key)
        if line.edited is not None and self._entry is None:
            self._entry = FieldEntry(self.look, line, begun)
            self.mount(self._entry)
            self._place_entry()
            self.screen.set_focus(self._entry, scroll_visible=False)

    @on(FieldEntry.Done)
    def take_typed(self, event: FieldEntry.Done) -> None:
        event.stop()
        entry, line, next_line = event.entry, event.entry.line, None
        if event.text is not None and event.text != line.typed:
            self.take(line, event.text)
        if event.step:
            keys = [each.key for each in self.list.lines_shown]
            at = keys.index(line.key) if line.key in keys else 0
            beyond = self.list.lines_shown[at + 1 :] if event.step > 0 else self.list.lines_shown[:at][::-1]
            next_line = next((each for each in beyond if each.edited is not None and not each.is_branch), None)
        had_keyboard = self.screen.focused in (entry, None)
        self._entry = None
        entry.remove()
        if had_keyboard:
            self.screen.set_focus(self.list, scroll_visible=False)
            if next_line is not None:
                self.type_over(next_line)
        self.look.wake()

    def _place_entry(self) -> None:
        """Keep what is typed on its line."""
        if (entry := self._entry) is None:
            return
        if all(each.key != entry.line.key for each in self.list.lines_shown):
            entry.leave()  # what it is about has gone
            return
        place = self.list.place_of_cell(entry.line)
        if place is not None:
            x, y, width = place
            entry.styles.offset = (self.list.styles.margin.left + x, self.list.styles.margin.top + y)
            entry.styles.width = max(1, min(width, self.inner_width - x))
        entry.styles.visibility = "visible" if place is not None else "hidden"

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self._entry is None:
            return self.usual_hints()
        return [("Enter", texts("fields.take")), ("Tab", texts("fields.on")), ("Esc", texts("fields.leave"))]

    @on(FieldList.Used)
    def use(self, event: FieldList.Used) -> None:
        """Enter or a click on a line."""
        event.stop()
        line = event.line
        if event.part == "box":
            self.tick(line)
        elif event.part == "opener":
            self.toggle(line)
        elif line.edited is None:
            self.enter(line)
        else:
            self.type_over(line)
        self.look.wake()

    def on_key(self, event: events.Key) -> None:
        line = self.list.chosen
        if self.used(event):
            pass
        elif line is None:
            return
        elif event.key in ("left", "right"):
            if line.is_branch and self.list.is_open(line) is not (event.key == "right"):
                self.toggle(line)
            elif event.key == "left":
                self.list.choose_parent()
        elif event.key == "delete" and line.edited is not None:
            self.take(line, "")
        elif event.key == "space" and line.edited is not None and line.cells[1] == BOOLEAN:
            self.take(line, str(line.typed != "True"))
        elif event.character in ("+", "-") and line.edited is not None and line.cells[1].startswith(SEQUENCE):
            self.resize(line, 1 if event.character == "+" else -1)
        elif event.character in BEGINS and line.edited is not None:
            self.type_over(line, event.character)
        else:
            return
        event.stop()
        event.prevent_default()
        self.look.wake()

    def remark(self, text: str, *, warns: bool = False) -> FieldLine:
        """A line that only tells something."""
        return FieldLine("", (text,), problem=text if warns else "")

    def ask_action(self, name: str) -> Action:
        """A request of the model, for a button."""
        return partial(self._request, name)

    def _request(self, name: str) -> None:
        getattr(self.model, name)()
        self.look.wake()
