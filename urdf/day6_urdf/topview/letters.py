"""A robot drawn with ASCII characters alone: it reads as a car on a plain console, without colour.

The frame of a wheel never moves; inside it only the tread `|` and the mark `##` do, and what the mark leaves behind it. The
rear of the chassis is shaded, its front has lamps `[]`, and the axle runs across.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from day6_urdf.kinematics import Transform
from day6_urdf.topview.canvas import Canvas
from day6_urdf.topview.frame import Spot, TopFrame, Tyre
from day6_urdf.topview.paint import BLUR, Turning, axles, bars_of, is_known, tail, tread_marks
from day6_urdf.topview.plan import Body, flat, hull, spin_of

_LINES = "++++-|"


class Letters:
    """Draws one picture on a canvas; a cell is one dot of the frame."""

    def __init__(self, canvas: Canvas, frame: TopFrame, given: Mapping[str, Transform], turning: Turning) -> None:
        self._canvas, self._frame, self._given, self._turning = canvas, frame, given, turning
        self._at = {**frame.plan.rest, **given}

    def draw(self) -> None:
        """Draw everything, from the ground up."""
        plan, tyres = self._frame.plan, self._frame.tyres(self._at)
        for body in plan.bodies:
            if body.style != "caster":
                self._draw_body(body)
        for one, two, _ in axles(tyres):
            self._draw_axle(one, two)
        for body in plan.bodies:
            if body.style == "caster":
                self._draw_circle(
                    flat(self._at[body.link], body.points[0]), body.radius, self._style(body.link, "caster")
                )
        for tyre in tyres:
            if tyre.straight and not tyre.wheel.ball:
                self._draw_tyre(tyre)
            else:
                self._draw_slanted(tyre)
        self._draw_arrow()

    def _cell(self, spot: Spot) -> tuple[int, int]:
        """The cell whose middle is nearest."""
        x, y = self._frame.snapped(spot)
        return x, y

    def _style(self, link: str, style: str) -> str:
        return style if is_known(self._frame.plan, link, self._given) else "missing"

    # -- bodies --------------------------------------------------------------------------------------------------------

    def _draw_body(self, body: Body) -> None:
        transform, style = self._at[body.link], self._style(body.link, body.style)
        points = [flat(transform, point) for point in body.points]
        if len(points) == 1:
            if body.radius > 0:
                self._draw_circle(points[0], body.radius, style)
            else:
                self._canvas.put(*self._cell(points[0]), "x", style)
            return
        outline = hull(points)
        left, right = min(x for x, _ in outline), max(x for x, _ in outline)
        low, high = min(y for _, y in outline), max(y for _, y in outline)
        slack = 0.6 / self._frame.metre
        if all(min(x - left, right - x) <= slack and min(y - low, high - y) <= 2 * slack for x, y in outline):
            self._draw_box(
                (left, low), (right, high), style, front=body.style == "chassis" and bool(self._frame.plan.wheels)
            )
            return
        cells = [self._cell(spot) for spot in outline]
        for start, end in zip(cells, cells[1:] + cells[:1], strict=True):
            self._canvas.line(*start, *end, _LINES, style)

    def _draw_box(self, low: Spot, high: Spot, style: str, front: bool) -> None:
        left, bottom = self._cell(low)
        right, top = self._cell(high)
        right, bottom = max(right - 1, left), max(bottom - 1, top)
        self._canvas.box(left, top, right, bottom, _LINES, style)
        if not front or right - left < 8 or bottom - top < 3:
            return
        rear, first = left + round((right - left) * 0.45), max(left + 1, 0)
        deep = 1 + (bottom - top) // 7
        for row in range(max(top + 1, 0), min(bottom, self._canvas.height)):
            self._canvas.text(first, row, ":" * min(rear - first, self._canvas.width), "shade")
            if row <= top + deep or row >= bottom - deep:
                self._canvas.text(right - 1, row, "[]", "lamp")

    def _draw_circle(self, spot: Spot, radius: float, style: str) -> None:
        frame = self._frame
        x, y = frame.place(spot)
        column, row = math.floor(x), math.floor(y)
        reach, wide = int(radius * frame.down + 0.3), radius * frame.metre
        for step in range(max(-reach, -row), min(reach, self._canvas.height - 1 - row) + 1):
            share = math.sqrt(max(1 - (step / frame.down / radius) ** 2, 0.0)) if reach else 1.0
            half = min(max(int(wide * share + 0.5), 1 if wide > 0.4 else 0), 4 * self._canvas.width + abs(column))
            if reach and abs(step) == reach:
                edge = "." if step < 0 else "'"
                text = edge + "-" * (2 * half - 1) + edge if half else edge
                self._canvas.text(column - half, row + step, text, style)
            elif half:
                self._canvas.text(column - half, row + step, "(" + " " * (2 * half - 1) + ")", style)
            else:
                self._canvas.put(column, row, "o", style)

    def _draw_axle(self, one: Tyre, two: Tyre) -> None:
        if not (one.straight and two.straight):
            return
        column, top = self._cell((one.x, max(one.y, two.y)))
        _, bottom = self._cell((one.x, min(one.y, two.y)))
        for row in range(max(top, 0), min(bottom, self._canvas.height)):
            self._canvas.text(column - 1, row, "||", "axle")

    def _draw_arrow(self) -> None:
        column, row = self._frame.cell((self._frame.front, 0.0))
        self._canvas.text(column + 1, row, "====>" if self._canvas.width > 30 else "==>", "arrow")

    # -- wheels --------------------------------------------------------------------------------------------------------

    def _draw_tyre(self, tyre: Tyre) -> None:
        """A wheel parallel to the body: a frame, and in each of its columns what of the tread is there."""
        frame, link = self._frame, tyre.wheel.joint.child
        left, top = frame.snapped((tyre.x - tyre.half_length, tyre.y + tyre.half_width))
        right, bottom = frame.snapped((tyre.x + tyre.half_length, tyre.y - tyre.half_width))
        right, bottom = max(right, left + 3), max(bottom, top + 1)
        known = link in self._given
        inside = self._tread(tyre, right - left - 2) if known else [("?", "missing")] * (right - left - 2)
        style = "wheel" if known else "missing"
        high = bottom - top
        for row in range(top, bottom):
            ends = "()" if high == 1 else ".." if row == top else "''" if row == bottom - 1 else "[]"
            self._canvas.put(left, row, ends[0], style)
            for offset, (character, role) in enumerate(inside):
                self._canvas.put(left + 1 + offset, row, character, role)
            self._canvas.put(right - 1, row, ends[1], style)

    def _tread(self, tyre: Tyre, cells: int) -> list[tuple[str, str]]:
        """The characters inside a frame of so many cells, from left to right, with their styles."""
        spin, half = spin_of(tyre.wheel, self._at), tyre.half_length
        speed = self._turning.speeds.get(tyre.wheel.joint.child, 0.0)
        dot = 2 * half / max(cells, 1)
        blurred = abs(speed) * self._turning.gap > BLUR * 2 * math.pi / bars_of(half, dot)
        row = [("-" if blurred else "=", "wheel")] * cells

        def put(start: float, end: float, character: str, style: str) -> None:
            first, last = sorted((self._along(tyre, start, dot, cells), self._along(tyre, end, dot, cells)))
            for cell in range(first, last + 1):
                row[cell] = character, style

        marks = tread_marks(half, spin, dot)
        for place, first in marks:
            if not first and not blurred:
                put(place, place, "|", "wheel")
        for start, end in tail(half, spin, speed):
            put(start, end, "*", "tail")
        for place, first in marks:
            if first:
                put(place - dot / 2, place + dot / 2, "#", "mark")
        return row

    def _along(self, tyre: Tyre, place: float, dot: float, cells: int) -> int:
        forwards = place if tyre.heading[0] > 0 else -place
        return min(max(math.floor((forwards + tyre.half_length) / dot), 0), cells - 1)

    def _draw_slanted(self, tyre: Tyre) -> None:
        """A wheel at an angle, or a ball: every cell whose middle it covers."""
        frame, (hx, hy), link = self._frame, tyre.heading, tyre.wheel.joint.child
        known = link in self._given
        marks = tread_marks(tyre.half_length, spin_of(tyre.wheel, self._at), 1.2 / frame.metre) if known else []
        reach = max(abs(hx) / frame.metre, abs(hy) / frame.down) / 2
        x, y = frame.place((tyre.x, tyre.y))
        across, up = (max(side, 0.3 / frame.metre) for side in tyre.reach())
        half_width = max(tyre.half_width, 0.5 / frame.down * abs(hx), 0.5 / frame.metre * abs(hy))
        rows = range(math.floor(y - up * frame.down), math.ceil(y + up * frame.down) + 1)
        columns = range(math.floor(x - across * frame.metre), math.ceil(x + across * frame.metre) + 1)
        width, height = self._canvas.width, self._canvas.height
        cells = [(column, row) for row in rows if 0 <= row < height for column in columns if 0 <= column < width]
        drawn = 0
        for column, row in cells:
            dx, dy = (column + 0.5 - x) / frame.metre, -(row + 0.5 - y) / frame.down
            along, side = dx * hx + dy * hy, dy * hx - dx * hy
            covered = (
                math.hypot(along, side) <= tyre.half_length
                if tyre.wheel.ball
                else abs(along) <= tyre.half_length and abs(side) <= half_width
            )
            if covered:
                drawn += 1
                self._put_slanted(column, row, along, reach, marks, known)
        if not drawn:
            self._put_slanted(math.floor(x), math.floor(y), 0.0, reach, marks, known)

    def _put_slanted(
        self, column: int, row: int, along: float, reach: float, marks: list[tuple[float, bool]], known: bool
    ) -> None:
        shown, style = ("=", "wheel") if known else ("?", "missing")
        for place, first in marks:
            if abs(place - along) <= reach:
                shown, style = ("#", "mark") if first else ("|", "wheel")
                if first:
                    break
        self._canvas.put(column, row, shown, style)
