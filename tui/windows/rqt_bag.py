"""rqt_bag's window: a line for each topic with a mark where messages are, the playhead across them, a time axis above."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_tui.core.elide import elide
from day6_tui.core.ros.programs.rqt_bag.model.pictures import IMAGE, Picture
from day6_tui.core.ros.programs.rqt_bag.model.playhead import faster, slower, speed_text
from day6_tui.core.ros.programs.rqt_bag.model.view import (
    NANOSECONDS,
    PAN,
    WHEEL_IN,
    WHEEL_OUT,
    ZOOM_IN,
    ZOOM_OUT,
    View,
    divisions,
    size_text,
    whole,
)
from day6_tui.core.session.display import Window
from day6_tui.core.session.harmless import one_line
from day6_tui.tui.cells import cell_len, clip, fit
from day6_tui.tui.colours import background_of, pixel_style
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.bag_cells import COLOURS, OTHERS, Cell, bars_of, date, runs, short
from day6_tui.tui.windows.bag_message import MessageTree
from day6_tui.tui.windows.bag_picture import paint
from day6_tui.tui.windows.bag_questions import Questions
from day6_tui.tui.windows.bag_topics import TopicChoice

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rqt_bag.model.bags import Bags

HEAD = 2
"""Lines above the topics: labels and the ruler, in which a region is selected."""

WIDE = 100
"""From this width on there are columns for count, rate and type."""

ABOUT_WIDTH = 34
LABEL_ROOM = 7
"""Cells from one label of the time axis to the next, at least."""

PLAYHEAD = (0xFF5555, 0xCC0000)


THUMB_COLUMNS, THUMB_LINES = 10, 4
"""Cells of a thumbnail, which has a blank column behind it."""

MOST_PAINTED = 64
"""Images that are kept painted."""

LEAST_PANEL = 3
"""Lines of a message or an image below the timeline."""


class _Place(NamedTuple):
    """Where things are inside: widths of names and of the timeline, lines of topics, and of what is below them."""

    names: int
    columns: int
    rows: int
    panel: int

    @property
    def left(self) -> int:
        return self.names + 1


class RqtBagPane(WindowPane["Bags"]):
    """Draws the timeline of `Bags`; keeps what part of it is seen, and which topic is chosen."""

    def __init__(self, window: Window[Bags], look: Look) -> None:
        super().__init__(window, look)
        self._named: tuple[dict[str, str], list[str], int] = ({}, [], 8)
        self._timeline = window.model.timeline
        self.view: View | None = None
        self._fits = True
        """Whether everything is to be seen, however the bags grow."""
        self._chosen = self._first = 0
        self._drawn: tuple[object, ...] = ()
        self._counted: tuple[object, ...] = ()
        """What `_marks` were counted for."""
        self._marks: dict[str, list[str]] = {}
        self._seen: tuple[object, ...] = ()
        self._followed = 0
        """Where the playhead was when the view last followed it."""
        self._drag = ""
        self._dragged_from = 0
        self._questions = Questions(self)
        self.choice: TopicChoice | None = None
        """The list of topics that lies over the timeline while some are chosen."""
        self._tree: MessageTree | None = None
        """The message that is shown below the timeline."""
        self._in_panel = False
        """Whether keys go to what is below the timeline."""
        self._thumbnails = False
        self._cells: dict[int, tuple[Picture, list[list[Cell]]]] = {}
        """Painted images by the identity of the image, which is kept with them."""

    # -- places --------------------------------------------------------------------------------------------------------

    def _names(self) -> tuple[list[str], int]:
        """The topics, and the width of the longest; made anew only when they have changed."""
        if self._named[0] is not self.model.topics:
            topics = self.model.topics
            self._named = (topics, list(topics), max(map(cell_len, topics), default=8))
        return self._named[1:]

    @property
    def topics(self) -> list[str]:
        return self._names()[0]

    @property
    def chosen(self) -> str:
        """The topic that keys mean, '' without any."""
        topics = self.topics
        return topics[min(self._chosen, len(topics) - 1)] if topics else ""

    def _place(self) -> _Place:
        width = self.inner_width
        names = min(self._names()[1] + 4, max(14, width * 2 // 5))
        about = ABOUT_WIDTH if width >= WIDE else 0
        rows = max(1, self.inner_height - HEAD - 1)
        panel = 0
        if self._tree is not None:
            needed = sum(map(self._height, range(len(self.model.topics))))
            panel = rows - max(1, min(needed, rows - max(LEAST_PANEL, self.inner_height // 2)))
        return _Place(names, max(1, width - names - 1 - about), rows - panel, panel)

    def _height(self, index: int) -> int:
        """Lines of a topic."""
        return THUMB_LINES if self._thumbnails and self.model.topics.get(self.topics[index]) == IMAGE else 1

    def _rows(self, place: _Place) -> list[tuple[int, int]]:
        """The topics in sight, each line with the index of its topic and which of its lines it is."""
        count = len(self.model.topics)
        self._first = max(0, min(self._first, self._chosen, count - 1))
        while sum(map(self._height, range(self._first, min(self._chosen + 1, count)))) > max(
            place.rows, self._height(self._chosen) if self._chosen < count else 1
        ):
            self._first += 1
        lines = [(index, part) for index in range(self._first, count) for part in range(self._height(index))]
        return lines[: place.rows]

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        model, timeline = self.model, self.model.timeline
        if timeline is not self._timeline:
            self._begin_anew()
        moves = bool(model.player.playhead.speed) or model.loading or model.recorder is not None
        if timeline.start_ns is not None and timeline.end_ns is not None:
            if self.view is None or self._fits:
                self.view = whole(timeline.start_ns, timeline.end_ns)
            self._follow(model.player.now())
        place = self._place()
        if self._tree is not None:
            self._tree.take(model.shown(self._tree.topic))
        state = (model.version, self.view, self._playhead_column(place), self._chosen, place, self._time_text())
        if state == self._drawn:
            return moves
        self._drawn = state
        self._look(place)
        self.touch_lines(range(self.inner_height))
        self.touch_frame()
        return moves

    def _begin_anew(self) -> None:
        """Other bags are on the timeline: nothing of how the last ones were seen is of use."""
        self._timeline, self.view, self._fits, self._tree, self._in_panel = self.model.timeline, None, True, None, False
        self._chosen = self._first = 0
        self._counted = ()

    def _follow(self, playhead: int) -> None:
        """When the playhead leaves what is seen, the view goes with it."""
        timeline = self.model.timeline
        if playhead != self._followed and self.view is not None and not self._drag:
            self._followed = playhead
            moved = self.view.following(playhead, timeline.start_ns or 0, timeline.end_ns or 0)
            if moved != self.view:
                self.view, self._fits = moved, False

    def _look(self, place: _Place) -> None:
        """Forget the marks if something has changed, and have single messages looked up."""
        model, view = self.model, self.view
        counted = (model.timeline.version, view, place.columns, self.look.glyphs.bars)
        if view is None or counted == self._counted:
            return
        self._counted = counted
        self._marks = {}
        if self._seen != (view, model.timeline.blocks):
            self._seen = (view, model.timeline.blocks)
            model.see(view.left, view.right)

    def _marks_of(self, topic: str, place: _Place) -> list[str]:
        """A mark for each column with messages of a topic."""
        assert self.view is not None
        found = self._marks.get(topic)
        if found is None:
            counts = self.model.timeline.columns(topic, self.view.left, self.view.right, place.columns)
            found = self._marks[topic] = bars_of(counts, self.look.glyphs.bars)
        return found

    def _playhead_column(self, place: _Place) -> int:
        return -1 if self.view is None else self.view.column_of(self.model.player.now(), place.columns)

    def restyle(self) -> None:
        self._counted = self._drawn = ()
        self._cells.clear()
        super().restyle()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._drawn = ()

    # -- lines ---------------------------------------------------------------------------------------------------------

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        place = self._place()
        if self.choice is not None:
            return self.choice.line(y, width, self.inner_height)
        if self.view is None:
            return self._empty_line(y, width)
        self._look(place)
        if y == 0:
            return self._labels(place)
        if y == 1:
            return self._ruler(place)
        if y < HEAD + place.rows:
            rows = self._rows(place)
            return self._topic_line(*rows[y - HEAD], place) if y - HEAD < len(rows) else ()
        if y == HEAD + place.rows:
            return self._about_line(width)
        return self._panel_line(y - HEAD - place.rows - 1, width, place.panel)

    def _panel_line(self, y: int, width: int, height: int) -> list[Segment]:
        """What is below the timeline: the image at the playhead, or the message."""
        tree, model = self._tree, self.model
        if tree is None or y >= height:
            return []
        shown = model.shown(tree.topic)
        if shown is None:
            return (
                [Segment(" " + clip(self.look.texts("bag.no_message"), width - 1), self.look.colours.muted)]
                if not y
                else []
            )
        if shown.problem:
            return [Segment(" " + clip(one_line(shown.problem), width - 1), self.look.colours.warning)] if not y else []
        if shown.type == IMAGE and not self._in_panel:
            found = model.thumbnail(tree.topic, shown.time_ns, width - 2, 2 * height)
            lines = self._painted(found)
            return [Segment(" ", self.background), *runs(lines[y])] if y < len(lines) else []
        return tree.line(y, width, height, focused=self._in_panel and self.has_focus)

    def _painted(self, found: Picture | None) -> list[list[Cell]]:
        """The cells of an image; those of the last ones are kept."""
        if found is None:
            return []
        if id(found) not in self._cells:
            if len(self._cells) >= MOST_PAINTED:
                self._cells.pop(next(iter(self._cells)))
            self._cells[id(found)] = (found, paint(found, self.look))
        return self._cells[id(found)][1]

    def _empty_line(self, y: int, width: int) -> list[Segment]:
        model, colours, texts = self.model, self.look.colours, self.look.texts
        if y == 1 and self.model.recorder is not None:
            return [Segment(" " + self._recording_text(), colours.warning)]
        if y == 1 and model.status:
            return [Segment(" " + clip(model.status, width - 1), colours.warning if model.failed else colours.muted)]
        return [Segment(" " + clip(texts("bag.none"), width - 1), colours.muted)] if y == 3 else []

    def _labels(self, place: _Place) -> list[Segment]:
        assert self.view is not None
        cells = [" "] * (place.left + place.columns)
        for column, text in divisions(self.view, self.model.timeline.start_ns or 0, place.columns, LABEL_ROOM):
            if column >= 0 and column + len(text) <= place.columns:
                cells[place.left + column : place.left + column + len(text)] = text
        return [Segment("".join(cells), self.look.colours.muted)]

    def _ruler(self, place: _Place) -> list[Segment]:
        assert self.view is not None
        colours, unicode = self.look.colours, self.look.glyphs.unicode
        ticks = {
            column for column, _ in divisions(self.view, self.model.timeline.start_ns or 0, place.columns, LABEL_ROOM)
        }
        line, tick, pointer = ("─", "┬", "▼") if unicode else ("-", "+", "v")
        region = self.model.player.region
        ends = [self.view.column_of(each, place.columns) for each in region] if region is not None else None
        at = self._playhead_column(place)
        cells: list[tuple[str, Style]] = []
        for column in range(place.columns):
            selected = ends is not None and ends[0] <= column <= ends[1]
            char = "=" if selected and not unicode else tick if column in ticks else line
            cells.append((char, colours.selection if selected else colours.frame))
        if 0 <= at < place.columns:
            cells[at] = (pointer, cells[at][1] if ends and ends[0] <= at <= ends[1] else self._colour(PLAYHEAD))
        return [Segment(" " * place.left, self.background), *runs(cells)]

    def _topic_line(self, index: int, part: int, place: _Place) -> list[Segment]:
        colours, glyphs = self.look.colours, self.look.glyphs
        at = self._playhead_column(place)
        topic = self.topics[index]
        on = index == self._chosen
        publishes = topic in self.model.player.publishing
        name = fit(elide(one_line(topic), place.names - 4, glyphs.ellipsis), place.names - 4, glyphs.ellipsis)
        style = self._colour(COLOURS.get(self.model.topics[topic], OTHERS))
        marks = self._marks_of(topic, place)
        cells = [(mark, style) for mark in marks]
        if self._height(index) > 1:
            cells = self._thumbnail_cells(topic, part, place, marks)
        if 0 <= at < len(cells):
            cells[at] = ("│" if glyphs.unicode else "|", self._colour(PLAYHEAD))
        if part:
            return [Segment(" " * place.left, self.background), *runs(cells)]
        segments = [
            Segment("[x] " if publishes else "[ ] ", colours.publisher if publishes else colours.muted),
            Segment(name, (colours.choice if self.has_focus else colours.strong) if on else colours.topic),
            Segment(" ", self.background),
            *runs(cells),
        ]
        if self.inner_width >= WIDE:
            about = f" {self.model.timeline.count(topic):>9} {self._rate(topic):>10}  {short(self.model.topics[topic])}"
            segments.append(Segment(fit(about, ABOUT_WIDTH, glyphs.ellipsis), colours.muted))
        return segments

    def _thumbnail_cells(self, topic: str, part: int, place: _Place, marks: Sequence[str]) -> list[Cell]:
        """One line of the thumbnails beside each other, each of what is there at its left edge."""
        assert self.view is not None
        cells: list[Cell] = [(" ", self.background)] * place.columns
        for column in range(0, place.columns - THUMB_COLUMNS + 1, THUMB_COLUMNS + 1):
            if not any(mark != " " for mark in marks[column : column + THUMB_COLUMNS]):
                continue  # no message belongs to it
            moment = self.view.time_at(column + THUMB_COLUMNS - 1, place.columns)
            lines = self._painted(self.model.thumbnail(topic, moment, THUMB_COLUMNS, 2 * THUMB_LINES))
            if part < len(lines):
                cells[column : column + len(lines[part])] = lines[part]
        return cells

    def _recording_text(self) -> str:
        recorder = self.model.recorder
        if recorder is None:
            return ""
        key = "bag.recording_paused" if recorder.paused else "bag.recording"
        return self.look.texts(key, count=recorder.messages, size=size_text(recorder.size))

    def _about_line(self, width: int) -> list[Segment]:
        """What went wrong, or what the chosen topic is."""
        model, colours, ellipsis = self.model, self.look.colours, self.look.glyphs.ellipsis
        exporting = f"{model.exporting_to}  {model.exporting} %" if model.exporting is not None else ""
        loading = f"{model.status} {model.indexed} %" if model.indexed is not None else ""
        text = self._recording_text() or exporting or loading or model.status or model.player.problem
        if text:
            failed = bool(model.recorder) or (not exporting and (model.failed or not model.status))
            return [
                Segment(" " + clip(one_line(text), width - 1, ellipsis), colours.warning if failed else colours.muted)
            ]
        topic = self.chosen
        if not topic:
            return []
        count = self.look.texts("bag.messages", count=model.timeline.count(topic))
        return [
            Segment(
                " " + clip(f"{model.topics[topic]}  {count}  {self._rate(topic)}", width - 1, ellipsis), colours.muted
            )
        ]

    def _rate(self, topic: str) -> str:
        rate = self.model.rates.get(topic)
        return "" if rate is None else f"{rate:.3g} Hz" if rate < 1000 else f"{rate:.0f} Hz"

    def _colour(self, pair: tuple[int, int]) -> Style:
        colours = self.look.colours
        if colours.colourless:
            return colours.strong
        return pixel_style(pair[0] if colours.dark else pair[1], background_of(self.background))

    # -- frame ---------------------------------------------------------------------------------------------------------

    def _time_text(self) -> str:
        """Where the playhead is: seconds since the beginning, the date, the speed."""
        model = self.model
        if model.timeline.start_ns is None:
            return ""
        now = model.player.now()
        elapsed = f"{(now - model.timeline.start_ns) / NANOSECONDS:.3f}s"
        if self.inner_width < 50:
            return f" {elapsed} "
        return f" {elapsed}  {date(now)} "

    def status(self) -> list[Piece]:
        colours, model = self.look.colours, self.model
        pieces = [Piece(self._time_text(), colours.strong)]
        if speed := speed_text(model.player.playhead.speed):
            pieces.append(Piece(f" {speed} ", colours.accent))
        return pieces

    def status_right(self) -> list[Piece]:
        return [Piece(f" {size_text(self.model.size)} ", self.look.colours.muted)] if self.model.bags else []

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self.choice is not None:
            return [("Space", texts("bag.tick")), ("Enter", texts("bag.go_on")), ("Esc", texts("bag.cancel"))]
        if self.model.recorder is not None:
            return [("r", texts("bag.stop_recording")), ("Space", texts("bag.hold_recording"))]
        if self.view is None:
            return [("o", texts("bag.open")), ("r", texts("bag.record"))]
        if self._in_panel:
            return [("Enter", texts("bag.open_field")), ("g", texts("bag.plot")), ("Tab", texts("bag.timeline"))]
        plays = bool(self.model.player.playhead.speed)
        return [
            ("Space", texts("bag.pause" if plays else "bag.play")),
            ("Enter", texts("bag.unpublish" if self.chosen in self.model.player.publishing else "bag.publish")),
            ("+ -", texts("bag.speed")),
            ("p n", texts("bag.step")),
            ("v", texts("bag.view")),
            ("m", texts("bag.menu")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts, unicode = self.look.texts, self.look.glyphs.unicode
        return [
            ("↑ ↓" if unicode else "up down", texts("bag.choose")),
            ("← →" if unicode else "<- ->", texts("bag.pan")),
            ("Shift ← →" if unicode else "Shift <- ->", texts("bag.scrub")),
            ("PgUp PgDn", texts("bag.zoom")),
            ("0", texts("bag.fit")),
            ("Home End", texts("bag.ends")),
            ("[ ]", texts("bag.region")),
            ("Esc", texts("bag.no_region")),
            ("a", texts("bag.publish_all")),
            ("Tab", texts("bag.panel")),
            ("t", texts("bag.thumbnails")),
            ("o", texts("bag.open")),
            ("r", texts("bag.record")),
            ("s", texts("bag.save")),
        ]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        if self._press(event.key, event.character or ""):
            event.stop()
            event.prevent_default()
            self._drawn = ()
            self.look.wake()

    def _press(self, key: str, character: str) -> bool:
        if self.choice is not None:
            used = self.choice.press(key)
            if self.choice is not None and self.choice.is_over:
                self.choice = None
            return used
        if self.model.recorder is not None:
            return self._press_recording(key, character)
        if self._in_panel and self._tree is not None:
            if self._tree.press(key):
                return True
            if character == "g" and self._tree.field:
                self.post_message(self.CommandChosen(self, f"ros2 run rqt_plot rqt_plot {self._tree.field}"))
                return True
        action = {
            "space": self._toggle_play,
            "enter": self.toggle_publishing,
            "home": lambda: self._go(lambda: self.model.player.play_region[0]),
            "end": lambda: self._go(lambda: self.model.player.play_region[1]),
            "up": lambda: self._choose(self._chosen - 1),
            "down": lambda: self._choose(self._chosen + 1),
            "left": lambda: self._pan(-PAN),
            "right": lambda: self._pan(PAN),
            "shift+left": lambda: self._scrub(-1),
            "shift+right": lambda: self._scrub(1),
            "pageup": lambda: self._zoom(ZOOM_IN),
            "pagedown": lambda: self._zoom(ZOOM_OUT),
            "escape": self._escape,
            "tab": self._change_panel,
        }.get(key) or {
            "+": lambda: self._speed(faster),
            "=": lambda: self._speed(faster),
            "-": lambda: self._speed(slower),
            "p": lambda: self._step(-1),
            "n": lambda: self._step(1),
            "0": self._fit,
            "[": lambda: self._select_end(left=True),
            "]": lambda: self._select_end(left=False),
            "a": lambda: self.model.publish_all(self.model.player.publishing != set(self.model.topics)),
            "o": self._questions.bag,
            "v": self.toggle_view,
            "t": self.toggle_thumbnails,
            "r": self._questions.recording,
            "s": self._questions.export,
            "m": self._questions.menu,
        }.get(character)
        if action is None:
            return False
        action()
        return True

    def _toggle_play(self) -> None:
        player = self.model.player
        self.model.request(lambda: player.set_speed(0.0 if player.playhead.speed else 1.0))

    def _speed(self, change: Callable[[float], float]) -> None:
        player = self.model.player
        self.model.request(lambda: player.set_speed(change(player.playhead.speed)))

    def _step(self, count: int) -> None:
        self.model.request(lambda: self.model.player.step(count))

    def _go(self, where: Callable[[], int]) -> None:
        self.model.request(lambda: self.model.player.jump(where()))

    def toggle_publishing(self) -> None:
        if self.chosen:
            self.model.toggle_publishing(self.chosen)

    def _choose(self, index: int) -> None:
        self._chosen = max(0, min(len(self.model.topics) - 1, index))

    def _pan(self, part: float) -> None:
        if self.view is not None:
            self.view, self._fits = self.view.pan(part), False

    def _zoom(self, factor: float, centre: int | None = None) -> None:
        if self.view is not None:
            self.view = self.view.zoom(factor, self.model.player.now() if centre is None else centre)
            self._fits = False

    def _fit(self) -> None:
        self._fits = True

    def _scrub(self, columns: int) -> None:
        """Move the playhead by columns."""
        if self.view is not None:
            by = self.view.span * columns // self._place().columns
            self._move(self.model.player.now() + by)

    def _move(self, time_ns: int) -> None:
        timeline, player = self.model.timeline, self.model.player
        if timeline.start_ns is not None and timeline.end_ns is not None:
            at = max(timeline.start_ns, min(timeline.end_ns, time_ns))
            self.model.request(lambda: player.jump(at))

    def _select(self, region: tuple[int, int] | None) -> None:
        self.model.request(lambda: self.model.player.select(region))

    def _select_end(self, *, left: bool) -> None:
        """Begin or end the selected region at the playhead."""
        player, timeline = self.model.player, self.model.timeline
        now = player.now()
        begin, end = player.region or (timeline.start_ns or 0, timeline.end_ns or 0)
        self._select((now, max(now, end)) if left else (min(now, begin), now))

    def _press_recording(self, key: str, character: str) -> bool:
        recorder = self.model.recorder
        if character == "r":
            self.model.stop_recording()
        elif key == "space" and recorder is not None:
            self.model.request(recorder.toggle_paused)
        else:
            return False
        return True

    def _escape(self) -> None:
        """Stop copying, close what is below the timeline, or select nothing: what is there, in this order."""
        if self.model.exporting is not None:
            self.model.cancel_export()
        elif self._tree is not None:
            self.toggle_view()
        else:
            self._select(None)

    def toggle_view(self) -> None:
        """Show the messages of the chosen topic below the timeline; or, if it is shown, no longer."""
        before, self._tree, self._in_panel = self._tree, None, False
        if self.chosen and (before is None or before.topic != self.chosen):
            self._tree = MessageTree(self.look, self.chosen)
        self.model.watch(*([self._tree.topic] if self._tree is not None else []))

    def _change_panel(self) -> None:
        """Give the keys to the fields below the timeline, or back."""
        if self._tree is None:
            self.toggle_view()
        self._in_panel = not self._in_panel and self._tree is not None

    def toggle_thumbnails(self) -> None:
        self._thumbnails = not self._thumbnails

    def reset(self) -> None:
        """See everything, select nothing, go to the beginning (timeline_frame.reset_timeline)."""
        self._fit()
        self._select(None)
        self._go(lambda: self.model.player.play_region[0])

    # -- mouse ---------------------------------------------------------------------------------------------------------

    def _time_under(self, event: events.MouseEvent) -> int | None:
        """The time under the mouse, at the edge for one beside the timeline; None without a timeline."""
        place = self._place()
        if self.view is None:
            return None
        column = event.x - self.inner_offset - place.left
        return self.view.time_at(max(0, min(place.columns - 1, column)), place.columns)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        place = self._place()
        column, line = event.x - self.inner_offset - place.left, event.y - self.inner_offset
        at = self._time_under(event)
        if not self.is_inside(event):
            return
        if self.choice is not None:
            self.choice.click(line)
            self.touch()
            return
        if at is None:
            return
        rows = self._rows(place)
        if HEAD <= line < HEAD + len(rows):
            self._choose(rows[line - HEAD][0])
            if event.button == 3:
                self._questions.menu()
                return
            if column < 4 - place.left:
                self.toggle_publishing()
        elif line > HEAD + place.rows and self._tree is not None:
            self._in_panel = True
            self._tree.click(line - HEAD - place.rows - 1)
        if 0 <= column < place.columns and line < HEAD + place.rows:
            self._drag = "pan" if event.button == 2 or event.shift else "scrub" if line >= HEAD else "select"
            self._dragged_from = at
            self.capture_mouse()
            if self._drag == "scrub":
                self._move(at)
        self._drawn = ()
        self.look.wake()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        at = self._time_under(event)
        if not self._drag or at is None:
            return
        if self._drag == "scrub":
            self._move(at)
        elif self._drag == "select":
            self._select((min(at, self._dragged_from), max(at, self._dragged_from)))
        elif self.view is not None:
            by = self._dragged_from - at
            self.view, self._fits = View(self.view.left + by, self.view.right + by), False
        self._drawn = ()
        self.look.wake()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag:
            if self._drag == "select" and self._time_under(event) == self._dragged_from:
                self._select(None)
            self._drag = ""
            self.release_mouse()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._wheel(event, WHEEL_IN)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._wheel(event, WHEEL_OUT)

    def _wheel(self, event: events.MouseEvent, factor: float) -> None:
        event.stop()
        self._zoom(factor)
        self._drawn = ()
        self.look.wake()
