"""A Textual screen that can draw at the end of one of our frames, and then draws no more than what changed.

Textual passes what changed from each widget to its screen by messages, and draws at the next tick of a timer of its own: three
tasks and one more wake-up for each frame. It then asks every widget in the area for all of its lines and cuts each of them
wherever any widget begins. Here, what panes mark during a frame is drawn when the frame ends: for each changed span, the
widgets that are seen there are asked for that line. What of it differs from what the terminal shows is for `drawing`.

`tests/tui/textual_private/test_frame_screen.py` compares it cell by cell with Textual's own way.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from textual._compositor import ChopsUpdate, Compositor, CompositorUpdate
from textual.geometry import Region, Size
from textual.screen import Screen
from textual.widget import Widget

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderResult
    from textual.strip import Strip

Span = tuple[int, int, int]
"""Line, first column, end column."""

Seen = tuple[int, int, Widget, int, int]
"""A part of a line of the screen: first and end column, the widget seen there, and the widget's own corner."""


class SpansUpdate(CompositorUpdate):
    """What has changed, ready to be sent: the column and line of each strip."""

    def __init__(self, spans: Sequence[Span], strips: Sequence[tuple[int, int, Strip]]) -> None:
        self.spans = spans
        self.strips = strips

    def render_segments(self, console: Console) -> str:
        """The sequences for a terminal."""
        return "".join(f"\x1b[{y + 1};{x + 1}H{strip.render(console)}" for x, y, strip in self.strips)

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        for _, _, strip in self.strips:
            yield from strip


class SpansCompositor(Compositor):
    """Renders changed spans alone."""

    def __init__(self) -> None:
        super().__init__()
        self._seen: dict[int, list[Seen]] = {}
        self._seen_of: object = None
        """The widgets that this was worked out for."""

    def render_partial_update(self) -> ChopsUpdate | None:
        """What has changed since the last call, None if nothing has."""
        regions = self._dirty_regions.copy()
        self._dirty_regions.clear()
        whole = self.size.region
        visible = [each for each in (region.intersection(whole) for region in regions) if each]
        if not visible:
            return None
        spans = list(self._regions_to_spans(visible))
        lines = groupby(spans, key=itemgetter(0))
        strips = [strip for y, line in lines for strip in self._strips_of(y, [(first, end) for _, first, end in line])]
        return SpansUpdate(spans, strips)  # type: ignore[return-value]  # all that is done with it is done with both

    def _strips_of(self, y: int, spans: Sequence[tuple[int, int]]) -> Iterator[tuple[int, int, Strip]]:
        for left, right, widget, x, top in self._seen_in(y):
            if not any(left < end and first < right for first, end in spans):
                continue
            (strip,) = widget.render_lines(Region(left - x, y - top, right - left, 1))
            yield left, y, strip

    def _seen_in(self, y: int) -> list[Seen]:
        """Who is seen where in a line of the screen."""
        visible = self.visible_widgets
        if visible is not self._seen_of:
            self._seen_of, self._seen = visible, {}
        seen = self._seen.get(y)
        if seen is None:
            seen = self._seen[y] = list(_seen_in(y, self.size.width, visible.items()))
        return seen


def _seen_in(y: int, width: int, widgets: Iterable[tuple[Widget, tuple[Region, Region]]]) -> Iterator[Seen]:
    """Go through the widgets from the front to the back, each taking what is left of the line."""
    free = [(0, width)]
    for widget, (region, clip) in widgets:
        shown = region.intersection(clip)
        if not (shown.y <= y < shown.bottom) or not shown.width:
            continue
        left: list[tuple[int, int]] = []
        for first, end in free:
            a, b = max(first, shown.x), min(end, shown.right)
            if a >= b:
                left.append((first, end))
                continue
            yield a, b, widget, region.x, region.y
            left += [each for each in ((first, a), (b, end)) if each[0] < each[1]]
        free = left
        if not free:
            return


def covers_of(widget: Widget) -> list[Region]:
    """The parts of the terminal in which something else is in front of a widget: a neighbour, a notification, an overlay.

    The order is the compositor's own, by which the text is drawn.
    """
    screen, covers = widget.screen, []
    for other, (region, clip) in screen._compositor.visible_widgets.items():  # from the front to the back
        if other is widget:
            break
        covers.append(region.intersection(clip))
    stack = widget.app.screen_stack
    for above in stack[stack.index(screen) + 1 :]:
        front = above._compositor.visible_widgets.items()
        # Around what a modal screen shows, this one is seen.
        covers += [
            region.intersection(clip) for other, (region, clip) in front if other is not above or not above.is_modal
        ]
    return covers


class FrameScreen(Screen[Any]):
    """Between `begin_frame` and `end_frame` it gathers what its panes mark, and then draws it at once."""

    def __init__(self, *args: Any, **keywords: Any) -> None:
        super().__init__(*args, **keywords)
        self._in_frame = False
        self._compositor = SpansCompositor()

    def begin_frame(self) -> None:
        """From here to `end_frame` nothing of Textual runs."""
        self._in_frame = self.is_current and self.app.screen is self

    def mark(self, widget: Widget, regions: Iterable[Region]) -> bool:
        """Have these regions of a widget without borders drawn at the end of the frame; False outside frames."""
        if not self._in_frame:
            return False
        widget._repaint_regions.update(regions)
        self._dirty_widgets.add(widget)
        return True

    def end_frame(self) -> bool:
        """Draw what was marked; where Textual has to lay out or to repaint everything first, it draws that, too.

        Returns whether anything was.
        """
        if not self._in_frame:
            return False
        self._in_frame = False
        if not self._dirty_widgets and not self._compositor._dirty_regions:
            return False
        if self._layout_required or self._scroll_required or self._repaint_required or self.app._batch_count:
            self.check_idle()
            return True
        self._compositor.update_widgets(self._dirty_widgets)
        self._compositor_refresh()
        return True


class DeskScreen(FrameScreen):
    """Textual's screen, whose own background is never seen."""

    BLANK = True
    ALLOW_SELECT = False  # terminals have their own selection; Textual's fails on a widget that is just being removed

    def _refresh_layout(self, size: Size | None = None, scroll: bool = False) -> None:
        """Lay the panes out. Textual 8.2 then stops its timer, also when something else still waits for it."""
        super()._refresh_layout(size, scroll)
        self.check_idle()

    def _compositor_refresh(self) -> None:
        """Draw, or hand on what has changed to the modal screen through which it is seen.

        Textual 8.2 marks this screen as changed too in that case, and so would send the same picture again and again.
        """
        changed = self._compositor._dirty_regions
        if self.app.screen is self or not changed:
            super()._compositor_refresh()
            return
        self.app.screen.refresh(*changed)
        changed.clear()
        self._dirty_widgets.clear()
