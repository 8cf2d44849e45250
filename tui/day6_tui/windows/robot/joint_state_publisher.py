"""The slider window of joint_state_publisher_gui: a slider per joint, for keys and the mouse, and exact numbers.

The sliders and what a request does are the program's (`SliderModel`); this only draws them and keeps what is chosen.
"""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.ros.programs.joint_state_publisher_gui.model import RANGE
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit, wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows.parts.lines_pane import Line, LinesPane
from day6_tui.windows.parts.list_keys import BEGINS_NUMBER, SLIDER_FINEST, SLIDER_STEPS, list_steps
from day6_tui.windows.robot.joint_names import shortened

if TYPE_CHECKING:
    from day6_core.ros.programs.joint_state_publisher_gui.model import Slider, SliderModel


VALUE_WIDTH, UNIT_WIDTH = 9, 5
"""Cells of a joint's number, and of the unit behind it."""

NARROW, NARROWEST_LINE = 58, 30
"""Columns below which a slider takes two lines if all have room, and below which one line never does."""

BUTTONS = (("randomize", "Randomize", "r"), ("center", "Center", "c"))
"""The requests they make, their names in the original, their keys."""

STEP = RANGE // 100
"""Of a slider's 10000 steps so many are one key's."""


class SlidersPane(LinesPane["SliderModel"]):
    """Draws `SliderModel.sliders`; keeps the chosen one, the unit, and a number that is being typed."""

    needs = PaneNeeds(Extent(30, 7), Extent(38, 8), Extent(60, 12))
    about = "robot"

    def __init__(self, window: Window[SliderModel], look: Look) -> None:
        super().__init__(window, look)
        self._chosen = ""
        self._degrees = False
        self._typed: str | None = None
        """The part of a number typed so far for the chosen joint; None while none is being typed."""
        self._dragged = ""
        self._tracks: dict[str, tuple[int, int]] = {}
        """Column and width of every track that is shown."""
        self._first, self._lines_each = 0, 1

    # -- the sliders ---------------------------------------------------------------------------------------------------

    def _index(self) -> int:
        return next((i for i, slider in enumerate(self.model.sliders) if slider.name == self._chosen), 0)

    def _slider(self) -> Slider | None:
        sliders = self.model.sliders
        return sliders[self._index()] if sliders else None

    def _in_degrees(self, slider: Slider) -> bool:
        return self._degrees and slider.turns

    def _text(self, slider: Slider, value: float, digits: int) -> str:
        return f"{math.degrees(value) if self._in_degrees(slider) else value:.{digits}f}"

    def _unit(self, slider: Slider) -> str:
        if not slider.turns:
            return "m"
        if not self._degrees:
            return "rad"
        return "°" if self.look.glyphs.unicode else "deg"

    # -- building ------------------------------------------------------------------------------------------------------

    def _build(self, width: int, height: int) -> list[Line]:
        lines = [self._buttons(width)]
        below = self._problem_lines(width, max(1, height // 3))
        room = max(1, height - 1 - len(below))
        lines += self._list(width, room)
        lines += [[]] * (height - len(lines) - len(below))
        return (lines + below)[: max(height, 0)]

    def _buttons(self, width: int) -> Line:
        colours = self.look.colours
        self._hits.pop(1, None)
        segments: Line = [Segment(" ", self.background)]
        column = 1
        keys = width >= sum(len(name) + 7 for _, name, _ in BUTTONS)
        for request, name, key in BUTTONS:
            text = f" {name} "
            segments += [Segment(text, colours.key), Segment(f" {key}   " if keys else "  ", colours.muted)]
            self.add_hit(
                1,
                column + self.inner_offset,
                column + self.inner_offset + len(text),
                partial(self._request, request),
            )
            column += len(text) + (5 if keys else 2)
        return segments

    def _list(self, width: int, room: int) -> list[Line]:
        sliders = self.model.sliders
        if not sliders:
            key = "sliders.none" if self.model.described else "sliders.waiting"
            return [[Segment(" " + text, self.look.colours.muted)] for text in wrap(self.look.texts(key), width - 2)]
        tall = self._tall(width, room)
        fitting = max(1, room // tall)
        first = max(0, min(self._index() - fitting // 2, len(sliders) - fitting))
        self._first, self._lines_each = first, tall
        longest = max(cell_len(slider.name) for slider in sliders)
        name_width = max(4, width - VALUE_WIDTH - 9) if tall > 1 else max(8, min(longest, width // 3))
        names = shortened([slider.name for slider in sliders], name_width, self.look.glyphs.ellipsis)
        lines: list[Line] = []
        for slider, name in list(zip(sliders, names, strict=True))[first : first + fitting]:
            head = self._head(slider, name, name_width)
            if tall > 1:
                track = [Segment("   ", self.background), *self._track(slider, 3, width - 5)]
                lines += [[*head, *self._value(slider)], track, *[[]] * (tall - 2)]
            else:
                track = self._track(slider, name_width + 3, width - name_width - VALUE_WIDTH - 8)
                lines.append([*head, *track, *self._value(slider)])
        return lines[:room]

    def _tall(self, width: int, room: int) -> int:
        """Lines for each slider: two where one is too short for the whole name, three if there is plenty of room."""
        count = len(self.model.sliders)
        if width < NARROW:
            return 2 if room >= 2 * count or width < NARROWEST_LINE else 1
        return 3 if room >= 3 * count else 1

    def _head(self, slider: Slider, name: str, width: int) -> Line:
        colours, chosen = self.look.colours, slider is self._slider()
        mark = self.look.glyphs.marker if chosen else " "
        style = colours.choice if chosen and self.has_focus else colours.strong if chosen else colours.node
        return [
            Segment(f" {mark}", colours.accent),
            Segment(fit(name, width), style),
            Segment(" ", self.background),
        ]

    def _value(self, slider: Slider) -> Line:
        colours = self.look.colours
        if self._typed is not None and slider is self._slider():
            text, style = f"{self._typed}_", colours.choice
        else:
            text, style = self._text(slider, slider.value, 1 if self._in_degrees(slider) else 3), colours.strong
        return [
            Segment(f" {text:>{VALUE_WIDTH - 1}}", style),
            Segment(f" {self._unit(slider):<{UNIT_WIDTH - 1}}", colours.muted),
        ]

    def _track(self, slider: Slider, column: int, width: int) -> Line:
        """The two limits and between them the track with its knob; remembers where it is for the mouse."""
        colours = self.look.colours
        low, high = (self._text(slider, limit, 0 if self._degrees else 2) for limit in (slider.minimum, slider.maximum))
        limits = width >= 30
        if limits:
            low, high = f"{low:>7} ", f" {high:<7}"
            width -= len(low) + len(high)
            column += len(low)
        width = max(width, 3)
        self._tracks[slider.name] = (column, width)
        knob = _knob(slider.step, width)
        plain = not self.look.glyphs.unicode
        bar, dot = ("-", "O") if plain else ("─", "●" if self.look.glyphs.canvas != "cell" else "■")
        zero = _knob(_step_of(slider, 0.0), width) if slider.minimum < 0 < slider.maximum else -1
        cells = [("|" if plain else "┼") if x == zero else bar for x in range(width)]
        style = colours.publisher if slider is self._slider() else colours.text
        return [
            *([Segment(low, colours.muted)] if limits else ()),
            Segment("".join(cells[:knob]), colours.muted),
            Segment(dot, style),
            Segment("".join(cells[knob + 1 :]), colours.muted),
            *([Segment(high, colours.muted)] if limits else ()),
        ]

    def _problem_lines(self, width: int, most: int) -> list[Line]:
        """Other publishers, if there are any: the reason a robot jitters. Where there is no room to explain, only who."""
        others = ", ".join(self.model.others)
        if not others:
            return []
        lines = wrap(self.look.texts("sliders.conflict", nodes=others), width - 4)
        if len(lines) > most:
            short = self.look.texts("sliders.conflict.short", nodes=others)
            lines = [clip(short, width - 4, self.look.glyphs.ellipsis)]
        mark = f"{self.look.glyphs.warning} "
        style = self.look.colours.warning
        return [[Segment(f" {mark if not y else '  '}{line}", style)] for y, line in enumerate(lines)]

    def status(self) -> list[Piece]:
        sliders = self.model.sliders
        if not sliders:
            return []
        return [Piece(f" {self._index() + 1}/{len(sliders)} ", self.look.colours.muted)]

    def status_right(self) -> list[Piece]:
        if not any(slider.turns for slider in self.model.sliders):
            return []
        return [Piece(f" {self.look.texts('sliders.degrees')} d ", self.look.colours.muted, self._toggle_degrees)]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        if self._typed is not None:
            return [("Enter", texts("sliders.accept")), ("Esc", texts("sliders.cancel"))]
        return [
            (arrows, texts("sliders.move")),
            ("Enter", texts("sliders.value")),
            ("z", texts("sliders.zero")),
            ("r", "Randomize"),
            ("c", "Center"),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        return [
            (f"Shift {arrows}", texts("reconfigure.far")),
            (f"Ctrl {arrows}", texts("sliders.finest")),
            ("Home End", texts("reconfigure.ends")),
            ("d", texts("sliders.degrees")),
        ]

    def _press(self, key: str, character: str) -> bool:
        slider = self._slider()
        if slider is None:
            return False
        if self._typed is not None:
            return self._type(key, character, slider)
        if key in SLIDER_STEPS or key in SLIDER_FINEST:
            moved = STEP * SLIDER_STEPS[key] if key in SLIDER_STEPS else SLIDER_FINEST[key]
            self._request("step", slider.name, slider.step + moved)
        elif key in ("home", "end"):
            self._request("value", slider.name, slider.minimum if key == "home" else slider.maximum)
        elif (steps := list_steps(key, self.inner_height // self._lines_each, ends=False)) is not None:
            self._choose(self._index() + steps)
        elif character == "z":
            self._request("zero", slider.name)
        elif character == "d":
            self._toggle_degrees()
        elif character in ("r", "c"):
            self._request("randomize" if character == "r" else "center")
        elif key == "enter" or character in BEGINS_NUMBER:
            self._typed = "" if key == "enter" else character
        else:
            return False
        return True

    def _type(self, key: str, character: str, slider: Slider) -> bool:
        typed = self._typed or ""
        if key == "escape":
            self._typed = None
        elif key == "enter":
            self._typed = None
            number = _number(typed)
            if number is not None:
                self._request("value", slider.name, math.radians(number) if self._in_degrees(slider) else number)
        elif key == "backspace":
            self._typed = typed[:-1]
        elif character and character in "0123456789.-+eE" and len(typed) < VALUE_WIDTH - 2:
            self._typed = typed + character
        elif key in ("up", "down"):
            self._typed = None
            self._choose(self._index() + (1 if key == "down" else -1))
        return True

    def _choose(self, index: int) -> None:
        sliders = self.model.sliders
        if sliders:
            self._chosen = sliders[max(0, min(len(sliders) - 1, index))].name

    def _toggle_degrees(self) -> None:
        self._degrees = not self._degrees
        self.touch()
        self.look.wake()

    def _request(self, kind: str, joint: str = "", number: float = 0.0) -> None:
        self.model.request(kind, joint, number)

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _at(self, y: int) -> Slider | None:
        """The slider in this line of the pane."""
        line = y - self.inner_offset - 1
        index = self._first + line // self._lines_each
        return self.model.sliders[index] if line >= 0 and index < len(self.model.sliders) else None

    def _is_on_number(self, x: int, y: int) -> bool:
        """Whether this cell belongs to the number of a slider, which stands at the right of its first line."""
        first = (y - self.inner_offset - 1) % self._lines_each == 0
        return first and x - self.inner_offset >= self.inner_width - VALUE_WIDTH - UNIT_WIDTH

    def _drag_to(self, x: int) -> None:
        column, width = self._tracks.get(self._dragged, (0, 2))
        share = (x - self.inner_offset - column) / max(width - 1, 1)
        self._request("step", self._dragged, round(min(max(share, 0.0), 1.0) * RANGE))

    def on_mouse_down(self, event: events.MouseDown) -> None:
        slider = self._at(event.y)
        if event.button != 1 or slider is None:
            return
        self._typed = None
        self._chosen = slider.name
        column, width = self._tracks.get(slider.name, (0, 0))
        if self._is_on_number(event.x, event.y):
            self._typed = ""
        elif column - 1 <= event.x - self.inner_offset <= column + width:
            self._dragged = slider.name
            self.capture_mouse()
            self._drag_to(event.x)
        self._redraw()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._dragged:
            self._drag_to(event.x)

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._dragged:
            self._dragged = ""
            self.release_mouse()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._choose(self._index() + notches)
        self._redraw()


def _knob(step: int, width: int) -> int:
    return min(max(round(step * (width - 1) / RANGE), 0), width - 1)


def _step_of(slider: Slider, value: float) -> int:
    return int((value - slider.minimum) * RANGE / (slider.maximum - slider.minimum))


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
