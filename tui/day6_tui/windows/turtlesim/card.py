"""What stands beside or below the world of turtlesim: the turtles, then where one of them is and who drives it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style

from day6_tui.appearance.colours import pixel_style
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit

if TYPE_CHECKING:
    from day6_core.ros.programs.turtlesim.model import TurtleTopics, TurtleView

Line = list[Segment]

TELEOP = "ros2 run turtlesim turtle_teleop_key"

_WHITE = 0xFFFFFF


class Pupil(NamedTuple):
    """A turtle, and the colour that stands for it."""

    turtle: TurtleView
    flag: int


class CardText(NamedTuple):
    """Text that stays together. `end` is the part that counts: if room is short, `text` gives way."""

    text: str
    style: Style
    end: str = ""

    def within(self, width: int, ellipsis: str) -> str:
        """Both in at most `width` cells."""
        room = width - cell_len(self.end)
        text = self.text if cell_len(self.text) <= room else clip(self.text, room, ellipsis)
        return clip((text if room >= SHORTEST or text == self.text else "") + self.end, width, ellipsis)


SHORTEST = 6
"""Cells below which what is left of a text says nothing."""


def side_lines(
    pupils: Sequence[Pupil],
    followed: str,
    topics: Mapping[str, TurtleTopics],
    size: tuple[int, int],
    look: Look,
) -> list[Line]:
    """At most `size` (columns and rows): a line for every turtle, and the card of the followed one if it fits too."""
    width, rows = size
    shown = pupils if len(pupils) <= rows else pupils[: max(0, rows - 1)]
    lines = [_turtle_line(number, pupil, width, look) for number, pupil in enumerate(shown, 1)]
    if len(shown) < len(pupils):
        more = look.texts("turtlesim.more", count=len(pupils) - len(shown))
        return [*lines, [Segment(f" {more}", look.colours.muted)]][:rows]
    turtle = next((pupil.turtle for pupil in pupils if pupil.turtle.name == followed), None)
    return lines if turtle is None else lines + _card(turtle, topics.get(followed), (width, rows - len(lines)), look)


def _turtle_line(number: int, pupil: Pupil, width: int, look: Look) -> Line:
    turtle, colours = pupil.turtle, look.colours
    swatch = Segment(f" {number % 10} ", colours.choice if colours.colourless else pixel_style(_WHITE, pupil.flag))
    numbers = f"  {turtle.x:5.2f} {turtle.y:5.2f} {_arrow(turtle.theta, look.glyphs.unicode)}"
    line = [Segment(" ", colours.text), swatch]
    if width >= 5 + cell_len(turtle.name) + len(numbers):
        return [*line, Segment(f" {turtle.name}", colours.strong), Segment(numbers, colours.muted)]
    return [*line, Segment(fit(f" {turtle.name}", width - 4, look.glyphs.ellipsis), colours.strong)]


def _card(turtle: TurtleView, topics: TurtleTopics | None, size: tuple[int, int], look: Look) -> list[Line]:
    """One item a line with a blank line before each topic, else flowing; nothing if that does not fit either."""
    width, rows = size
    groups = _groups(turtle, topics, look)
    tall: list[Line] = []
    for head, *items in groups:
        tall += [[], _words([head], width, look), *(_words([item], width, look, indent=3) for item in items)]
    if len(tall) <= rows:
        return tall
    low = [line for group in groups for line in _flowing(group, width, look)]
    return low if len(low) <= rows else []


def _groups(turtle: TurtleView, topics: TurtleTopics | None, look: Look) -> list[list[CardText]]:
    """A topic's name and what is said on it. The names of numbers are the fields of turtlesim/msg/Pose."""
    texts, colours = look.texts, look.colours
    if topics is None:
        return []
    fields = ("x", "y", "theta", "linear_velocity", "angular_velocity")
    pose = [CardText(field, colours.text, f" {getattr(turtle, field) + 0.0:5.2f}") for field in fields]
    if topics.senders:
        senders = [CardText(f"{texts('turtlesim.from')} ", colours.node, node) for node in topics.senders]
    else:
        senders = [CardText(texts("turtlesim.undriven"), colours.muted), CardText(TELEOP, colours.muted)]
    return [[CardText(topics.pose, colours.topic), *pose], [CardText(topics.cmd_vel, colours.topic), *senders]]


def _flowing(group: Sequence[CardText], width: int, look: Look) -> list[Line]:
    """Words one after the other, in as many lines as they take."""
    lines: list[list[CardText]] = []
    used = width
    for words in group:
        size = 2 + cell_len(words.text + words.end)
        if used + size > width:
            lines.append([])
            used = 0
        lines[-1].append(words)
        used += size
    return [_words(line, width, look) for line in lines]


def _words(items: Sequence[CardText], width: int, look: Look, *, indent: int = 1) -> Line:
    line = [Segment(" " * indent, look.colours.text)]
    room = width - indent
    for item in items:
        text = item.within(room, look.glyphs.ellipsis)
        line += [Segment(text, item.style), Segment("  ", look.colours.text)]
        room = max(0, room - cell_len(text) - 2)
    return line[:-1]


def _arrow(theta: float, unicode: bool) -> str:
    if not unicode or not math.isfinite(theta):
        return f"{theta:5.2f}"
    return "→↗↑↖←↙↓↘"[round(theta / (math.pi / 4)) % 8]
