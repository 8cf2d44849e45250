"""The characters of which a kitchen is made, by the set that the terminal shows: cooks of three sizes, counters and belts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class Figure(NamedTuple):
    """A cook: `rows` of characters, `parts` what each of them is of: `h`at, `f`ace, `s`kin, `j`acket, or nothing."""

    rows: tuple[str, ...]
    parts: tuple[str, ...]

    @property
    def width(self) -> int:
        """Cells across."""
        return len(self.rows[0])


NOBODY = Figure(("",), ("",))._replace(rows=(), parts=())


@dataclass(frozen=True)
class Glyphs:
    """The characters of a kitchen. `figures` are the cooks, the largest first."""

    figures: tuple[Figure, ...]
    counter: str
    """The counter that goes down from a cook, three cells."""
    desk: str
    """Left and right end of the part with the name on it."""
    belt: str
    """A piece of a belt that is repeated."""
    onward: str
    backward: str
    """Which way a belt runs, here and there on it."""
    gives: str
    right: str
    left: str
    gap: str
    """A belt on which nothing lies."""
    refused: str
    fine: bool
    """Whether dishes are made of block characters."""


_BLOCKS = (
    Figure(
        (
            "   ▗▟███▙▖   ",
            "  ▟███████▙  ",
            "  ▜███████▛  ",
            "    •   •    ",
            "     ╰─╯     ",
            "  ▗▄█████▄▖  ",
            "▗██▛█████▜██▖",
            "███▐█████▌███",
        ),
        (
            "   hhhhhhh   ",
            "  hhhhhhhhh  ",
            "  hhhhhhhhh  ",
            "   fffffff   ",
            "   fffffff   ",
            "  jjjjjjjjj  ",
            "jjjjjjjjjjjjj",
            "ssjjjjjjjjjss",
        ),
    ),
    Figure(
        (" ▗▟███▙▖ ", " ▝█████▘ ", "  • _ •  ", "▗▟█████▙▖", "█▌█████▐█"),
        (" hhhhhhh ", " hhhhhhh ", "  fffff  ", "jjjjjjjjj", "sjjjjjjjs"),
    ),
    Figure(
        (" ▟███▙ ", "  •_•  ", "▟█████▙"),
        (" hhhhh ", "  fff  ", "sjjjjjs"),
    ),
    Figure(
        ("▗███▖", "▐•_•▌"),
        ("hhhhh", "jfffj"),
    ),
)
_LINES = (
    Figure(
        (
            "   .oOOOo.   ",
            "  (       )  ",
            "   \\_____/   ",
            "   | o o |   ",
            "   |  _  |   ",
            "  .-\\___/-.  ",
            " / |  :  | \\ ",
            "(__|__:__|__)",
        ),
        (
            "   hhhhhhh   ",
            "  hhhhhhhhh  ",
            "   hhhhhhh   ",
            "   fffffff   ",
            "   fffffff   ",
            "  jjjjjjjjj  ",
            " jjjjjjjjjjj ",
            "ssjjjjjjjjjss",
        ),
    ),
    Figure(
        ("  .oOo.  ", "  |___|  ", "  (o_o)  ", " /[   ]\\ ", "(_[___]_)"),
        ("  hhhhh  ", "  hhhhh  ", "  fffff  ", " jjjjjjj ", "sjjjjjjjs"),
    ),
    Figure(
        (" .oOo. ", " (o_o) ", "/[___]\\"),
        (" hhhhh ", " fffff ", "jjjjjjj"),
    ),
    Figure(
        (".oOo.", "(o_o)"),
        ("hhhhh", "fffff"),
    ),
)

BLOCKS = Glyphs(_BLOCKS, "▐█▌", "▐▌", "═", "›", "‹", "■", "►", "◄", "·", "×", True)
CONSOLE = Glyphs(_LINES, "│░│", "││", "═", "»", "«", "■", "►", "◄", "·", "x", False)
ASCII = Glyphs(_LINES, "| |", "[]", "=", ">", "<", "#", ">", "<", ".", "x", False)

GLYPHS = {"half": BLOCKS, "braille": BLOCKS, "cell": CONSOLE, "ascii": ASCII}
"""By the canvas of a set of glyphs."""
