"""The kitchen as characters: cooks stand side by side, each with a line down from it, and every belt runs across below them.

What is drawn is decided here, without a widget: `Plan` knows where everybody stands, `draw_cooks` and `draw_belts` fill canvases,
`dish_places` says where dishes are. Rows of belts count from the first one, columns from the first cook.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from day6_core.ros.programs.day6_kitchen.belts import Belt, Content, Cook, Hand
from day6_core.ros.programs.day6_kitchen.dishes import Dish, Dishes
from day6_core.ros.programs.rqt_graph.model.drawing import CellCanvas
from day6_tui.panes.cells import cell_len, clip

NARROWEST, WIDEST = 14, 30
"""Columns for one cook."""

STUB = 6
"""Cells of a belt that has nobody at its other end."""

DISH = 3
"""Cells of a dish."""

TALL = 14
"""Lines from which cooks have a frame around them, and belts a line between them."""


@dataclass(frozen=True)
class Glyphs:
    """The characters of a kitchen. `corners`: top left, top right, bottom left, bottom right of a cook's frame."""

    corners: str
    across: str
    upright: str
    down: str
    """Where the line goes down from a frame."""
    belt: str
    crossing: str
    """A belt that passes behind a cook's line."""
    gives: str
    right: str
    left: str
    ends_right: str
    ends_left: str
    gap: str
    """A belt on which nothing lies."""
    refused: str


UNICODE = Glyphs("╭╮╰╯", "─", "│", "┬", "═", "╪", "■", "►", "◄", "┤", "├", "·", "×")
CONSOLE = Glyphs("┌┐└┘", "─", "│", "┬", "═", "╪", "■", "►", "◄", "┤", "├", "·", "x")
ASCII = Glyphs("++++", "-", "|", "+", "=", "#", "#", ">", "<", "|", "|", ".", "x")

GLYPHS = {"half": UNICODE, "braille": UNICODE, "cell": CONSOLE, "ascii": ASCII}
"""By the canvas of a set of glyphs."""


class KitchenPlan:
    """Where everybody stands in a window of `columns` x `lines` cells."""

    def __init__(self, content: Content, columns: int, lines: int) -> None:
        self.content = content
        self.pitch = max(NARROWEST, min(WIDEST, columns // max(1, len(content.cooks))))
        self.width = self.pitch * len(content.cooks)
        self.framed = lines >= TALL
        self.head = 3 if self.framed else 1
        """Lines of the cooks."""
        self.step = 3 if lines - self.head >= 3 * len(content.belts) else 2
        """Lines of a belt."""
        self.height = self.step * len(content.belts)
        self._lanes = {cook.name: index * self.pitch + self.pitch // 2 for index, cook in enumerate(content.cooks)}

    def lane(self, cook: str) -> int:
        """The column of a cook's line."""
        return self._lanes[cook]

    def cook_at(self, column: int) -> Cook | None:
        """The cook who stands there."""
        index = column // self.pitch
        return self.content.cooks[index] if 0 <= index < len(self.content.cooks) else None

    def cooks_between(self, first: int, end: int) -> Sequence[Cook]:
        """The cooks who stand from a column to before another one."""
        return self.content.cooks[max(0, first // self.pitch) : max(0, -(-end // self.pitch))]

    def belt_at(self, row: int) -> Belt | None:
        """The belt of a row."""
        index = row // self.step
        return self.content.belts[index] if 0 <= index < len(self.content.belts) else None

    def belts_between(self, first: int, end: int) -> Iterator[tuple[int, Belt]]:
        """The belts that are seen, wholly or in part, from a row to before another one, each with its first row."""
        for index in range(max(0, first // self.step), min(len(self.content.belts), -(-end // self.step))):
            yield index * self.step, self.content.belts[index]

    def row(self, topic: str) -> int:
        """The first row of a belt."""
        return next(index for index, belt in enumerate(self.content.belts) if belt.topic == topic) * self.step

    def ends(self, belt: Belt) -> tuple[int, int]:
        """The first and the last column of a belt, stubs among them."""
        lanes = [self.lane(hand.cook) for hand in (*belt.givers, *belt.takers)]
        first, last = min(lanes), max(lanes)
        if not belt.givers:
            first -= STUB
        if not belt.takers or first == last:
            last += STUB
        return first, last


def draw_cooks(canvas: CellCanvas, plan: KitchenPlan, glyphs: Glyphs, chosen: str, ellipsis: str) -> None:
    """The cooks, in the lines above the belts."""
    for cook in plan.cooks_between(canvas.left, canvas.left + canvas.width):
        lane = plan.lane(cook.name)
        name = cook.name + (f" ×{cook.count}" if cook.count > 1 else "")
        text = clip(name.removeprefix("/"), plan.pitch - (5 if plan.framed else 1), ellipsis)
        size = cell_len(text)
        style = "chosen" if cook.name == chosen else "cook"
        if plan.framed:
            left = lane - (size + 2) // 2
            frame = "accent" if cook.name == chosen else "frame"
            across = glyphs.across * (size + 2)
            canvas.put(left - 1, 0, glyphs.corners[0] + across + glyphs.corners[1], frame)
            canvas.put(left - 1, 1, f"{glyphs.upright}{' ' * (size + 2)}{glyphs.upright}", frame)
            canvas.put(left, 1, f" {text} ", style)
            canvas.put(left - 1, 2, glyphs.corners[2] + across + glyphs.corners[3], frame)
            canvas.put(lane, 2, glyphs.down, frame)
        else:
            canvas.put(lane - size // 2, 0, text, style)


Label = Callable[[Belt], Sequence[tuple[str, str]]]
"""The words above a belt as runs of text and style, for any room."""


def draw_belts(canvas: CellCanvas, plan: KitchenPlan, glyphs: Glyphs, dishes: Dishes, label: Label) -> None:
    """The lines of all cooks, and the belts across them."""
    for cook in plan.cooks_between(canvas.left, canvas.left + canvas.width):
        for row in range(canvas.top, canvas.top + canvas.height):
            canvas.put(plan.lane(cook.name), row, glyphs.upright, "frame")
    for row, belt in plan.belts_between(canvas.top, canvas.top + canvas.height):
        _draw_label(canvas, plan, belt, row, label(belt))
        _draw_belt(canvas, plan, belt, row + 1, glyphs, dishes)


def _draw_label(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, runs: Sequence[tuple[str, str]]) -> None:
    room = sum(cell_len(text) for text, _ in runs)
    x = max(canvas.left, min(plan.ends(belt)[0] + 2, canvas.left + canvas.width - room))
    for text, style in runs:
        canvas.put(x, row, text, style)
        x += cell_len(text)


def _draw_belt(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, glyphs: Glyphs, dishes: Dishes) -> None:
    first, last = plan.ends(belt)
    empty = not belt.givers and not belt.unseen_givers
    line = glyphs.gap if empty else glyphs.belt
    style = "warning" if belt.refusals else "faint" if belt.lonely else "belt"
    canvas.put(first, row, line * (last - first + 1), style)
    lanes = {hand.cook: plan.lane(hand.cook) for hand in (*belt.givers, *belt.takers)}
    for cook in plan.cooks_between(canvas.left, canvas.left + canvas.width):
        lane = plan.lane(cook.name)
        if first < lane < last:
            canvas.put(lane, row, glyphs.crossing if line == glyphs.belt else glyphs.upright, style)
    if not belt.givers:
        canvas.put(first, row, "?" if belt.unseen_givers else glyphs.gap, style)
    if not belt.takers:
        canvas.put(last, row, "?" if belt.unseen_takers else glyphs.gap, style)
    for taker in belt.takers:
        lane = lanes[taker.cook]
        if lane in (first, last):
            canvas.put(lane, row, glyphs.ends_left if lane == first else glyphs.ends_right, style)
        for from_left in _sides(plan, belt, taker):
            _draw_hatch(canvas, belt, taker, lane, row, glyphs, dishes, from_left=from_left)
    for giver in belt.givers:
        canvas.put(lanes[giver.cook], row, glyphs.gives, "gives")


def _sides(plan: KitchenPlan, belt: Belt, taker: Hand) -> list[bool]:
    """From which sides dishes come to a taker: True for the left."""
    lane = plan.lane(taker.cook)
    others = [plan.lane(giver.cook) for giver in belt.givers]
    found = [True] if any(other < lane for other in others) or not others else []
    return [*found, False] if any(other >= lane for other in others) else found


def _draw_hatch(
    canvas: CellCanvas, belt: Belt, taker: Hand, lane: int, row: int, glyphs: Glyphs, dishes: Dishes, *, from_left: bool
) -> None:
    """Where a taker takes: an arrow, or the shape that is waited for in vain."""
    refusal = belt.refusal_of(taker)
    if refusal is None:
        canvas.put(lane - 1 if from_left else lane + 1, row, glyphs.right if from_left else glyphs.left, "takes")
        return
    wanted = dishes.of(taker.type).text if refusal.why == "type" else "QoS"
    text = glyphs.refused + wanted if from_left else wanted + glyphs.refused
    canvas.put(lane - len(text) if from_left else lane + 1, row, text, "warning")


class Way(NamedTuple):
    """The way of the dishes of one cook on one belt: columns of the dish's left edge at the beginning and at the end."""

    giver: Hand
    start: int
    end: int


def ways(plan: KitchenPlan, belt: Belt) -> Iterator[Way]:
    """The ways of all dishes on a belt: from each giver to the farthest taker on either side, or off the end."""
    places = []
    """Of each taker: the column of its line, and how many cells before it a dish stops."""
    for taker in belt.takers:
        places.append((plan.lane(taker.cook), DISH + 1 if belt.refusal_of(taker) is not None else 1))
    first, last = min(places, default=(0, 0)), max(places, default=(0, 0))
    off_the_end = plan.ends(belt)[1] - DISH + 1
    for giver in belt.givers:
        lane = plan.lane(giver.cook)
        to_the_left = bool(places) and first[0] < lane
        if places and last[0] > lane:
            yield Way(giver, lane + 1, max(lane + 1, last[0] - last[1] - DISH))
        elif not to_the_left:
            yield Way(giver, lane + 1, max(lane + 1, off_the_end))
        if to_the_left:
            yield Way(giver, lane - DISH, min(lane - DISH, first[0] + first[1] + 1))


def dish_places(way: Way, on_the_way: Sequence[float]) -> list[int]:
    """The columns of the dishes' left edges when they have made these parts (0 to 1) of their way, the first one first.

    Of dishes that would lie on each other only the first is drawn.
    """
    found: list[int] = []
    for progress in on_the_way:
        place = round(way.start + (way.end - way.start) * min(1.0, max(0.0, progress)))
        if not found or abs(place - found[-1]) > DISH:
            found.append(place)
    return found


def words_of(
    belt: Belt, dishes: Dishes, rate: str, note: str, room: int, style: str, ellipsis: str
) -> list[tuple[str, str]]:
    """The label of a belt: its name, the dish with its type, the rate, what is wrong; in at most `room` cells."""
    shapes: list[tuple[str, Dish]] = [(kind, dishes.of(kind)) for kind in dict.fromkeys(h.type for h in belt.givers)]
    shapes = shapes or [(kind, dishes.of(kind)) for kind in belt.types[:1]]
    tail = [(f" {text}", "muted") for text in (rate,) if text] + [(f" {note}", "warning")] * bool(note)
    for with_types in (True, False):
        runs = []
        for kind, dish in shapes:
            runs.append((f" {dish.text}", f"dish{dish.colour}"))
            if with_types:
                runs.append((f" {kind.rsplit('/', 1)[-1]}", "muted"))
        runs += tail
        size = sum(cell_len(text) for text, _ in runs)
        if size + cell_len(belt.topic) <= room or not with_types:
            break
    left = max(8, room - size)
    topic = belt.topic
    if cell_len(topic) > left:  # the end tells more than the beginning
        while cell_len(topic) + cell_len(ellipsis) > left:
            topic = topic[1:]
        topic = ellipsis + topic
    return [(topic, style), *runs]
