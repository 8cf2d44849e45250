"""The colours of a kitchen, made from those of the desktop."""

from __future__ import annotations

from rich.style import Style

from day6_tui.appearance.colours import Colours, background_of, contrasting, foreground_of, pixel_style

SKIN = 0xE9B98D
EYES = 0x3A2618

PINK = {True: 0xE29BC6, False: 0x9C3F80}
"""For what the roles of a theme have no colour left."""

HAT = {True: 0xF4F6F8, False: 0xA9B5C3}
"""White, and grey where the ground is white; by whether the theme is dark."""


def styles_of(colours: Colours) -> dict[str, Style]:
    """By the names that the picture gives."""
    few = colours.colourless or colours.name == "sixteen"
    ground, belt = background_of(colours.text), -1
    dishes = [
        colours.topic,
        colours.publisher,
        colours.node,
        colours.strong,
        colours.text,
        colours.accent,
        colours.muted,
    ]
    if not few:
        belt = between(ground, foreground_of(colours.muted), 0.3)
        dishes[4] = pixel_style(PINK[colours.dark], ground)
    return {
        "topic": colours.text,
        "muted": colours.muted,
        "faint": colours.muted,
        "warning": colours.warning,
        "chosen": colours.choice,
        **{f"dish{number}": style for number, style in enumerate(dishes)},
        **{
            f"dish{number} on belt": style if few else pixel_style(foreground_of(style), belt)
            for number, style in enumerate(dishes)
        },
        **(_plain(colours) if few else _painted(colours, ground, belt)),
    }


def _painted(colours: Colours, ground: int, belt: int) -> dict[str, Style]:
    counter = foreground_of(colours.frame)
    return {
        "hat": pixel_style(HAT[colours.dark], ground),
        "face": pixel_style(EYES, SKIN),
        "hand": pixel_style(SKIN, ground),
        "jacket": pixel_style(foreground_of(colours.node), ground),
        "desk": pixel_style(contrasting(counter), counter),
        "desk end": pixel_style(counter, ground),
        "chosen end": pixel_style(background_of(colours.choice), ground),
        "counter": pixel_style(counter, ground),
        "hatch": pixel_style(contrasting(counter), counter),
        "belt": pixel_style(foreground_of(colours.muted), belt),
        "belt warning": pixel_style(foreground_of(colours.warning), belt),
    }


def _plain(colours: Colours) -> dict[str, Style]:
    """Where there are few colours, or none."""
    return {
        "hat": colours.strong,
        "face": colours.text,
        "hand": colours.text,
        "jacket": colours.node,
        "desk": colours.strong,
        "desk end": colours.frame,
        "chosen end": colours.accent,
        "counter": colours.frame,
        "hatch": colours.accent,
        "belt": colours.muted,
        "belt warning": colours.warning,
    }


def between(one: int, other: int, share: float) -> int:
    """A colour between two (0xRRGGBB)."""
    parts = [(one >> at & 255, other >> at & 255) for at in (16, 8, 0)]
    red, green, blue = (round(a + (b - a) * share) for a, b in parts)
    return red << 16 | green << 8 | blue
