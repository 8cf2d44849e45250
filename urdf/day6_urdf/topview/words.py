"""What is written beside a robot seen from above, where there is room for it.

Readings of a wheel stand on the wheel's own row, or as near as they fit; what doesn't fit is shortened by whole parts, the link's
name first. Text never covers a part of the robot, but for the chassis' name and the length of the axle, which stand on it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from day6_urdf.kinematics import Transform
from day6_urdf.topview.canvas import cell_width
from day6_urdf.topview.frame import ARROW_COLUMNS, TopFrame, Tyre
from day6_urdf.topview.paint import axles, is_known
from day6_urdf.topview.plan import flat

Labels = Mapping[str, Sequence[str]]
"""By link: its name, then what is measured of it, the most important first."""


class Word(NamedTuple):
    """Text from a cell to the right, and its role: 'label', 'missing', 'axle', 'name' or 'scale'."""

    column: int
    row: int
    text: str
    role: str


class _Room:
    """Which cells of a picture are free for text."""

    def __init__(self, frame: TopFrame, tyres: Sequence[Tyre], at: Mapping[str, Transform]) -> None:
        self._frame = frame
        self._taken: list[list[tuple[int, int]]] = [[] for _ in range(frame.rows)]
        for body in frame.plan.bodies:
            spots = [flat(at[body.link], point) for point in body.points]
            self._take_box(
                (min(x for x, _ in spots) - body.radius, max(y for _, y in spots) + body.radius),
                (max(x for x, _ in spots) + body.radius, min(y for _, y in spots) - body.radius),
            )
        for tyre in tyres:
            across, up = tyre.reach()
            self._take_box((tyre.x - across, tyre.y + up), (tyre.x + across, tyre.y - up))
        column, row = frame.cell((frame.front, 0.0))
        for near in (row - 1, row):
            self._take(near, column, column + ARROW_COLUMNS)

    def _take_box(self, corner: tuple[float, float], opposite: tuple[float, float]) -> None:
        left, top = self._frame.place(corner)
        right, bottom = self._frame.place(opposite)
        across, down = self._frame.dots
        first, last = math.floor(top / down + 0.01), math.ceil(bottom / down - 0.01)
        for row in range(max(first, 0), min(last, self._frame.rows)):
            self._take(row, math.floor(left / across), math.ceil(right / across))

    def _take(self, row: int, start: int, end: int) -> None:
        if 0 <= row < self._frame.rows:
            self._taken[row].append((start, end))

    def is_free(self, column: int, row: int, width: int) -> bool:
        """Whether so many cells are inside and free, with one more to the next thing on either side."""
        if not 0 <= row < self._frame.rows or column < 0 or column + width > self._frame.columns:
            return False
        return all(end + 1 <= column or column + width + 1 <= start for start, end in self._taken[row])

    def holds(self, words: Sequence[Word]) -> bool:
        """Whether there is room for all of these."""
        return all(self.is_free(word.column, word.row, cell_width(word.text)) for word in words)

    def put(self, word: Word) -> bool:
        """Take the cells of a text; False, and nothing is taken, where they are not free."""
        width = cell_width(word.text)
        if not width or not self.is_free(word.column, word.row, width):
            return False
        self._take(word.row, word.column, word.column + width)
        return True


def words_of(frame: TopFrame, given: Mapping[str, Transform], labels: Labels) -> list[Word]:
    """What is written beside the robot of `frame`; links without a label of their own have their names at wheels."""
    plan = frame.plan
    at = {**plan.rest, **given}
    tyres = frame.tyres(at)
    room = _Room(frame, tyres, at)
    words = [*_axle_words(frame, tyres, at), *_name_of_the_chassis(frame, at, labels)]
    choices = []
    for tyre in tyres:
        link = tyre.wheel.joint.child
        role = "label" if is_known(plan, link, given) else "missing"
        choices.append(list(_places(frame, tyre, labels.get(link, (link,)), role)))
    # The same place at all wheels, if there is one; else what there is at each.
    common = next((place for place in zip(*choices, strict=False) if all(map(room.holds, place))), ())
    for number, choice in enumerate(choices):
        for place in [*common[number : number + 1], *choice]:
            if room.holds(place):
                words += [word for word in place if room.put(word)]
                break
    wheels = {tyre.wheel.joint.child for tyre in tyres}
    others = [(link, parts) for link, parts in labels.items() if link not in wheels and len(parts) > 1]
    for row, (link, parts) in enumerate(others):
        word = Word(1, row, " ".join(parts), "label" if is_known(plan, link, given) else "missing")
        if room.put(word):
            words.append(word)
    scale = _scale(frame)
    if scale is not None and room.put(scale):
        words.append(scale)
    return words


def _places(frame: TopFrame, tyre: Tyre, parts: Sequence[str], role: str) -> Iterator[list[Word]]:
    """Where the parts of a label may stand, the best place first; the last ones leave parts out."""
    (left, _), (right, _) = (frame.cell((tyre.x + way * tyre.reach()[0], tyre.y)) for way in (-1, 1))
    right += 1 if frame.dots[0] > 1 else 0
    _, middle = frame.cell((tyre.x, tyre.y))
    up = frame.place((tyre.x, tyre.y))[1] < frame.height / 2
    row = middle if frame.dots[1] == 1 and tyre.reach()[1] * frame.down < 1 else _outer_row(frame, tyre, up)

    def after(text: str, line: int) -> Word:
        return Word(right + 2, line, text, role)

    def before(text: str, line: int) -> Word:
        return Word(left - 1 - cell_width(text), line, text, role)

    whole = " ".join(parts)
    column = frame.cell((tyre.x, tyre.y))[0] - cell_width(whole) // 2
    column = max(0, min(column, frame.columns - cell_width(whole)))
    yield [after(whole, row)]
    yield [before(whole, row)]
    if len(parts) > 2:
        yield [before(" ".join(parts[:2]), row), after(" ".join(parts[2:]), row)]
    yield [Word(column, row - 1 if up else row + 1, whole, role)]
    measured = parts[1:]
    if len(measured) > 1:
        yield [before(measured[0], row), after(" ".join(measured[1:]), row)]
    for count in range(len(measured), 0, -1):
        yield [after(" ".join(measured[:count]), row)]
        yield [before(" ".join(measured[:count]), row)]


def _outer_row(frame: TopFrame, tyre: Tyre, up: bool) -> int:
    """The row of a wheel that is farthest from the body, or the middle one of a thick wheel."""
    half = tyre.reach()[1]
    if half * frame.down > 2 * frame.dots[1]:
        return frame.cell((tyre.x, tyre.y))[1]
    y = frame.place((tyre.x, tyre.y + half if up else tyre.y - half))[1] / frame.dots[1]
    return math.floor(y + 0.3) if up else math.ceil(y - 0.3) - 1


def _axle_words(frame: TopFrame, tyres: Sequence[Tyre], at: Mapping[str, Transform]) -> Iterator[Word]:
    """The length of an axle beside it, on the chassis; that of several alike is written once."""
    said = set()
    edge = max(
        (frame.cell(flat(at[body.link], point))[0] for body in frame.plan.bodies for point in body.points), default=0
    )
    for one, two, length in axles(tyres):
        column, top = frame.cell((one.x, max(one.y, two.y)))
        bottom = frame.cell((one.x, min(one.y, two.y)))[1]
        text = f"{length:.2f} m"
        if text in said or not (one.straight and two.straight):
            continue
        if bottom - top >= 5 and column + 2 + len(text) <= edge - 1:
            said.add(text)
            _, middle = frame.cell((0.0, 0.0))
            # Above the middle line: on it are casters, and the arrow.
            yield Word(column + 2, max(top + 2, middle - max(2, (bottom - top) // 5)), text, "axle")


def _name_of_the_chassis(frame: TopFrame, at: Mapping[str, Transform], labels: Labels) -> Iterator[Word]:
    """The name of the chassis on its rear."""
    for body in frame.plan.bodies:
        if body.style == "chassis" and len(body.points) > 1:
            cells = [frame.cell(flat(at[body.link], point)) for point in body.points]
            left, right = min(x for x, _ in cells), max(x for x, _ in cells)
            top, bottom = min(y for _, y in cells), max(y for _, y in cells)
            text = " ".join(labels.get(body.link, (body.link,)))
            if any(other.style == "body" for other in frame.plan.bodies):
                return  # there may be something on the rear
            if cell_width(text) + 4 < 0.4 * (right - left) and bottom - top > 5:
                yield Word(
                    left + round(0.22 * (right - left)) - cell_width(text) // 2 + 1, (top + bottom) // 2, text, "name"
                )
            return


def _scale(frame: TopFrame) -> Word | None:
    """A bar of a round length in the last row; none beside a robot without extent."""
    left, _, right, _ = frame.plan.bounds
    if right - left < 1e-6:
        return None
    column = frame.dots[0] / frame.metre
    wanted = column * max(frame.columns, 1) / 5
    power = 10.0 ** math.floor(math.log10(wanted))
    length = power * max((step for step in (1, 2, 5) if step * power <= wanted), default=1)  # `power` may be rounded up
    cells = round(length / column)
    if cells < 3:
        return None
    return Word(1, frame.rows - 1, f"|{'-' * (cells - 1)}| {length:g} m", "scale")
