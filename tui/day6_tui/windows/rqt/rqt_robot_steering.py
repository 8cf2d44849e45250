"""The window of rqt_robot_steering: the topic, the slider of the linear velocity, and below it that of the angular one."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_core.ros.programs.rqt_robot_steering.model import (
    ANGULAR,
    FACTOR,
    FARTHEST,
    LIMIT_STEP,
    LINEAR,
    MAXIMUM,
    MINIMUM,
    PAGE,
    STEP,
    Axis,
)
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, wrap
from day6_tui.panes.pane import Action, Piece
from day6_tui.windows import WindowPane
from day6_tui.windows.parts.buttons import Button, button_line, shortened

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_robot_steering.model import RobotSteering

MOVES = {
    "w": (LINEAR, STEP), "s": (LINEAR, -STEP), "a": (ANGULAR, STEP), "d": (ANGULAR, -STEP),
    "W": (LINEAR, PAGE), "S": (LINEAR, -PAGE), "A": (ANGULAR, PAGE), "D": (ANGULAR, -PAGE),
    "up": (LINEAR, STEP), "down": (LINEAR, -STEP), "left": (ANGULAR, STEP), "right": (ANGULAR, -STEP),
    "shift+up": (LINEAR, PAGE), "shift+down": (LINEAR, -PAGE), "shift+left": (ANGULAR, PAGE), "shift+right": (ANGULAR, -PAGE),
}  # fmt: skip
"""Keys that move a slider. The letters are the real one's; the arrows move that of its sliders that has the keyboard."""

RESETS = {"x": LINEAR, "X": LINEAR, "z": ANGULAR, "Z": ANGULAR}

UNITS = {LINEAR: "m/s", ANGULAR: "rad/s"}

LIMITS = ((LINEAR, MAXIMUM), (LINEAR, MINIMUM), (ANGULAR, MAXIMUM), (ANGULAR, MINIMUM))

ROOMY = (34, 9)
"""Columns and lines from which on the linear slider stands upright, as in the real one."""

MOST_REMARKS = 3

TALLEST = 15
"""Lines of it; their number is odd, so that zero is in its middle."""

AIRY = 13
"""Lines from which on there are empty ones around it."""

BESIDE = 12
"""Columns from it to the buttons at its left."""

VALUE_WIDTH, LIMIT_WIDTH = 14, 6

Placed = tuple[int, list[Segment], Action | None]
"""A column, what stands from there on, and what a click on it does."""


class Track(NamedTuple):
    """Where a slider is: its first line and column inside, and its length in lines or columns."""

    y: int
    x: int
    length: int
    upright: bool
    falls: bool
    """Whether its first cell is the maximum."""

    def cell(self, slider: Axis, value: int) -> int:
        """The cell of a value."""
        share = (value - slider.minimum) / max(1, slider.maximum - slider.minimum)
        return round((1 - share if self.falls else share) * (self.length - 1))

    def value(self, slider: Axis, index: int) -> int:
        """The value at a cell."""
        share = min(1.0, max(0.0, index / max(1, self.length - 1)))
        return slider.minimum + round((1 - share if self.falls else share) * (slider.maximum - slider.minimum))

    def has(self, x: int, y: int) -> bool:
        """Whether a place inside the window is on it, or beside an upright one."""
        if self.upright:
            return abs(x - self.x) <= 1 and self.y <= y < self.y + self.length
        return y == self.y and self.x <= x < self.x + self.length


class RobotSteeringPane(WindowPane["RobotSteering"]):
    """Draws the two sliders; keeps which limit the keys mean, and the slider that the mouse drags."""

    def __init__(self, window: Window[RobotSteering], look: Look) -> None:
        super().__init__(window, look)
        self._limit: tuple[str, str] | None = None
        self._dragged = ""
        self._tracks: dict[str, Track] = {}
        self._state: tuple[object, ...] = ()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (self.model.version, self._limit, self.extent)
        if state != self._state:
            self._state = state
            self.touch_lines(range(self.inner_height))
            self.touch_frame()
        return False

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        height = self.inner_height
        remarks = self._remarks(width, max(0, min(MOST_REMARKS, height - 4)))
        below = y - (height - len(remarks))
        if y == 0:
            return button_line(self, 0, self._buttons(width), width)
        if below >= 0:
            return remarks[below]
        roomy = width >= ROOMY[0] and height - len(remarks) >= ROOMY[1]
        rows = self._upright(width, height - len(remarks)) if roomy else self._flat(width)
        return self._row(y, rows.get(y, []))

    def _buttons(self, width: int) -> list[Button]:
        model, texts = self.model, self.look.texts
        buttons = [
            Button("t", model.topic or texts("steering.no_topic"), self._ask_topic),
            Button("m", "stamped", self._toggle_stamped, model.stamped),
            Button(texts("steering.space"), texts("steering.stop"), model.stop),
        ]
        return shortened(buttons, width, self.look.glyphs.ellipsis)

    def _upright(self, width: int, height: int) -> dict[int, list[Placed]]:
        """The linear slider upright with its buttons and numbers beside it, the angular one lying below it."""
        gap = 1 if height >= AIRY else 0
        half, top = (min(TALLEST, height - 4 - 2 * gap) - 1) // 2, 1 + gap
        x, middle, bottom = 2 + (width - 5) // 2, top + half, top + 2 * half
        across = bottom + 1 + gap
        self._tracks = {
            LINEAR: Track(top, x, 2 * half + 1, True, True),
            ANGULAR: Track(across, 2, (width - 5) // 2 * 2 + 1, False, True),
        }
        rows: dict[int, list[Placed]] = {
            y: [(x, [mark], None)] for y, mark in enumerate(self._marks(LINEAR), start=top)
        }
        for y, button in ((top, ("w", "+", PAGE)), (middle, ("x", "0", 0)), (bottom, ("s", "-", -PAGE))):
            rows[y].append(self._button(x - BESIDE, LINEAR, *button))
        rows[top].append(self._end(x + 3, LINEAR, MAXIMUM))
        rows[middle].append((x + 3, [self._value(LINEAR)], None))
        rows[bottom].append(self._end(x + 3, LINEAR, MINIMUM))
        rows[across] = [(2, self._marks(ANGULAR), None)]
        rows[across + 1] = [
            self._button(2, ANGULAR, "a", "<", PAGE),
            self._button(x - 3, ANGULAR, "z", "0", 0),
            self._button(2 * x - 7, ANGULAR, "d", ">", -PAGE),
        ]
        value = self._value(ANGULAR)
        rows[across + 2] = [
            self._end(2, ANGULAR, MAXIMUM),
            (x - cell_len(value.text) // 2, [value], None),
            self._end(2 * x - 1 - LIMIT_WIDTH, ANGULAR, MINIMUM),
        ]
        return rows

    def _flat(self, width: int) -> dict[int, list[Placed]]:
        """A line for each slider, where there is little room."""
        self._tracks = {}
        rows: dict[int, list[Placed]] = {}
        for y, (axis, falls) in enumerate(((LINEAR, False), (ANGULAR, True)), start=2):
            first, last = (MAXIMUM, MINIMUM) if falls else (MINIMUM, MAXIMUM)
            name = self.look.texts(f"steering.{axis}")
            ends = width >= ROOMY[0] + 2 * LIMIT_WIDTH
            left = max(cell_len(self.look.texts(f"steering.{each}")) for each in (LINEAR, ANGULAR)) + 2
            x = left + (LIMIT_WIDTH + 1) * ends
            length = max(3, width - x - VALUE_WIDTH - (LIMIT_WIDTH + 1) * ends)
            self._tracks[axis] = Track(y, x, length, False, falls)
            rows[y] = [
                (1, [Segment(name, self.look.colours.muted)], None),
                (x, self._marks(axis), None),
                (width - VALUE_WIDTH + 1, [self._value(axis)], None),
            ]
            if ends:
                rows[y] += [self._end(left, axis, first), self._end(x + length + 1, axis, last)]
        return rows

    def _row(self, y: int, pieces: list[Placed]) -> list[Segment]:
        """Put pieces at their columns, and make them clickable."""
        at, segments = 0, []
        for x, piece, action in sorted(pieces, key=lambda placed: placed[0]):
            end = x + sum(segment.cell_length for segment in piece)
            segments += [Segment(" " * (x - at), self.background), *piece]
            if action is not None:
                self.add_hit(y + self.inner_offset, x + self.inner_offset, end + self.inner_offset, action)
            at = end
        return segments

    def _button(self, x: int, axis: str, key: str, sign: str, places: int) -> Placed:
        """A button that moves a slider, 0 to zero."""
        action = partial(self.model.move, axis, places) if places else partial(self.model.set, axis, 0)
        return x, [Segment(f" {key} ", self.look.colours.key), Segment(f" {sign} ", self.look.colours.text)], action

    def _end(self, x: int, axis: str, end: str) -> Placed:
        """The number at an end of a slider; those at the right end stand at the right."""
        colours, chosen = self.look.colours, self._limit == (axis, end)
        style = colours.choice if chosen and self.has_focus else colours.strong if chosen else colours.muted
        text = f"{getattr(self.model.axes[axis], end) / FACTOR:.2f}"
        fitted = f"{text:>{LIMIT_WIDTH}}" if axis == ANGULAR and end == MINIMUM else f"{text:<{LIMIT_WIDTH}}"
        return x, [Segment(fitted, style)], partial(self._choose_and_ask, (axis, end))

    def _value(self, axis: str) -> Segment:
        value = self.model.axes[axis].value
        style = self.look.colours.strong if value else self.look.colours.text
        return Segment(f"{value / FACTOR:.2f} {UNITS[axis]}", style)

    def _marks(self, axis: str) -> list[Segment]:
        """The cells of a slider, from its first one."""
        slider, track = self.model.axes[axis], self._tracks[axis]
        colours, glyphs = self.look.colours, self.look.glyphs
        if glyphs.unicode:
            bar, cross, dot = "│" if track.upright else "─", "┼", "■" if glyphs.canvas == "cell" else "●"
        else:
            bar, cross, dot = "|" if track.upright else "-", "+", "O"
        marks = [Segment(bar, colours.muted)] * track.length
        marks[track.cell(slider, 0)] = Segment(cross, colours.muted)
        marks[track.cell(slider, slider.value)] = Segment(dot, colours.publisher)
        return marks

    def _remarks(self, width: int, most: int) -> list[list[Segment]]:
        """What there is to say of the topic, in at most so many lines."""
        text, style = self._remark()
        return [[Segment(f" {line}", style)] for line in wrap(text, width - 2)[:most]] if text else []

    def _remark(self) -> tuple[str, Style]:
        model, texts, colours = self.model, self.look.texts, self.look.colours
        if model.problem:
            return model.problem.replace("\n", " "), colours.warning
        if not model.topic:
            return texts("steering.nothing"), colours.muted
        if model.other_types:
            about = {"topic": model.topic, "types": ", ".join(model.other_types), "type": model.type}
            turned = any(each.endswith(("/Twist", "/TwistStamped")) for each in model.other_types)
            return texts("steering.other_stamp" if turned else "steering.other_type", **about), colours.warning
        if not model.heard:
            return texts("steering.unheard", topic=model.topic), colours.muted
        return "", colours.text

    def status(self) -> list[Piece]:
        text = self.look.texts("steering.heard", count=self.model.heard)
        return [Piece(f" {text} ", self.look.colours.muted)]

    def status_right(self) -> list[Piece]:
        """The chosen end of a slider, which lines without room for it do not show."""
        if self._limit is None:
            return []
        texts, (axis, end) = self.look.texts, self._limit
        value = getattr(self.model.axes[axis], end) / FACTOR
        text = f" {texts(f'steering.{axis}')} {texts(f'steering.{end}')}: {value:.2f} "
        return [Piece(text, self.look.colours.accent, partial(self._choose_and_ask, self._limit))]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self._limit is not None:
            return [
                ("Enter", texts("sliders.value")),
                ("+ -", texts("steering.change")),
                ("Tab", texts("steering.next")),
            ]
        return [
            (texts("steering.space"), texts("steering.stop")),
            ("w s", texts("steering.linear")),
            ("a d", texts("steering.angular")),
            ("t", texts("steering.topic")),
            ("Tab", texts("steering.limits")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            ("W S A D", texts("steering.far")),
            ("x z", texts("steering.zero")),
            ("m", "stamped"),
        ]

    def _press(self, key: str, character: str) -> bool:
        if (move := MOVES.get(character) or MOVES.get(key)) is not None:
            self.model.move(*move)
        elif character in RESETS:
            self.model.set(RESETS[character], 0)
        elif key in ("space", "shift+space"):
            self.model.stop()
        elif character == "t":
            self._ask_topic()
        elif character == "m":
            self._toggle_stamped()
        elif key in ("tab", "shift+tab"):
            self._next_limit(1 if key == "tab" else -1)
        elif self._limit is not None:
            return self._press_on_limit(self._limit, key, character)
        else:
            return False
        return True

    def _press_on_limit(self, limit: tuple[str, str], key: str, character: str) -> bool:
        if key == "escape":
            self._limit = None
        elif key == "enter":
            self._choose_and_ask(limit)
        elif character in ("+", "-"):
            value = getattr(self.model.axes[limit[0]], limit[1]) / FACTOR
            self.model.set_limit(*limit, value + (LIMIT_STEP if character == "+" else -LIMIT_STEP))
        else:
            return False
        return True

    def _next_limit(self, step: int) -> None:
        """Go on to the next of the four, and after the last one to none."""
        places = (None, *LIMITS)
        self._limit = places[(places.index(self._limit) + step) % len(places)]

    def _choose_and_ask(self, limit: tuple[str, str]) -> None:
        """Ask for a limit as a number."""
        self._limit = limit
        texts, (axis, end) = self.look.texts, limit
        low, high = (-FARTHEST, 0.0) if end == MINIMUM else (0.0, FARTHEST)

        def taken(text: str) -> str | None:
            try:
                value = float(text)
            except ValueError:
                value = math.nan
            if not low <= value <= high:
                return texts("steering.bad_limit", low=f"{low:g}", high=f"{high:g}")
            self.model.set_limit(axis, end, value)
            return None

        begun = f"{getattr(self.model.axes[axis], end) / FACTOR:g}"
        self.ask(f"{texts(f'steering.{axis}')} · {texts(f'steering.{end}')}", begun, taken, note=UNITS[axis])

    def _ask_topic(self) -> None:
        self.ask(
            self.look.texts("steering.topic_title"), self.model.topic, lambda text: self.model.set_topic(text.strip())
        )

    def _toggle_stamped(self) -> None:
        self.model.set_stamped(not self.model.stamped)

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def on_mouse_down(self, event: events.MouseDown) -> None:
        if event.button != 1:
            return
        x, y = event.x - self.inner_offset, event.y - self.inner_offset
        self._dragged = next((axis for axis, track in self._tracks.items() if track.has(x, y)), "")
        if self._dragged:
            self.capture_mouse()
            self._drag_to(event)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._dragged:
            self._drag_to(event)

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._dragged:
            self._dragged = ""
            self.release_mouse()

    def _drag_to(self, event: events.MouseEvent) -> None:
        track, slider = self._tracks[self._dragged], self.model.axes[self._dragged]
        at = event.y - track.y if track.upright else event.x - track.x
        index = at - self.inner_offset
        self.model.set(self._dragged, 0 if index == track.cell(slider, 0) else track.value(slider, index))
        self.look.wake()
