"""The robot from above as rows of terminal cells: chassis, wheels whose tread runs as they turn, caster, heading, axle, scale.

Pure drawing of the transforms it is given: a wheel turns because its transform does. The robot faces right (x right, y up, as on
paper and in RViz's TopDownOrtho), to scale.
"""

from __future__ import annotations

from collections.abc import Mapping

from day6_urdf.kinematics import Transform
from day6_urdf.topview.blocks import DOTS, Blocks, Lines
from day6_urdf.topview.canvas import Canvas, Row, Style, cell_width
from day6_urdf.topview.frame import TopFrame
from day6_urdf.topview.letters import Letters
from day6_urdf.topview.paint import DARK, STANDING, TopColours, Turning, contrasting, paint_top
from day6_urdf.topview.plan import TopPlan
from day6_urdf.topview.words import Labels, Word, words_of

STYLES = (
    "", "chassis", "shade", "lamp", "body", "wheel", "mark", "tail", "caster", "arrow", "axle",
    "label", "name", "missing", "scale",
)  # fmt: skip
"""The named styles of a run; the empty one is background. Coloured dots have two colours: (characters, behind them)."""

_ROOM_FOR_TWO_ROWS = 13
"""Rows from which a wheel made of letters is two rows thick."""


def render_top(
    plan: TopPlan,
    transforms: Mapping[str, Transform],
    columns: int,
    rows: int,
    glyphs: str = "ascii",
    *,
    labels: Labels | None = None,
    turning: Turning = STANDING,
    colours: TopColours = DARK,
    zoom: float = 1.0,
    shift: tuple[int, int] = (0, 0),
) -> list[Row]:
    """Return `rows` rows of (text, style) runs, each exactly `columns` cells wide.

    `transforms` are those of the links in the root link's frame; a link without one is drawn at its rest pose, as missing.
    `labels` stand beside the wheels where there is room (by default the link names). `glyphs` is 'half', 'braille' or 'cell'
    for coloured dots, 'ascii' for letters. `zoom` enlarges the picture about its middle; at 1 the whole robot fits. `shift`
    moves it by columns and rows.
    """
    if columns <= 0 or rows <= 0:
        return [[] for _ in range(max(rows, 0))]
    dots = DOTS.get(glyphs)
    thick = 1.5 if dots is not None and dots[1] > 1 else 2.0 if rows >= _ROOM_FOR_TWO_ROWS else 1.0
    longer = 1.5 if dots is None else 1.2
    frame = TopFrame(plan, columns, rows, dots or (1, 1), thick=thick, longer=longer, zoom=zoom, shift=shift)
    words = words_of(frame, transforms, labels or {})
    if dots is None:
        canvas = Canvas(columns, rows)
        Letters(canvas, frame, transforms, turning).draw()
        for column, row, text, role in words:
            canvas.text(column, row, text, role)
        return canvas.rows()
    blocks = (Lines if glyphs == "braille" else Blocks)(frame, colours.background)
    paint_top(blocks, frame, transforms, colours, turning)
    drawn = blocks.rows()
    for row in {word.row for word in words if 0 <= word.row < rows}:
        drawn[row] = _with_words(drawn[row], [word for word in words if word.row == row], blocks, row)
    return drawn


def _with_words(row: Row, words: list[Word], blocks: Blocks, line: int) -> Row:
    """A row with texts over it; on a coloured ground their letters are light or dark."""
    canvas = Canvas(blocks.frame.columns, 1)
    column = 0
    for text, look in row:
        canvas.text(column, 0, text, look)
        column += len(text)
    for word in words:
        at = word.column
        for character in word.text:
            ground = blocks.ground(at, line) if 0 <= at < blocks.frame.columns else blocks.background
            style: Style = word.role if ground == blocks.background else (contrasting(ground), ground)
            canvas.text(at, 0, character, style)
            at += cell_width(character)
    return canvas.rows()[0]
