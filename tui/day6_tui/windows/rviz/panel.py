"""A line of the Displays panel: name and value of a property, its marks and colours, and what in it can be clicked."""

from __future__ import annotations

from dataclasses import dataclass

from rich.segment import Segment
from rich.style import Style

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.properties import BOOL, COLOUR, GROUP, Property
from day6_core.ros.programs.rviz2.model.status import COLOURS, OK, Status
from day6_tui.appearance.colours import Colours, background_of, pixel_style
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit

NARROWEST_VALUE = 7
"""Cells that a value has beside the longest name."""


@dataclass(frozen=True, slots=True)
class PropertyLine:
    """One property at its depth."""

    prop: Property
    depth: int

    @property
    def can_open(self) -> bool:
        return any(not child.hidden for child in self.prop.children)


def name_of(prop: Property, look: Look) -> str:
    """The text of the left column. Names of RViz's properties stay as they are in every language."""
    return prop.name


@dataclass(frozen=True, slots=True)
class Zones:
    """The clickable zones of a line: columns counted from the panel's left edge."""

    opener: int
    box: int | None
    value: int


def zones(line: PropertyLine, width: int) -> Zones:
    """The zones of a line of the panel."""
    indent = line.depth * 2
    is_box = line.prop.kind == BOOL
    box = indent + 2 if isinstance(line.prop, Display) else value_column(line, width) if is_box else None
    return Zones(indent, box, value_column(line, width))


def value_column(line: PropertyLine, width: int) -> int:
    """Where the right column begins: in the middle, further right if the name needs it and room is left."""
    mark = 2 if (level := level_of(line.prop)) is not None and level > OK else 0
    wanted = line.depth * 2 + 2 + mark + cell_len(line.prop.name) + 1
    return max(10, width // 2, min(wanted, width - NARROWEST_VALUE))


def segments_of(line: PropertyLine, width: int, look: Look, chosen: bool, focused: bool) -> list[Segment]:
    """One line of the panel in exactly `width` cells."""
    prop, colours = line.prop, look.colours
    unicode = look.glyphs.unicode
    opener = " "
    if line.can_open:
        opener = ("▾" if unicode else "-") if prop.expanded else ("▸" if unicode else "+")
    name_style = _name_style(prop, colours)
    value_style = colours.muted if prop.read_only else colours.text
    if chosen:
        name_style = value_style = colours.selection if focused else colours.strong
    name = " " * (line.depth * 2) + opener + " "
    if isinstance(prop, Display):
        name += "[x] " if prop.value else "[ ] "
    name += _mark(prop, look) + name_of(prop, look)
    value = _value(prop)
    split = value_column(line, width)
    if not value:
        return [Segment(fit(name, width, look.glyphs.ellipsis), name_style)]
    segments = [Segment(fit(name, split - 1, look.glyphs.ellipsis) + " ", name_style)]
    rest = width - split
    if prop.kind == COLOUR and not colours.colourless and rest > 4:
        red, green, blue = prop.value
        segments.append(Segment("  ", pixel_style(-1, red << 16 | green << 8 | blue)))
        segments.append(Segment(" ", value_style))
        rest -= 3
    segments.append(Segment(fit(value.split("\n")[0], rest, look.glyphs.ellipsis), value_style))
    return segments


def _value(prop: Property) -> str:
    if isinstance(prop, Display) or prop.kind == GROUP:
        return ""
    if prop.kind == BOOL:
        return "[x]" if prop.value else "[ ]"
    return prop.text


def _mark(prop: Property, look: Look) -> str:
    level = level_of(prop)
    return f"{look.glyphs.warning} " if level is not None and level > OK else ""


def level_of(prop: Property) -> int | None:
    """How bad it is, of a status or of a display that has any."""
    if isinstance(prop, Status):
        return prop.level
    if isinstance(prop, Display) and prop.enabled and prop.statuses.children:
        return prop.statuses.level
    return None


def _name_style(prop: Property, colours: Colours) -> Style:
    level = level_of(prop)
    if level is not None and (rgb := COLOURS[level]) is not None:
        if colours.colourless or colours.name == "sixteen":
            return colours.warning
        red, green, blue = rgb if not colours.dark else tuple(min(255, part * 5 // 4 + 15) for part in rgb)
        return pixel_style(red << 16 | green << 8 | blue, background_of(colours.text))
    if isinstance(prop, Display):
        return colours.strong if prop.enabled else colours.muted
    return colours.text if prop.parent is not None and prop.parent.parent is not None else colours.strong


def full_text(prop: Property) -> str:
    """The full text of a line: long statuses are cut in the panel."""
    if isinstance(prop, Display):
        bad = [each for each in prop.statuses.children if isinstance(each, Status) and each.level > OK]
        return "  ".join(f"{each.name}: {each.value}" for each in bad)
    if prop.value is None:
        return ""
    return f"{prop.name}: {prop.text}"
