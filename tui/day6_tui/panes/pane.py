"""A framed rectangle of the desktop that draws itself line by line.

The pane draws its own frame, which carries the tabs and the title above and the status below. Lines are kept as strips
until they are touched: a frame in which nothing changed costs nothing, and a moving turtle costs its own lines.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.color import BLACK
from textual.geometry import Region, Size
from textual.message import Message
from textual.strip import Strip
from textual.widget import Widget

from day6_tui.appearance.characters import showable
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, harmless
from day6_tui.textual_private.frame_screen import FrameScreen
from day6_tui.textual_private.survival import Surviving

Action = Callable[[], object]


class Piece(NamedTuple):
    """A run of text on a frame or bar; a click on it calls `action`."""

    text: str
    style: Style
    action: Action | None = None


class PaneStacks:
    """What lays panes out: knows which of them share a place."""

    @abstractmethod
    def tabs(self, pane: Pane, room: int) -> list[Piece]:
        """The names of the panes that share a place with `pane`, its own among them, in at most `room` cells."""

    def more(self, pane: Pane) -> list[Piece]:
        """How to reach the panes that are not named anywhere."""
        return []


class PaneMessage(Message):
    """Base of what a pane tells."""

    def __init__(self, pane: Pane) -> None:
        super().__init__()
        self.pane = pane

    @property
    def control(self) -> Pane:
        return self.pane


class Pane(Surviving, Widget, can_focus=True):
    """Base of everything framed. A subclass defines `content_line` and, as needed, title, status, keys and `pull`."""

    DEFAULT_CSS = "Pane { width: 1fr; height: 1fr; }"

    help_key = "desk"
    """The help page (`help.<key>` of the catalogue) that F1 opens when this pane has the focus."""

    framed = True

    takes_text = False
    """Whether letters are typed into it rather than being keys."""

    keeps_focus = False
    """Whether a terminal that opens by itself leaves it the keyboard."""

    inherits = True
    """Whether it gets the keyboard of a pane that has gone, where there is another one too."""

    key_weight = 2
    """The weight on the key line of its keys after the first one: F2, F4 and F8 are needed more, and buttons for the mouse."""

    slot = 0
    """Its number on the desktop, by which keys and lists name it; 0 where panes have none."""

    class Enlarged(PaneMessage):
        """The user wants this pane to fill the desktop, or to be put back."""

    def __init__(self, look: Look, *, id: str | None = None) -> None:  # noqa: A002 - Textual's name
        super().__init__(id=id)
        self.look = look
        self._strips: dict[int, Strip] = {}
        self.extent = Size(0, 0)
        """The size with the frame, as of the last `measure`."""
        self._hits: dict[int, list[tuple[int, int, Action]]] = {}
        self._shown_title: list[tuple[str, Style]] = []

    # -- for subclasses ------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        """Its name on frames and in lists."""
        return ""

    @property
    def unclear(self) -> str:
        """The message in it that is chosen and that F1 may explain; '' for none. (Terminals are asked otherwise.)"""
        return ""

    @property
    def has_news(self) -> bool:
        """Whether it has something that was not on the screen yet."""
        return False

    def close(self) -> None:
        """Close it at the user's request; one that would lose something asks first."""

    def title(self) -> list[Piece]:
        """The pieces on the upper edge, from the left: the tabs of its place."""
        right = sum(cell_len(piece.text) for piece in self.title_right())
        return self.host.tabs(self, self.inner_width - right) if self.host is not None else []

    def title_right(self) -> list[Piece]:
        """The pieces on the upper edge, from the right, which are always there."""
        if self.host is None:
            return []
        return [*self.host.more(self), Piece(f" {self.look.glyphs.close} ", self.look.colours.title, self.close)]

    @property
    def host(self) -> PaneStacks | None:
        """What lays the panes out."""
        return self.parent if isinstance(self.parent, PaneStacks) else None

    def status(self) -> list[Piece]:
        """The pieces on the lower edge, from the left."""
        return []

    def status_right(self) -> list[Piece]:
        return []

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        """The segments of line `y` of the inside; shorter than `width` is filled up."""
        return ()

    @property
    def focus_target(self) -> Widget:
        """The widget that takes the keys when the pane gets the keyboard."""
        return self

    def pull(self, now: float) -> bool:
        """Read the model and touch what changed; `now` is the monotonic time. Return True to request another frame."""
        return False

    def pull_title(self) -> None:
        """Draw the upper edge anew if its tabs have changed."""
        title = [(piece.text, piece.style) for piece in (*self.title(), *self.title_right())]
        if title != self._shown_title:
            self._shown_title = title
            self.touch_frame()

    def key_hints(self) -> list[tuple[str, str]]:
        """Keys of this pane for the key bar while it is focused: (key, what it does)."""
        return []

    def more_key_hints(self) -> list[tuple[str, str]]:
        """Keys that only the help page names."""
        return []

    @property
    def background(self) -> Style:
        """The style of empty cells inside."""
        return self.look.colours.text

    # -- geometry ------------------------------------------------------------------------------------------------------

    @property
    def inner_width(self) -> int:
        return max(0, self.extent.width - 2) if self.framed else self.extent.width

    @property
    def inner_height(self) -> int:
        return max(0, self.extent.height - 2) if self.framed else self.extent.height

    @property
    def inner_offset(self) -> int:
        return 1 if self.framed else 0

    # -- touching ------------------------------------------------------------------------------------------------------

    def is_inside(self, event: events.MouseEvent) -> bool:
        """Whether the mouse is on the content, not on the frame."""
        at = self.inner_offset
        return at <= event.x < at + self.inner_width and at <= event.y < at + self.inner_height

    def measure(self) -> bool:
        """Read the current size; return True if it changed and everything has to be drawn again."""
        size = self.outer_size
        if size == self.extent:
            return False
        self.extent = size
        self._strips.clear()
        self._hits.clear()
        return True

    def touch(self) -> None:
        """Draw everything again.

        What is clickable stays as shown until then: pressing a mouse button may focus the pane, and so touch it, before the
        button is released.
        """
        self._strips.clear()
        self.refresh()

    def restyle(self) -> None:
        """Colours, characters or language changed. A subclass drops here what it built with the old ones."""
        self.touch()

    def touch_lines(self, lines: Iterable[int]) -> None:
        """Compare these inner lines with what is shown and draw again those that differ."""
        offset, height = self.inner_offset, self.inner_height
        self._compare(line + offset for line in lines if 0 <= line < height)

    def redraw_lines(self, lines: Iterable[int], *, across: range | None = None) -> None:
        """Draw these inner lines again, which are known to differ from what is shown; with `across` in those columns only.

        Other widgets in these lines are drawn, too: `across` leaves them alone.
        """
        at = self.inner_offset
        rows = [line + at for line in lines if 0 <= line < self.inner_height]
        for y in rows:
            self._strips.pop(y, None)
        self._mark(rows, None if across is None else range(across.start + at, across.stop + at))

    def touch_frame(self) -> None:
        """Title and status may look different now."""
        if self.framed and self.extent.height > 1:
            self._compare((0, self.extent.height - 1))

    def touch_status(self) -> None:
        """The status may look different now: unlike the upper edge, with all its tabs, it often does."""
        if self.framed and self.extent.height > 1:
            self._compare((self.extent.height - 1,))

    def _compare(self, rows: Iterable[int]) -> None:
        """Have the rows of the pane drawn that differ from the strips shown; `screen.shown` finds out which of their cells do."""
        changed = []
        for y in rows:
            old = self._strips.get(y)
            new = self._strips[y] = self._make_strip(y)
            if new != old:
                changed.append(y)
        self._mark(changed)

    def _mark(self, rows: list[int], across: range | None = None) -> None:
        """Have these rows of the pane drawn: at the end of the frame in which they changed, else when Textual comes to it."""
        if not rows:
            return
        across = across or range(self.extent.width)
        regions = [Region(across.start, y, len(across), 1) for y in rows]
        screen = self.screen if self.is_mounted else None
        if not (isinstance(screen, FrameScreen) and screen.mark(self, regions)):
            self.refresh(*regions)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def render_lines(self, crop: Region) -> list[Strip]:
        # Not through Textual's styles cache: these lines are finished, with frame and colours, and cached here.
        # The first picture after a resize comes before the Resize event is handled.
        self.measure()
        left, right = crop.x, crop.right
        whole = left == 0 and right == self.extent.width
        lines = [self._strip(y) for y in range(crop.y, crop.bottom)]
        return lines if whole else [line.crop(left, right) for line in lines]

    def _strip(self, y: int) -> Strip:
        strip = self._strips.get(y)
        if strip is None:
            strip = self._strips[y] = self._make_strip(y)
        return strip

    def _make_strip(self, y: int) -> Strip:
        width, height = self.extent
        if not self.framed:
            strip = Strip(self._inside(y, width), width)
        elif y == 0:
            strip = self._edge(0, self.title(), self.title_right())
        elif y == height - 1:
            strip = self._edge(y, self.status(), self.status_right())
        else:
            border, style = self._border()
            self._hits.pop(y, None)
            side = Segment(border.vertical, style)
            strip = Strip([side, *self._inside(y - 1, width - 2), side], width)
        strip = showable(strip, self.look)
        for each in self.look.filters:
            strip = strip.apply_filter(each, BLACK)
        return strip

    def _inside(self, y: int, width: int) -> list[Segment]:
        """Line `y` of the inside, as long as it has to be: no strip yet, of which each costs as much as its segments."""
        return Segment.adjust_line_length(list(harmless(self.content_line(y, width))), width, self.background)

    def _border(self) -> tuple:  # type: ignore[type-arg]
        glyphs, colours = self.look.glyphs, self.look.colours
        if self.has_focus_within:  # an editor's text has it, not the pane itself
            return glyphs.strong_border, colours.frame_focus
        return glyphs.border, colours.frame

    def _edge(self, y: int, left: Sequence[Piece], right: Sequence[Piece]) -> Strip:
        """The upper or lower edge of the frame with pieces set into it.

        When room is short, the left ones are cut on the upper edge, which ends with the cross; below, the right ones go first.
        """
        border, style = self._border()
        width = self.extent.width
        start, end = (border.top_left, border.top_right) if y == 0 else (border.bottom_left, border.bottom_right)
        room = width - 2
        left_width = sum(cell_len(piece.text) for piece in left)
        right_width = sum(cell_len(piece.text) for piece in right)
        if left_width + right_width + 2 > room and (y or right_width + 4 > room):
            right, right_width = (), 0
        hits: list[tuple[int, int, Action]] = []
        segments = [Segment(start, style)]
        x = 1
        for piece in left:
            text = clip(piece.text, room - right_width - (x - 1), self.look.glyphs.ellipsis)
            if not text:
                break
            size = cell_len(text)
            if piece.action is not None:
                hits.append((x, x + size, piece.action))
            segments.append(Segment(text, piece.style))
            x += size
        segments.append(Segment(border.horizontal * (width - 1 - right_width - x), style))
        x = width - 1 - right_width
        for piece in right:
            size = cell_len(piece.text)
            if piece.action is not None:
                hits.append((x, x + size, piece.action))
            segments.append(Segment(piece.text, piece.style))
            x += size
        segments.append(Segment(end, style))
        self._hits[y] = hits
        return Strip(harmless(segments))

    # -- events --------------------------------------------------------------------------------------------------------

    def hit(self, x: int, y: int) -> Action | None:
        """Return the action of the piece at this cell of the pane, if there is one."""
        for first, end, action in self._hits.get(y, ()):
            if first <= x < end:
                return action
        return None

    def add_hit(self, y: int, first: int, end: int, action: Action) -> None:
        """Make cells of the line being drawn (counted with the frame) clickable."""
        self._hits.setdefault(y, []).append((first, end, action))

    def on_click(self, event: events.Click) -> None:
        if event.screen_offset - self.region.offset != event.offset:
            return  # a widget inside let it pass, counted from its own corner
        if event.chain % 2 == 0 and event.y == 0 and self.framed and event.x < self.extent.width - 5:
            event.stop()
            event.prevent_default()
            self.post_message(self.Enlarged(self))
            return
        action = self.hit(event.x, event.y)
        if action is not None:
            event.stop()
            event.prevent_default()  # Textual calls this once more for a subclass that has called it itself
            action()

    def on_resize(self, event: events.Resize) -> None:
        self.measure()
        self._strips.clear()
        self._hits.clear()
        self.look.wake()

    def on_focus(self, event: events.Focus) -> None:
        self.touch()

    def on_blur(self, event: events.Blur) -> None:
        self.touch()

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        self.touch()  # the frame is a pane's that has the keyboard, although a widget inside has it

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        self.touch()
