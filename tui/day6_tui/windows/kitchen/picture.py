"""The kitchen as characters: cooks behind their counters, and the belts that run between those, under all others.

Pure: what is drawn follows from the plan, the counts and the places of the dishes. The names of styles are the window's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from day6_core.ros.programs.day6_kitchen.belts import Belt, Cook, Hand
from day6_core.ros.programs.day6_kitchen.dishes import Dish, Dishes
from day6_core.ros.programs.rqt_graph.model.drawing import CellCanvas
from day6_tui.panes.cells import cell_len
from day6_tui.windows.kitchen.figures import Glyphs
from day6_tui.windows.kitchen.plan import PILE, SIDE, KitchenPlan, Way, clipped, ways

SMALL, LARGE = 3, 5
"""Cells of a dish across: in the belt or on it, and where it has two lines."""

ARROWS = 6
"""From one arrow on a belt to the next."""

LEAST_NAME = 12
"""Cells that the name of a topic has in any case."""

PARTS = {"h": "hat", "f": "face", "s": "hand", "j": "jacket"}
"""The styles of a figure's parts."""

Label = Callable[[Belt, int], Sequence[tuple[str, str]]]
"""The words above a belt as runs of text and style, for so many cells."""


def draw_cooks(canvas: CellCanvas, plan: KitchenPlan, glyphs: Glyphs, chosen: str) -> None:
    """The cooks, and their names on the desks before them, in the lines above the belts."""
    for cook in plan.cooks_between(canvas.left, canvas.left + canvas.width):
        lane = plan.lane(cook.name)
        _draw_figure(canvas, plan, lane)
        _draw_desk(canvas, plan, cook, lane, glyphs, "chosen" if cook.name == chosen else "desk")


def _draw_figure(canvas: CellCanvas, plan: KitchenPlan, lane: int) -> None:
    left = lane - plan.figure.width // 2 if plan.figure.rows else lane
    for row, (text, parts) in enumerate(zip(plan.figure.rows, plan.figure.parts, strict=True)):
        for column, (character, part) in enumerate(zip(text, parts, strict=True)):
            if part != " ":
                canvas.put(left + column, plan.top + row, character, PARTS[part])


def _draw_desk(canvas: CellCanvas, plan: KitchenPlan, cook: Cook, lane: int, glyphs: Glyphs, style: str) -> None:
    lines = plan.names[cook.name]
    size = max(map(cell_len, lines))
    left = lane - size // 2
    for y, line in enumerate(lines, plan.head - plan.name_lines):
        before = (size - cell_len(line)) // 2
        text = f"{glyphs.desk[0]}{' ' * before}{line}{' ' * (size - before - cell_len(line))}{glyphs.desk[1]}"
        canvas.put(left - 1, y, text, style)
        if glyphs.fine:  # its ends are half a cell each, in the colour of the desk
            canvas.put(left - 1, y, glyphs.desk[0], f"{style} end")
            canvas.put(left + size, y, glyphs.desk[1], f"{style} end")
    for y in range(plan.head - plan.name_lines + len(lines), plan.head if plan.reaches(cook.name, 0) else 0):
        canvas.put(lane - SIDE, y, glyphs.counter, "counter")


def draw_belts(
    canvas: CellCanvas, plan: KitchenPlan, glyphs: Glyphs, dishes: Dishes, label: Label, left: dict[str, int]
) -> None:
    """The belts that are seen, with what is `left` on them by topic, the counters over them, and their words over all."""
    seen = list(plan.belts_between(canvas.top, canvas.top + canvas.height))
    for row, belt in seen:
        _draw_belt(canvas, plan, belt, plan.running(row // plan.step), glyphs)
        _draw_pile(canvas, plan, belt, row, dishes, left.get(belt.topic, 0))
    for cook in plan.cooks_between(canvas.left, canvas.left + canvas.width):
        for row in range(canvas.top, canvas.top + canvas.height):
            if plan.reaches(cook.name, row):
                canvas.put(plan.lane(cook.name) - SIDE, row, glyphs.counter, "counter")
    for row, belt in seen:
        _draw_hands(canvas, plan, belt, plan.running(row // plan.step), glyphs, dishes)
        _draw_label(canvas, plan, belt, row, label)


def _draw_label(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, label: Label) -> None:
    start, end = max(canvas.left, plan.ends(belt)[0] + 1), canvas.left + canvas.width
    runs = label(belt, end - start)
    x = max(canvas.left, min(start, end - sum(cell_len(text) for text, _ in runs)))
    for text, style in runs:
        canvas.put(x, row, text, style)
        x += cell_len(text)


def _draw_belt(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, glyphs: Glyphs) -> None:
    first, last = plan.ends(belt)
    style = "belt warning" if belt.refusals else "belt"
    if not belt.givers and not belt.unseen_givers:
        canvas.put(first, row, glyphs.gap * (last - first + 1), "faint")
        return
    canvas.put(first, row, glyphs.belt * (last - first + 1), style)
    for way in ways(plan, belt, 1):
        onward = way.end >= way.start
        for column in range(way.start + (3 if onward else -3), way.end, ARROWS if onward else -ARROWS):
            canvas.put(column, row, glyphs.onward if onward else glyphs.backward, style)
    if not belt.givers:
        canvas.put(first, row, "?", style)
    if not belt.takers and belt.unseen_takers:
        canvas.put(last, row, "?", style)


def _draw_pile(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, dishes: Dishes, count: int) -> None:
    """What nobody took, at the end of the belt: two side by side, and a third one on them where there is a line for it."""
    way = next(ways(plan, belt, SMALL), None)
    if not count or way is None:
        return
    dish = dishes.of(way.giver.type)
    on = plan.running(row // plan.step) - (1 if plan.dish_lines else 0)
    back = -SMALL if way.end >= way.start else SMALL
    for number in range(min(count, PILE)):
        canvas.put(way.end + number * back, on, dish.text, dish_style(dish, plan))
    if count > PILE and plan.dish_lines > 1:
        canvas.put(way.end + back // 2, on - 1, dish.text, dish_style(dish))


def _draw_hands(canvas: CellCanvas, plan: KitchenPlan, belt: Belt, row: int, glyphs: Glyphs, dishes: Dishes) -> None:
    """Who gives and who takes, on the counters at a belt."""
    for taker in belt.takers:
        for from_left in _sides(plan, belt, taker):
            _draw_hatch(canvas, belt, taker, plan.lane(taker.cook), row, glyphs, dishes, from_left=from_left)
    for giver in belt.givers:
        canvas.put(plan.lane(giver.cook), row, glyphs.gives, "hatch")


def _sides(plan: KitchenPlan, belt: Belt, taker: Hand) -> list[bool]:
    """From which sides dishes come to a taker: True for the left."""
    lane = plan.lane(taker.cook)
    others = [plan.lane(giver.cook) for giver in belt.givers]
    found = [True] if any(other < lane for other in others) or not others else []
    return [*found, False] if any(other >= lane for other in others) else found


def _draw_hatch(
    canvas: CellCanvas, belt: Belt, taker: Hand, lane: int, row: int, glyphs: Glyphs, dishes: Dishes, *, from_left: bool
) -> None:
    """Where a taker takes: an arrow, or before the counter the shape that is waited for in vain."""
    refusal = belt.refusal_of(taker)
    if refusal is None:
        canvas.put(lane - SIDE if from_left else lane + SIDE, row, glyphs.right if from_left else glyphs.left, "hatch")
        return
    wanted = dishes.of(taker.type).text if refusal.why == "type" else "QoS"
    text = glyphs.refused + wanted if from_left else wanted + glyphs.refused
    canvas.put(lane - SIDE - len(text) if from_left else lane + SIDE + 1, row, text, "warning")


def dish_style(dish: Dish, plan: KitchenPlan | None = None) -> str:
    """The style of a dish: that of its ware, on the ground of the belt where it lies in that."""
    return f"dish{dish.ware}" + (" on belt" if plan is not None and not plan.dish_lines else "")


def dish_texts(plan: KitchenPlan, dish: Dish, glyphs: Glyphs) -> tuple[str, ...]:
    """A moving dish, as many lines as a belt has for it; one that lies in the belt is a line too."""
    return dish.lines(fine=glyphs.fine) if plan.dish_lines > 1 else (dish.text,)


def put_dishes(
    canvas: CellCanvas, plan: KitchenPlan, row: int, line: int, dish: Dish, glyphs: Glyphs, places: Iterable[int]
) -> None:
    """One line of moving dishes on a row of belts; they pass under the counters."""
    text = dish_texts(plan, dish, glyphs)[line]
    seen = plan.cooks_between(canvas.left, canvas.left + canvas.width)
    lanes = [plan.lane(cook.name) for cook in seen if plan.reaches(cook.name, row)]
    covered = {lane + side for lane in lanes for side in range(-SIDE, SIDE + 1)}
    for place in places:
        for column, character in enumerate(text, place):
            if character != " " and column not in covered:
                canvas.put(column, row, character, dish_style(dish, plan))


def dish_ways(plan: KitchenPlan, belt: Belt, left: int) -> list[Way]:
    """The ways of the moving dishes of a belt; before what is `left` at its end they stop."""
    pile = min(left, PILE) * SMALL
    found = []
    for way in ways(plan, belt, dish_width(plan)):
        onward = way.end >= way.start
        end = max(way.start, way.end - pile) if onward else min(way.start, way.end + pile)
        found.append(way._replace(end=end))
    return found


def dish_width(plan: KitchenPlan) -> int:
    """Cells of a moving dish."""
    return LARGE if plan.dish_lines > 1 else SMALL


def words_of(
    belt: Belt, dishes: Dishes, rate: str, note: str, room: int, most: int, style: str, ellipsis: str
) -> list[tuple[str, str]]:
    """The label of a belt: its name, the dish with its type, the rate, what is wrong.

    Less of it where there are only `room` cells; but of the name only what has no room in `most`.
    """
    shapes: list[tuple[str, Dish]] = [(kind, dishes.of(kind)) for kind in dict.fromkeys(h.type for h in belt.givers)]
    shapes = shapes or [(kind, dishes.of(kind)) for kind in belt.types[:1]]
    types = [
        run for kind, dish in shapes for run in ((f" {dish.text}", dish_style(dish)), (f" {_short(kind)}", "muted"))
    ]
    tail = [(f" {text}", "muted") for text in (rate,) if text] + [(f" {note}", "warning")] * bool(note)
    for runs in ([*types, *tail], [*types[::2], *tail], [*types[::2], *tail[-1:]]):
        size = sum(cell_len(text) for text, _ in runs)
        if size + cell_len(belt.topic) <= room:
            break
    return [(clipped(belt.topic, max(LEAST_NAME, most - size), ellipsis), style), *runs]


def _short(kind: str) -> str:
    return kind.rsplit("/", 1)[-1]
