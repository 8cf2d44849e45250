"""The kitchen's window: the live graph as cooks and belts, with a dish on its way for messages that really passed.

Up and Down choose a belt, Left and Right a cook; what is chosen is explained below, in the kitchen's words and in ROS's.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_core.ros.programs.day6_kitchen.belts import Belt, Content, Cook
from day6_core.ros.programs.day6_kitchen.model import Kitchen
from day6_core.ros.programs.rqt_graph.model.drawing import CellCanvas
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import fit, wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.kitchen.figures import GLYPHS, Glyphs
from day6_tui.windows.kitchen.picture import (
    dish_ways,
    dish_width,
    draw_belts,
    draw_cooks,
    put_dishes,
    words_of,
)
from day6_tui.windows.kitchen.plan import LEAST_LINES, KitchenPlan, Way, dish_places
from day6_tui.windows.kitchen.styles import styles_of
from day6_tui.windows.kitchen.words import KitchenWords
from day6_tui.windows.parts.buttons import Button, button_line

STEP_SECONDS = 0.1
"""Between two pictures while dishes are moving."""

REST_SECONDS = 1.0
"""Between two looks while none is."""

RATE_SECONDS = 0.5
"""Between two rates: faster ones cannot be read."""

ALIKE = 0.04
"""A rate that differs by less from the shown one is the same."""


class KitchenPane(WindowPane[Kitchen]):
    """Draws `Kitchen.content`; keeps only view state: what is chosen, and which part is seen."""

    needs = PaneNeeds(Extent(56, 14), Extent(60, 14), Extent(110, 30))

    def __init__(self, window: Window[Kitchen], look: Look) -> None:
        super().__init__(window, look)
        self._words = KitchenWords(look)
        self._plan = KitchenPlan(Content(), 1, 1, self._glyphs)
        self._drawn: tuple[object, ...] = ()
        self._rates: dict[str, float | None] = {}
        """As they are shown."""
        self._rated = 0.0
        self._head = CellCanvas(0, 0)
        self._belts = CellCanvas(0, 0)
        """What is seen of the belts, without the dishes."""
        self._left: dict[str, int] = {}
        """What nobody took, as it is shown."""
        self._ways: dict[int, tuple[int, str, list[Way]]] = {}
        """By the rows on which dishes of a belt move: which of a dish's lines that is, the belt's topic and the ways on it."""
        self._moving_rows: set[int] = set()
        self._now = 0.0
        self._x = self._y = 0
        """The first column and row that are seen."""
        self._cook = self._belt = ""
        """What is chosen; at most one of them."""
        self._lines: list[str] = []
        """The explanation of it."""
        self._beyond: list[Button] = []
        """What is not seen."""
        self._explained = True
        self._styles_of: tuple[object, dict[str, Style]] = (None, {})
        """The colours of the desktop, and the styles made of them."""

    # -- frame ---------------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        return self.look.texts("kitchen.title")

    def status(self) -> list[Piece]:
        texts, content = self.look.texts, self.model.content
        text = texts("kitchen.count", cooks=len(content.cooks), belts=len(content.belts))
        if content.hidden:
            text += texts("kitchen.hidden", count=len(content.hidden))
        trouble = sum(bool(belt.refusals) for belt in content.belts)
        pieces = [Piece(f" {text} ", self.look.colours.muted)]
        if trouble:
            pieces.append(Piece(f"{texts('kitchen.trouble', count=trouble)} ", self.look.colours.warning))
        return pieces

    def key_hints(self) -> list[tuple[str, str]]:
        texts, unicode = self.look.texts, self.look.glyphs.unicode
        return [
            ("↑↓" if unicode else "Up Down", texts("kitchen.belts")),
            ("←→" if unicode else "Left Right", texts("kitchen.cooks")),
            ("Enter", texts("kitchen.explain")),
            ("h", texts("kitchen.show_hidden" if not self.model.everything else "kitchen.hide")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [("PgUp PgDn", self.look.texts("kitchen.scroll")), ("Esc", self.look.texts("kitchen.leave"))]

    # -- content -------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        model = self.model
        moves = not 0 <= now - self._now < 0.9 * STEP_SECONDS
        if moves:
            model.look(now)
            if self.look.reduced_motion:
                model.conveyor.clear()
            self._now = now
            self._read_rates(now)
        state = (
            model.version,
            self._rates,
            self._left,
            self.inner_width,
            self.inner_height,
            self.look.glyphs.name,
            self.look.texts.language,
            self._cook,
            self._belt,
            self._explained,
            self._x,
            self._y,
        )
        if state != self._drawn:
            self._paint()
            self._drawn = state
        if moves:
            self._move_dishes()
        moving = self._moving_rows or model.conveyor.moving
        self.look.wake_after(STEP_SECONDS if moving else REST_SECONDS)
        return False

    def _read_rates(self, now: float) -> None:
        """Take the rates over now and then, and only those that differ from what is shown: numbers that flicker tell nothing."""
        if 0 <= now - self._rated < RATE_SECONDS:
            return
        self._rated = now
        shown = {}
        for topic, rate in self.model.rates.items():
            before = self._rates.get(topic)
            alike = rate is not None and before is not None and rate > 0 and abs(rate - before) <= ALIKE * before
            shown[topic] = before if alike else rate
        if shown != self._rates:
            self._rates = shown
        if self._left != self.model.left:
            self._left = dict(self.model.left)

    @property
    def _glyphs(self) -> Glyphs:
        return GLYPHS[self.look.glyphs.canvas]

    def restyle(self) -> None:
        self._drawn = ()
        super().restyle()

    def _explanation(self) -> list[str]:
        """The lines below the belts."""
        content, lines = self.model.content, []
        belt, cook = content.belt(self._belt), content.cook(self._cook)
        if self._explained and belt is not None:
            rate = self._rates.get(belt.topic)
            called = {cook.name: cook.command for cook in content.cooks if cook.command}
            lines = wrap(self._words.belt(belt, self.model.dishes, rate, called), self.inner_width - 1)
        elif self._explained and cook is not None:
            lines = wrap(self._words.cook(cook), self.inner_width - 1)
        most = max(2, self.inner_height - 4)  # the line between, a line of names, and one belt
        if len(lines) > most:
            lines[most - 1 :] = [fit(lines[most - 1], self.inner_width - 2, "").rstrip() + self.look.glyphs.ellipsis]
        return lines

    def _plan_for(self, below: int) -> tuple[KitchenPlan, int]:
        """Where everybody stands above so many lines of explanation, and the lines of that for belts.

        Where not all of it is seen, one more line says so.
        """
        content, width, ellipsis = self.model.content, self.inner_width, self.look.glyphs.ellipsis
        lines = max(1, self.inner_height - below)
        plan = KitchenPlan(content, width, lines, self._glyphs, ellipsis)
        if plan.width > width or plan.head + plan.height > lines:
            lines -= lines >= LEAST_LINES
            plan = KitchenPlan(content, width, lines, self._glyphs, ellipsis)
        return plan, max(1, lines - plan.head)

    def _paint(self) -> None:
        """Draw everything but the dishes that move, and touch what differs."""
        content = self.model.content
        if content.belt(self._belt) is None:
            self._belt = ""
        if content.cook(self._cook) is None:
            self._cook = ""
        self._lines = self._explanation()
        plan, room = self._plan_for(len(self._lines) + bool(self._lines))
        self._plan = plan
        self._x = max(0, min(self._x, plan.width - self.inner_width))
        self._y = max(0, min(self._y, plan.height - room))
        shift = max(0, (self.inner_width - plan.width) // 2) if plan.width < self.inner_width else 0
        left, glyphs = self._x - shift, self._glyphs
        self._head = CellCanvas(self.inner_width, plan.head, left, 0)
        draw_cooks(self._head, plan, glyphs, self._cook)
        self._belts = CellCanvas(self.inner_width, room, left, self._y)
        draw_belts(self._belts, plan, glyphs, self.model.dishes, self._label, self._left)
        self._beyond = self._told_beyond()
        self._ways = {}
        for row, belt in plan.belts_between(self._y, self._y + room):
            found = dish_ways(plan, belt, self._left.get(belt.topic, 0))
            for line in range(max(1, plan.dish_lines)):
                # Above the belt; what lies in it, on its own row.
                at = plan.running(row // plan.step) - plan.dish_lines + line
                self._ways[at] = (line, belt.topic, found)
        self._moving_rows = self._rows_with_dishes()
        self.touch_lines(range(self.inner_height))
        self.touch_status()

    def _told_beyond(self) -> list[Button]:
        """How many cooks and belts are not seen, and the keys that show them; none where all are, or no line is left for it."""
        plan, texts = self._plan, self.look.texts
        if self._head.height + self._belts.height + len(self._lines) + bool(self._lines) >= self.inner_height:
            return []
        to_the_left, to_the_right = plan.beyond(self._head.left, self._head.left + self._head.width)
        above = -(-self._y // plan.step)
        below = -(-max(0, plan.height - self._y - self._belts.height) // plan.step)
        arrows = self.look.glyphs.unicode
        return [
            Button(told, texts(name, count=count), partial(self._press_and_show, key))
            for key, told, name, count in (
                ("left", "←" if arrows else "Left", "kitchen.more_cooks", to_the_left),
                ("right", "→" if arrows else "Right", "kitchen.more_cooks", to_the_right),
                ("pageup", "PgUp", "kitchen.more_belts", above),
                ("pagedown", "PgDn", "kitchen.more_belts", below),
            )
            if count
        ]

    def _press_and_show(self, key: str) -> None:
        self._press(key, "")
        self._redraw()

    def _label(self, belt: Belt, room: int) -> list[tuple[str, str]]:
        style = "chosen" if belt.topic == self._belt else "topic"
        note = self._words.note(belt, self._left.get(belt.topic, 0))
        return words_of(
            belt,
            self.model.dishes,
            self._words.rate(self._rates.get(belt.topic, 0.0)),
            note,
            room,
            self.inner_width,
            style,
            self.look.glyphs.ellipsis,
        )

    def _move_dishes(self) -> None:
        """Touch the belts on which dishes are, or were."""
        rows = self._rows_with_dishes()
        touched, self._moving_rows = self._moving_rows | rows, rows
        if touched:
            self.touch_lines(sorted(self._plan.head + row - self._y for row in touched if row >= self._y))

    def _rows_with_dishes(self) -> set[int]:
        conveyor = self.model.conveyor
        return {
            row
            for row, (_, topic, found) in self._ways.items()
            if any(conveyor.on_the_way((topic, way.giver.cook), self._now) for way in found)
        }

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if not self.model.content.cooks:
            return self._empty_line(y, width)
        if y < self._head.height:
            return self._segments(self._head, y)
        row = y - self._head.height
        if row < self._belts.height:
            return self._segments(self._with_dishes(row), 0 if row + self._y in self._moving_rows else row)
        at = row - self._belts.height
        if self._beyond:
            at -= 1
            if at < 0:
                return button_line(self, y, self._beyond, width)
        if at == 0 and self._lines:
            return [Segment(self.look.glyphs.border.horizontal * width, self.look.colours.frame)]
        return [Segment(f" {self._lines[at - 1]}", self.look.colours.text)] if 0 < at <= len(self._lines) else ()

    def _with_dishes(self, row: int) -> CellCanvas:
        """The canvas in which a row of belts is found: one with this row alone where dishes move on it."""
        belts = self._belts
        if row + self._y not in self._moving_rows:
            return belts
        canvas = CellCanvas(0, 0, belts.left, 0)
        canvas.width, canvas.height = belts.width, 1
        canvas.text, canvas.style = [belts.text[row][:]], [belts.style[row][:]]
        canvas.top = row + self._y
        line, topic, found = self._ways[row + self._y]
        for way in found:
            dish = self.model.dishes.of(way.giver.type)
            parts = self.model.conveyor.on_the_way((topic, way.giver.cook), self._now)
            places = dish_places(way, parts, dish_width(self._plan))
            put_dishes(canvas, self._plan, row + self._y, line, dish, self._glyphs, places)
        return canvas

    def _segments(self, canvas: CellCanvas, row: int) -> list[Segment]:
        found = []
        characters, styles = canvas.text[row], canvas.style[row]
        start = 0
        for index in range(1, canvas.width + 1):
            if index == canvas.width or styles[index] != styles[start]:
                found.append(Segment("".join(characters[start:index]), self._style(styles[start])))
                start = index
        return found

    def _empty_line(self, y: int, width: int) -> list[Segment]:
        lines = wrap(self.look.texts("kitchen.empty"), max(2, width - 2))
        at = y - max(0, (self.inner_height - len(lines)) // 2)
        return [Segment(f" {lines[at]}", self.look.colours.muted)] if 0 <= at < len(lines) else []

    def _style(self, name: str) -> Style:
        return self._styles().get(name, self.background)

    def _styles(self) -> dict[str, Style]:
        """The styles of everything that is drawn, by the picture's names."""
        colours = self.look.colours
        if self._styles_of[0] is not colours:
            self._styles_of = colours, styles_of(colours)
        return self._styles_of[1]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def _press(self, key: str, character: str) -> bool:
        if key in ("up", "down"):
            self._choose_belt(1 if key == "down" else -1)
        elif key in ("left", "right"):
            self._choose_cook(1 if key == "right" else -1)
        elif key == "enter":
            self._explain()
        elif key == "h":
            self.model.show_everything(not self.model.everything)
        elif key in ("pageup", "pagedown"):
            self._y += (1 if key == "pagedown" else -1) * max(1, self._belts.height - 1)
        elif key == "escape" and (self._cook or self._belt):
            self._cook = self._belt = ""
        else:
            return False
        return True

    def _explain(self) -> None:
        """Explain what is chosen, or no longer; the first belt where nothing is."""
        if self._cook or self._belt:
            self._explained = not self._explained
        else:
            self._explained = True
            self._choose_belt(1) if self.model.content.belts else self._choose_cook(1)

    def _choose_belt(self, step: int) -> None:
        topics = [belt.topic for belt in self.model.content.belts]
        if not topics:
            self._y += step
            return
        at = topics.index(self._belt) + step if self._belt in topics else (0 if step > 0 else len(topics) - 1)
        self._show_belt(self.model.content.belts[max(0, min(at, len(topics) - 1))])

    def _choose_cook(self, step: int) -> None:
        names = [cook.name for cook in self.model.content.cooks]
        if not names:
            return
        before, after = self._plan.beyond(self._head.left, self._head.left + self._head.width)
        seen = range(before, max(before + 1, len(names) - after))
        at = names.index(self._cook) + step if self._cook in names else seen[0 if step > 0 else -1]
        self._show_cook(self.model.content.cooks[max(0, min(at, len(names) - 1))])

    def _show_belt(self, belt: Belt) -> None:
        """Choose a belt and scroll to it."""
        self._belt, self._cook = belt.topic, ""
        below = len(self._explanation())
        plan, room = self._plan_for(below + bool(below))
        row = plan.row(belt.topic)
        self._y = max(row + plan.step - room, min(self._y, row))
        first, last = plan.ends(belt)
        self._x = min(first, max(self._x, last + 1 - self.inner_width))

    def _show_cook(self, cook: Cook) -> None:
        """Choose a cook and scroll to it."""
        self._cook, self._belt = cook.name, ""
        left = self._plan.lane(cook.name) - self._plan.pitch // 2
        self._x = min(left, max(self._x, left + self._plan.pitch - self.inner_width))

    # -- mouse ---------------------------------------------------------------------------------------------------------

    def on_click(self, event: events.Click) -> None:
        if self.hit(event.x, event.y) is not None or not self.is_inside(event):
            super().on_click(event)
            return
        column, row = event.x - 1 + self._head.left, event.y - 1
        if row < self._head.height:
            found: Cook | Belt | None = self._plan.cook_at(column)
        elif row < self._head.height + self._belts.height:
            found = self._plan.belt_at(row - self._head.height + self._y)
        else:
            return
        self._explained = True
        if isinstance(found, Cook):
            self._show_cook(found)
        elif found is not None:
            self._show_belt(found)
        else:
            self._cook = self._belt = ""
        self.look.wake()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        self._y += 2 * notches
        event.stop()
        self.look.wake()
