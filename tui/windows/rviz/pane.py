"""What the RViz window shows: panel, view and words; the keys and the mouse are in `windows/rviz2.py`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from time import monotonic
from typing import Any

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rviz2.model.display import Display
from day6_tui.core.ros.programs.rviz2.model.manager import QUALITIES, RViz
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, GROUP, STATUS, BadValue, Property
from day6_tui.core.ros.programs.rviz2.model.status import OK
from day6_tui.core.ros.programs.rviz2.model.views import VIEWS
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import clip, fit, wrap
from day6_tui.tui.locale import Texts
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.rviz import dialogs, panel
from day6_tui.tui.windows.rviz.describing import described
from day6_tui.tui.windows.rviz.view import View3D

NARROWEST_PANEL, WIDEST_PANEL, NARROWEST_VIEW = 30, 56, 24

WORDS_SECONDS = 0.5
"""The sentence below changes at most so often: it is to be read."""


class PicturePane(WindowPane):
    """Draws an `RViz`; keeps what belongs to looking: the chosen line, the scroll position, who has the keys."""

    def __init__(self, window: Window, look: Look) -> None:
        super().__init__(window, look)
        self.rviz: RViz = window.model
        self.view = View3D(self.rviz, look)
        self.lines: list[panel.Line] = []
        self.chosen = 0
        self.top = 0
        self.on_panel = True
        """Whether the keys go to the panel; else to the view."""
        self.panel_open = True
        self.words: list[str] = []
        self._words_at = -10.0
        self._words_seen: tuple[object, ...] = ()
        self._tree_seen = -1
        self._shown_lines: dict[int, tuple[object, ...]] = {}
        self._shown_frame: tuple[str, ...] = ()
        self._used = False
        """Whether the view was turned; before, the status bar says that RViz is ready."""
        self._rate = 0
        """Pictures a second, as told."""
        self._drag: tuple[str, bool, bool, int, int] | None = None
        self._said_at = 0.0
        self._said = ""

    # -- geometry ------------------------------------------------------------------------------------------------------

    @property
    def word_lines(self) -> int:
        """Lines of words below the picture."""
        return 2 if self.inner_height >= 18 else 1

    @property
    def body_height(self) -> int:
        return max(0, self.inner_height - self.word_lines)

    @property
    def panel_width(self) -> int:
        """Columns of the panel, 0 while it is folded away."""
        width = self.inner_width
        if not self.panel_open:
            return 0
        wanted = max(NARROWEST_PANEL, min(WIDEST_PANEL, width * 2 // 5))
        return wanted if width - wanted - 1 >= NARROWEST_VIEW else width

    @property
    def view_left(self) -> int:
        """The first column of the view; there is none where the panel takes all."""
        width = self.panel_width
        return width + 1 if width else 0

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._lay_out()

    def restyle(self) -> None:
        self.view.forget()
        self.words = []
        super().restyle()

    def _lay_out(self) -> None:
        columns = max(0, self.inner_width - self.view_left)
        self.view.resize(columns, self.body_height)
        self._keep_chosen_in_sight()

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if not self.inner_width or not self.body_height:
            return False
        self._lay_out()
        left = self.view_left
        spans, due = self.view.pull(now)
        self._pull_panel()
        if spans:
            self.touch_spans([(row, first + left, end + left) for row, first, end in spans])
        due = self._pull_words(now) or due
        title = tuple(piece.text for piece in (*self.title(), *self.status(), *self.status_right()))
        if title != self._shown_frame:
            self._shown_frame = title
            self.touch_frame()
        return due

    def _pull_panel(self) -> None:
        rviz = self.rviz
        if rviz.tree_version != self._tree_seen:
            self._tree_seen = rviz.tree_version
            self.refresh_lines()
        if not self.panel_width:
            return
        changed = []
        for row in range(self.body_height):
            state = self._line_state(row)
            if self._shown_lines.get(row) != state:
                self._shown_lines[row] = state
                changed.append(row)
        if changed:
            self.touch_lines(changed)

    def _line_state(self, row: int) -> tuple[object, ...]:
        index = self.top + row
        if index >= len(self.lines):
            return ()
        line = self.lines[index]
        prop = line.prop
        display = prop.statuses.level if isinstance(prop, Display) else 0
        focused = self.on_panel and self.has_focus
        return (
            prop,
            line.depth,
            prop.name,
            prop.value,
            prop.expanded,
            line.can_open,
            display,
            index == self.chosen,
            focused,
        )

    def refresh_lines(self) -> None:
        """Walk the tree again; the chosen property stays chosen where it still is."""
        before = self.lines[self.chosen].prop if self.chosen < len(self.lines) else None
        self.lines = panel.lines_of(self.rviz)
        for index, line in enumerate(self.lines):
            if line.prop is before:
                self.chosen = index
                break
        self._keep_chosen_in_sight()

    def _keep_chosen_in_sight(self) -> None:
        self.chosen = max(0, min(self.chosen, len(self.lines) - 1))
        height = max(1, self.body_height)
        if self.chosen < self.top:
            self.top = self.chosen
        elif self.chosen >= self.top + height:
            self.top = self.chosen - height + 1
        self.top = max(0, min(self.top, len(self.lines) - height))

    def _pull_words(self, now: float) -> bool:
        rviz = self.rviz
        state = (rviz.version, rviz.tree_version, self.prop, self.on_panel, self.has_focus, rviz.message, rviz.progress)
        waiting = now < self._said_at
        if state == self._words_seen and self.words and not waiting and not self._said:
            return False
        if now - self._words_at < WORDS_SECONDS and self.words:
            return True
        if not waiting:
            self._said = ""
        self._words_at, self._words_seen = now, state
        self._rate = round(self.view.rate)
        words = wrap(self.sentence(now), max(10, self.inner_width - 2))
        if len(words) > self.word_lines:
            cut = words[self.word_lines - 1] + " " + words[self.word_lines]
            words = [*words[: self.word_lines - 1], clip(cut, self.inner_width - 2, self.look.glyphs.ellipsis)]
        if words != self.words:
            self.words = words
            self.touch_lines(range(self.body_height, self.inner_height))
        return waiting

    def sentence(self, now: float = 0.0) -> str:
        """What stands below: what was just said, what is loading, the chosen line in full, or what can be seen."""
        rviz, texts = self.rviz, self.look.texts
        text = self._sentence(now, rviz, texts)
        return text if self.look.glyphs.unicode else in_ascii(text)

    def _sentence(self, now: float, rviz: RViz, texts: Texts) -> str:
        if self._said and now < self._said_at:
            return self._said
        if rviz.progress:
            return texts("rviz.loading", what=rviz.progress)
        if rviz.message is not None:
            key, parameters = rviz.message
            return texts(key, **parameters)
        if self.on_panel and self.has_focus and self.panel_width and (text := self._chosen_words()):
            return text
        return described(rviz, texts)

    def _chosen_words(self) -> str:
        prop = self.prop
        if prop is None:
            return ""
        if self._needs_topic(prop):
            return self._topic_hint(prop)
        if prop.kind == STATUS or isinstance(prop, Display):
            return panel.full_text(prop)
        return ""

    def _needs_topic(self, prop: Property) -> bool:
        display = self._display_of(prop)
        topic = getattr(display, "topic", None)
        return topic is not None and not topic.hidden and not topic.value and display is not None and display.enabled

    def _topic_hint(self, prop: Property) -> str:
        topic = getattr(self._display_of(prop), "topic", None)
        assert topic is not None
        options = list(topic.options)
        if options:
            return self.look.texts("rviz.hint.topic", name=topic.name, options=", ".join(options[:3]))
        return self.look.texts("rviz.hint.no_topic", name=topic.name)

    def say(self, text: str, seconds: float = 4.0) -> None:
        """Show a sentence below for a while."""
        self._said, self._said_at = text, monotonic() + seconds
        self._words_at = -10.0
        self.look.wake()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        colours = self.look.colours
        statuses = self.rviz.statuses
        style = colours.muted if statuses.level == OK else colours.warning
        star = "*" if self.rviz.modified else ""
        pieces = [
            Piece(star + " ", colours.muted),
            Piece(f"Fixed Frame {self.rviz.fixed_frame} ", style, self._to_fixed),
        ]
        return [*super().title(), *pieces]

    def _to_fixed(self) -> None:
        self.panel_open = self.on_panel = True
        self.choose(self.rviz.fixed)
        self.edit()

    def status(self) -> list[Piece]:
        text = self.rviz.view.help if self._used else "RViz is ready."
        return [Piece(f" {text} ", self.look.colours.muted)]

    def status_right(self) -> list[Piece]:
        pieces = [Piece(f" {self.rviz.view.type} ", self.look.colours.node, self.next_view)]
        if self.rviz.quality.value != QUALITIES[0]:
            pieces.append(Piece(f"{self.rviz.quality.value} ", self.look.colours.topic, self.next_quality))
        if self._rate:
            pieces.append(Piece(f"{self._rate} fps ", self.look.colours.muted))
        return pieces

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y >= self.body_height:
            return self._words_line(y - self.body_height, width)
        if not self.lines:
            self.refresh_lines()
        self._lay_out()
        segments: list[Segment] = []
        if panel_width := self.panel_width:
            index = self.top + y
            if index < len(self.lines):
                focused = self.on_panel and self.has_focus
                segments += panel.segments_of(self.lines[index], panel_width, self.look, index == self.chosen, focused)
            else:
                segments.append(Segment(" " * panel_width, self.background))
            if panel_width < width:
                style = (
                    self.look.colours.frame_focus if self.has_focus and not self.on_panel else self.look.colours.frame
                )
                segments.append(Segment(self.look.glyphs.border.vertical, style))
        if self.view.columns:
            segments += self.view.line(y)
        return segments

    def _words_line(self, line: int, width: int) -> list[Segment]:
        colours = self.look.colours
        text = self.words[line] if line < len(self.words) else ""
        return [Segment(fit(f" {text}", width, self.look.glyphs.ellipsis), colours.muted)]

    # -- choosing and editing ------------------------------------------------------------------------------------------

    @property
    def prop(self) -> Property | None:
        """The chosen property."""
        return self.lines[self.chosen].prop if self.chosen < len(self.lines) else None

    def choose(self, prop: Property) -> None:
        """Open the tree down to a property and choose it."""
        above = prop.parent
        while above is not None:
            above.expanded = True
            above = above.parent
        self.refresh_lines()
        for index, line in enumerate(self.lines):
            if line.prop is prop:
                self.chosen = index
        self._keep_chosen_in_sight()
        self._words_at = -10.0
        self.touch()

    def chosen_display(self) -> Display | None:
        """The display that the chosen line belongs to."""
        prop = self.prop
        return self._display_of(prop) if prop is not None else None

    def _display_of(self, prop: Property) -> Display | None:
        each: Property | None = prop
        while each is not None and not isinstance(each, Display):
            each = each.parent
        return each

    def toggle(self, prop: Property) -> None:
        """Turn a check box over."""
        if not prop.read_only:
            self.set(prop, not prop.value)

    def set(self, prop: Property, value: Any) -> str | None:
        """Give a property a value; returns what is wrong with it."""
        try:
            self.rviz.edit(prop, value)
        except BadValue as error:
            return self.look.texts(error.key, **error.parameters)
        self.rviz.message = None
        self._words_at = -10.0
        self.look.wake()
        return None

    def edit(self) -> None:
        """Change the chosen property in the way that fits it."""
        prop = self.prop
        if prop is None:
            return
        if prop.kind == BOOL and not isinstance(prop, Display):
            self.toggle(prop)
        elif prop.kind in (GROUP, STATUS) or prop.read_only or isinstance(prop, Display):
            self.open_branch(prop, not prop.expanded)
        else:
            dialogs.edit(self, prop)

    def open_branch(self, prop: Property, on: bool) -> None:
        """Open or close a branch."""
        if prop.children:
            prop.expanded = on
            self.refresh_lines()
            self.look.wake()

    def open_overlay(self, overlay: Any) -> None:
        """Lay a dialog over the desktop."""
        stage: Any = self.parent
        stage.open_overlay(overlay)

    def request(self, action: Callable[[], object]) -> None:
        """Let the program do something."""
        self.rviz.message = None
        self.rviz.request(action)

    def next_view(self) -> None:
        names = list(VIEWS)
        name = names[(names.index(self.rviz.view.type) + 1) % len(names)]
        self.request(partial(self.rviz.set_view, name))

    def next_quality(self) -> None:
        name = QUALITIES[(QUALITIES.index(self.rviz.quality.value) + 1) % len(QUALITIES)]
        self.set(self.rviz.quality, name)
        self.say(self.look.texts("rviz.quality", name=name))


def in_ascii(text: str) -> str:
    """A sentence for a terminal that has no other characters."""
    for char, plain in (("×", "x"), ("⌀", "d "), ("°", " deg"), ("…", "...")):
        text = text.replace(char, plain)
    return text
