"""rqt_bag's window: the timeline of the open bags (`bag_lanes`), what is at the playhead below it (`bag_panel`), keys and mouse.

Keys are those of the real one (bag_widget.on_key_press) but for two: Up and Down choose a topic, because here no mouse says which
one is meant; there they zoom, as Page Up and Page Down do in both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.ros.programs.rqt_bag.model.playhead import faster, slower, speed_text
from day6_core.ros.programs.rqt_bag.model.view import (
    NANOSECONDS,
    PAN,
    WHEEL_IN,
    WHEEL_OUT,
    ZOOM_IN,
    ZOOM_OUT,
    TimeSpan,
    size_text,
    whole,
)
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip, wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.bag.cells import date
from day6_tui.windows.bag.lanes import HEAD, TICK, BagLanes, LanePlace
from day6_tui.windows.bag.panel import LEAST_LINES, BagPanel
from day6_tui.windows.bag.picture import Paintings
from day6_tui.windows.bag.questions import Questions
from day6_tui.windows.bag.topics import TopicChoice

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_bag.model.bags import Bags


NOTES = {"cut": "bag.cut", "cancelled": "bag.cancelled", "empty": "bag.empty"}
"""The texts of what the model notes."""

MOST_TOLD = 3
"""Lines of what went wrong."""


class RqtBagPane(WindowPane["Bags"]):
    """Draws `Bags`. What part of the timeline is seen is the model's, so that a perspective can keep it."""

    needs = PaneNeeds(Extent(40, 9), Extent(64, 14), Extent(110, 28))

    def __init__(self, window: Window[Bags], look: Look) -> None:
        super().__init__(window, look)
        self._timeline = window.model.timeline
        self._paintings = Paintings(look)
        self.lanes = BagLanes(look, window.model, self._paintings)
        self.panel = BagPanel(look, window.model, self._paintings)
        self._drawn: tuple[object, ...] = ()
        self._seen: tuple[object, ...] = ()
        """For what part the messages were looked up."""
        self._followed = 0
        """Where the playhead was when the view last followed it."""
        self._drag = ""
        self._dragged_from = 0
        self._questions = Questions(self)
        self.choice: TopicChoice | None = None
        """The list of topics that lies over the timeline while some are chosen."""

    @property
    def view(self) -> TimeSpan | None:
        """What is seen, None without a timeline."""
        timeline = self.model.timeline
        if timeline.start_ns is None or timeline.end_ns is None:
            return None
        return self.model.view or whole(timeline.start_ns, timeline.end_ns)

    @property
    def chosen(self) -> str:
        """The topic that keys mean, '' without any."""
        return self.lanes.chosen

    def _place(self) -> LanePlace:
        panel = LEAST_LINES if self.panel.is_open else 0
        return self.lanes.place(self.inner_width, self.inner_height, told=len(self._told()[0]), least_panel=panel)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        model = self.model
        if model.timeline is not self._timeline:
            self._timeline = model.timeline
            self.lanes.forget()
            self.panel.forget()
        moves = bool(model.player.playhead.speed) or model.loading or model.recorder is not None
        self._follow(model.player.now())
        self.panel.pull()
        place = self._place()
        state = (
            model.version, self.view, self._playhead_column(place), self.lanes.index, place, self._time_text(),
            model.indexed,
        )  # fmt: skip
        if state == self._drawn:
            return moves
        self._drawn = state
        self._look(place)
        self.touch_lines(range(self.inner_height))
        self.touch_frame()
        return moves

    def _follow(self, playhead: int) -> None:
        """When the playhead leaves what is seen, the view goes with it."""
        view, timeline = self.view, self.model.timeline
        if view is not None and playhead != self._followed and not self._drag:
            self._followed = playhead
            moved = view.following(playhead, timeline.start_ns or 0, timeline.end_ns or 0)
            if moved != view:
                self.model.view = moved

    def _look(self, place: LanePlace) -> None:
        """Have single messages looked up where something else is seen than before."""
        view, blocks = self.view, self.model.timeline.blocks
        if view is not None and self.lanes.recount(view, place) and self._seen != (view, blocks):
            self._seen = (view, blocks)
            self.model.see(view.left, view.right)

    def _playhead_column(self, place: LanePlace) -> int:
        view = self.view
        return -1 if view is None else view.column_of(self.model.player.now(), place.columns)

    def restyle(self) -> None:
        self._drawn = ()
        self.lanes.restyle()
        super().restyle()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._drawn = ()

    def _redraw(self) -> None:
        self._drawn = ()
        self.look.wake()

    # -- lines ---------------------------------------------------------------------------------------------------------

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if self.choice is not None:
            return self.choice.line(y, width, self.inner_height)
        view, place = self.view, self._place()
        if view is None:
            return self._empty_line(y, width)
        self._look(place)
        if y == 0:
            return self.lanes.labels(view, place)
        if y == 1:
            return self.lanes.ruler(view, place)
        if y < place.bottom:
            rows = self.lanes.rows(place)
            if y - HEAD >= len(rows):
                return ()
            return self.lanes.line(*rows[y - HEAD], view, place, focused=self.has_focus)
        if y < place.panel_top:
            return self._told_line(y - place.bottom)
        return self.panel.line(y - place.panel_top, width, place.panel, focused=self.has_focus)

    def _empty_line(self, y: int, width: int) -> list[Segment]:
        told = self._told()[0]
        if 1 <= y <= len(told):
            return self._told_line(y - 1)
        none = "" if self.model.bags else self.look.texts("bag.none")
        return [Segment(" " + clip(none, width - 1), self.look.colours.muted)] if y == len(told) + 2 else []

    def _recording_text(self) -> str:
        recorder = self.model.recorder
        if recorder is None:
            return ""
        key = "bag.recording_paused" if recorder.paused else "bag.recording"
        return self.look.texts(key, count=recorder.messages, size=size_text(recorder.size))

    def _told(self) -> tuple[list[str], bool]:
        """What is going on or went wrong, or what the chosen topic is: its lines, and whether it warns."""
        model, topic = self.model, self.chosen
        status = model.status
        status = status if isinstance(status, str) else self.look.texts(NOTES[status.kind], name=status.name)
        exporting = f"{model.exporting_to}  {model.exporting} %" if model.exporting is not None else ""
        loading = f"{status} {model.indexed} %" if model.indexed is not None else ""
        text = self._recording_text() or exporting or loading or status or model.player.problem
        failed = bool(model.recorder) or (not exporting and (model.failed or not model.status))
        width = max(1, self.inner_width - 2)
        if text:
            return wrap(text, width)[:MOST_TOLD], failed
        if not topic:
            return [""], False
        count = self.look.texts("bag.messages", count=model.timeline.count(topic))
        about = f"{model.topics[topic]}  {count}  {self.lanes.rate(topic)}"
        return [clip(about, width, self.look.glyphs.ellipsis)], False

    def _told_line(self, number: int) -> list[Segment]:
        lines, failed = self._told()
        return [Segment(f" {lines[number]}", self.look.colours.warning if failed else self.look.colours.muted)]

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
        if self.model.is_busy:
            return [("Esc", texts("bag.cancel"))]
        if self.view is None:
            return [("o", texts("bag.open")), ("r", texts("bag.record"))]
        if self.panel.has_keys:
            return [("Enter", texts("bag.open_field")), ("g", texts("bag.plot")), ("Tab", texts("bag.timeline"))]
        plays = bool(self.model.player.playhead.speed)
        return [
            ("Space", texts("bag.pause" if plays else "bag.play")),
            ("Enter", texts("bag.unpublish" if self.chosen in self.model.player.publishing else "bag.publish")),
            ("+ -", texts("bag.speed")),
            (", .", texts("bag.step")),
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
            ("w", texts("bag.save")),
        ]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def _press(self, key: str, character: str) -> bool:
        if self.choice is not None:
            used = self.choice.press(key)
            if self.choice is not None and self.choice.is_over:
                self.choice = None
            return used
        if self.model.recorder is not None:
            return self._press_recording(key, character)
        if self.panel.press(key):
            return True
        if character == "g" and self.panel.field:
            self.post_message(self.CommandChosen(self, f"ros2 run rqt_plot rqt_plot {self.panel.field}"))
            return True
        action = {
            "space": self._toggle_play,
            "enter": self.toggle_publishing,
            "home": lambda: self._go(lambda: self.model.player.play_region[0]),
            "end": lambda: self._go(lambda: self.model.player.play_region[1]),
            "up": lambda: self._choose(self.lanes.index - 1),
            "down": lambda: self._choose(self.lanes.index + 1),
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
            "p": self._toggle_play,
            ",": lambda: self._step(-1),
            ".": lambda: self._step(1),
            "0": self._fit,
            "[": lambda: self._select_end(left=True),
            "]": lambda: self._select_end(left=False),
            "a": lambda: self.model.publish_all(self.model.player.publishing != set(self.model.topics)),
            "o": self._questions.bag,
            "v": self.toggle_view,
            "t": self.toggle_thumbnails,
            "r": self._questions.recording,
            "w": self._questions.export,
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
        """Choose a topic; what was told gives way to it."""
        self.lanes.choose(index)
        self.model.dismiss()

    def _pan(self, part: float) -> None:
        if self.view is not None:
            self.model.view = self.view.pan(part)

    def _zoom(self, factor: float) -> None:
        if self.view is not None:
            self.model.view = self.view.zoom(factor, self.model.player.now())

    def _fit(self) -> None:
        self.model.view = None

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
        elif key in ("space", "p") and recorder is not None:
            self.model.request(recorder.toggle_paused)
        else:
            return False
        return True

    def _escape(self) -> None:
        """Stop copying or loading, dismiss what is told, close what is below, or select nothing: what is there, in this order."""
        if self.model.is_busy:
            self.model.cancel()
        elif self.model.status or self.model.player.problem:
            self.model.dismiss()
        elif self.panel.is_open:
            self.panel.show("")
        else:
            self._select(None)

    def toggle_view(self) -> None:
        """Show the messages of the chosen topic below the timeline; or, if it is shown, no longer."""
        self.panel.show("" if self.panel.topic == self.chosen else self.chosen)

    def _change_panel(self) -> None:
        """Give the keys to the fields below the timeline, or back."""
        if not self.panel.is_open:
            self.panel.show(self.chosen)
        self.panel.has_keys = not self.panel.has_keys and self.panel.is_open

    def toggle_thumbnails(self) -> None:
        self.model.thumbnails = not self.model.thumbnails

    def reset(self) -> None:
        """See everything, select nothing, go to the beginning (timeline_frame.reset_timeline)."""
        self._fit()
        self._select(None)
        self._go(lambda: self.model.player.play_region[0])

    # -- mouse ---------------------------------------------------------------------------------------------------------

    def _time_under(self, event: events.MouseEvent) -> int | None:
        """The time under the mouse, at the edge for one beside the timeline; None without a timeline."""
        view, place = self.view, self._place()
        if view is None:
            return None
        column = event.x - self.inner_offset - place.left
        return view.time_at(max(0, min(place.columns - 1, column)), place.columns)

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
        rows = self.lanes.rows(place)
        if HEAD <= line < HEAD + len(rows):
            self._choose(rows[line - HEAD][0])
            if event.button == 3:
                self._questions.menu()
                return
            if column < TICK - place.left:
                self.toggle_publishing()
        elif line >= place.panel_top:
            self.panel.click(line - place.panel_top)
        if 0 <= column < place.columns and line < place.bottom:
            self._drag = "pan" if event.button == 2 or event.shift else "scrub" if line >= HEAD else "select"
            self._dragged_from = at
            self.capture_mouse()
            if self._drag == "scrub":
                self._move(at)
        self._redraw()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        at, view = self._time_under(event), self.view
        if not self._drag or at is None or view is None:
            return
        if self._drag == "scrub":
            self._move(at)
        elif self._drag == "select":
            self._select((min(at, self._dragged_from), max(at, self._dragged_from)))
        else:
            by = self._dragged_from - at
            self.model.view = TimeSpan(view.left + by, view.right + by)
        self._redraw()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag:
            if self._drag == "select" and self._time_under(event) == self._dragged_from:
                self._select(None)
            self._drag = ""
            self.release_mouse()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        """Zoom on the timeline; over the names of topics choose one, over the fields of a message go through them."""
        event.stop()
        place = self._place()
        if event.y - self.inner_offset >= place.panel_top:
            self.panel.wheel(notches)
        elif event.x - self.inner_offset < place.left:
            self._choose(self.lanes.index + notches)
        else:
            self._zoom(WHEEL_OUT if notches > 0 else WHEEL_IN)
        self._redraw()
