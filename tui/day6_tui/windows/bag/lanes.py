"""The timeline of rqt_bag: the axis with the playhead and the selected region, and a line for each topic.

A line has a mark where messages are; a topic of images has a few lines, along which thumbnails lie.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style

from day6_core.elide import elide
from day6_core.ros.programs.rqt_bag.model.pictures import IMAGE
from day6_core.ros.programs.rqt_bag.model.view import TimeSpan, divisions
from day6_core.session.harmless import one_line
from day6_tui.appearance.colours import background_of, pixel_style
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit
from day6_tui.windows.bag.cells import COLOURS, OTHERS, Cell, bars_of, runs, short
from day6_tui.windows.bag.picture import Paintings

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_bag.model.bags import Bags

HEAD = 2
"""Lines above the topics: labels and the ruler, in which a region is selected."""

ABOUT_WIDTHS = {160: 60, 100: 40, 0: 0}
"""Cells of the columns for count, rate and type, by the least width of the window; the first ones have room for packages."""

LABEL_ROOM = 7
"""Cells from one label of the time axis to the next, at least."""

TICK = 4
"""Cells of a topic's check box."""

PLAYHEAD = (0xFF5555, 0xCC0000)

THUMB_COLUMNS, THUMB_LINES = 10, 4
"""Cells of a thumbnail, which has a blank column behind it."""


class LanePlace(NamedTuple):
    """Where things are inside: widths of names, timeline and what is right of it, lines of topics, and of what is below them."""

    names: int
    columns: int
    about: int
    rows: int
    told: int
    panel: int

    @property
    def bottom(self) -> int:
        """The first line below the topics."""
        return HEAD + self.rows

    @property
    def panel_top(self) -> int:
        return self.bottom + self.told

    @property
    def left(self) -> int:
        return self.names + 1


class BagLanes:
    """Keeps which topic is chosen, and from which on they are seen."""

    def __init__(self, look: Look, model: Bags, paintings: Paintings) -> None:
        self._look = look
        self._model = model
        self._paintings = paintings
        self._chosen = self._first = 0
        self._named: tuple[dict[str, str], list[str], int] = ({}, [], 8)
        self._counted: tuple[object, ...] = ()
        """What `_marks` were counted for."""
        self._marks: dict[str, list[str]] = {}

    # -- topics --------------------------------------------------------------------------------------------------------

    def _names(self) -> tuple[list[str], int]:
        """The topics, and the width of the longest; made anew only when they have changed."""
        if self._named[0] is not self._model.topics:
            topics = self._model.topics
            self._named = (topics, list(topics), max(map(cell_len, topics), default=8))
        return self._named[1:]

    @property
    def topics(self) -> list[str]:
        return self._names()[0]

    @property
    def index(self) -> int:
        return self._chosen

    @property
    def chosen(self) -> str:
        """The topic that keys mean, '' without any."""
        topics = self.topics
        return topics[min(self._chosen, len(topics) - 1)] if topics else ""

    def choose(self, index: int) -> None:
        """Choose a topic, the last one for a higher number."""
        self._chosen = max(0, min(len(self.topics) - 1, index))

    def forget(self) -> None:
        """Other bags are on the timeline: nothing of how the last ones were seen is of use."""
        self._chosen = self._first = 0
        self._counted = ()

    def restyle(self) -> None:
        """Colours or glyphs have changed."""
        self._counted = ()
        self._paintings.forget()

    # -- places --------------------------------------------------------------------------------------------------------

    def place(self, width: int, height: int, *, told: int, least_panel: int) -> LanePlace:
        """Where things are in a window: below the topics so many lines are told, and there is a panel (0 lines: none) with more
        lines where there is room."""
        names = min(self._names()[1] + TICK, max(14, width * 2 // 5))
        about = next(about for least, about in ABOUT_WIDTHS.items() if width >= least)
        rows = max(1, height - HEAD - told)
        panel = 0
        if least_panel:
            needed = sum(map(self._height, range(len(self.topics))))
            panel = rows - max(1, min(needed, rows - max(least_panel, height // 2)))
        return LanePlace(names, max(1, width - names - 1 - about), about, rows - panel, told, panel)

    def _height(self, index: int) -> int:
        """Lines of a topic."""
        return THUMB_LINES if self._model.thumbnails and self._model.topics.get(self.topics[index]) == IMAGE else 1

    def rows(self, place: LanePlace) -> list[tuple[int, int]]:
        """The topics in sight, each line with the index of its topic and which of its lines it is."""
        count = len(self.topics)
        self._first = max(0, min(self._first, self._chosen, count - 1))
        while sum(map(self._height, range(self._first, min(self._chosen + 1, count)))) > max(
            place.rows, self._height(self._chosen) if self._chosen < count else 1
        ):
            self._first += 1
        lines = [(index, part) for index in range(self._first, count) for part in range(self._height(index))]
        return lines[: place.rows]

    # -- marks ---------------------------------------------------------------------------------------------------------

    def recount(self, view: TimeSpan, place: LanePlace) -> bool:
        """Forget the marks if something has changed; whether it has."""
        counted = (self._model.timeline.version, view, place.columns, self._look.glyphs.bars)
        if counted == self._counted:
            return False
        self._counted = counted
        self._marks = {}
        return True

    def _marks_of(self, topic: str, view: TimeSpan, place: LanePlace) -> list[str]:
        """A mark for each column with messages of a topic."""
        found = self._marks.get(topic)
        if found is None:
            counts = self._model.timeline.columns(topic, view.left, view.right, place.columns)
            found = self._marks[topic] = bars_of(counts, self._look.glyphs.bars)
        return found

    # -- lines ---------------------------------------------------------------------------------------------------------

    def labels(self, view: TimeSpan, place: LanePlace) -> list[Segment]:
        cells = [" "] * (place.left + place.columns)
        for column, text in divisions(view, self._model.timeline.start_ns or 0, place.columns, LABEL_ROOM):
            if column >= 0 and column + len(text) <= place.columns:
                cells[place.left + column : place.left + column + len(text)] = text
        return [Segment("".join(cells), self._look.colours.muted)]

    def ruler(self, view: TimeSpan, place: LanePlace) -> list[Segment]:
        """The axis, with the selected region and the playhead."""
        colours, unicode, player = self._look.colours, self._look.glyphs.unicode, self._model.player
        start = self._model.timeline.start_ns or 0
        ticks = {column for column, _ in divisions(view, start, place.columns, LABEL_ROOM)}
        line, tick, pointer = ("─", "┬", "▼") if unicode else ("-", "+", "v")
        region = player.region
        ends = [view.column_of(each, place.columns) for each in region] if region is not None else None
        at = view.column_of(player.now(), place.columns)
        cells: list[Cell] = []
        for column in range(place.columns):
            selected = ends is not None and ends[0] <= column <= ends[1]
            char = "=" if selected and not unicode else tick if column in ticks else line
            cells.append((char, colours.selection if selected else colours.frame))
        if 0 <= at < place.columns:
            cells[at] = (pointer, cells[at][1] if ends and ends[0] <= at <= ends[1] else self._colour(PLAYHEAD))
        return [Segment(" " * place.left, colours.text), *runs(cells)]

    def line(self, index: int, part: int, view: TimeSpan, place: LanePlace, *, focused: bool) -> list[Segment]:
        """One line of a topic."""
        colours, glyphs, model = self._look.colours, self._look.glyphs, self._model
        topic = self.topics[index]
        marks = self._marks_of(topic, view, place)
        style = self._colour(COLOURS.get(model.topics[topic], OTHERS))
        if self._height(index) > 1:
            cells = self._thumbnails(topic, part, marks, view, place)
        else:
            cells = [(mark, style) for mark in marks]
        at = view.column_of(model.player.now(), place.columns)
        if 0 <= at < len(cells):
            cells[at] = ("│" if glyphs.unicode else "|", self._colour(PLAYHEAD))
        if part:
            return [Segment(" " * place.left, colours.text), *runs(cells)]
        publishes = topic in model.player.publishing
        room = place.names - TICK
        segments = [
            Segment("[x] " if publishes else "[ ] ", colours.publisher if publishes else colours.muted),
            Segment(
                fit(elide(one_line(topic), room, glyphs.ellipsis), room, glyphs.ellipsis),
                (colours.choice if focused else colours.strong) if index == self._chosen else colours.topic,
            ),
            Segment(" ", colours.text),
            *runs(cells),
        ]
        if place.about:
            kind = short(model.topics[topic])
            kind = kind if place.about == max(ABOUT_WIDTHS.values()) else kind.rpartition("/")[2]
            about = f" {model.timeline.count(topic):>9} {self.rate(topic):>10}  {kind}"
            segments.append(Segment(fit(about, place.about, glyphs.ellipsis), colours.muted))
        return segments

    def _thumbnails(self, topic: str, part: int, marks: Sequence[str], view: TimeSpan, place: LanePlace) -> list[Cell]:
        """One line of the thumbnails beside each other, each of what is there at its left edge."""
        cells: list[Cell] = [(" ", self._look.colours.text)] * place.columns
        for column in range(0, place.columns - THUMB_COLUMNS + 1, THUMB_COLUMNS + 1):
            if not any(mark != " " for mark in marks[column : column + THUMB_COLUMNS]):
                continue  # no message belongs to it
            moment = view.time_at(column + THUMB_COLUMNS - 1, place.columns)
            lines = self._paintings.of(self._model.thumbnail(topic, moment, THUMB_COLUMNS, 2 * THUMB_LINES))
            if part < len(lines):
                cells[column : column + len(lines[part])] = lines[part]
        return cells

    def rate(self, topic: str) -> str:
        """Messages per second of a topic, '' where that says nothing."""
        rate = self._model.rates.get(topic)
        return "" if rate is None else f"{rate:.3g} Hz" if rate < 1000 else f"{rate:.0f} Hz"

    def _colour(self, pair: tuple[int, int]) -> Style:
        colours = self._look.colours
        if colours.colourless:
            return colours.strong
        return pixel_style(pair[0] if colours.dark else pair[1], background_of(colours.text))
