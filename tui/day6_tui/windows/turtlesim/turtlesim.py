"""The TurtleSim window: the turtles, their trails and the background of a `Simulation` (programs/turtlesim/model).

The world is always square. The trail is the program's own picture of 500 x 500 pixels, made smaller: a drawn pixel stands for a
block of that picture.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

from rich.segment import Segment
from textual import events
from textual.geometry import Region

from day6_core.ros.programs.turtlesim.model import HEIGHT, SIZE, WIDTH
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.canvas import Mark, PixelCanvas, new_canvas, square
from day6_tui.panes.cells import cell_len
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.turtlesim.card import Line, Pupil, side_lines
from day6_tui.windows.turtlesim.shapes import COATS, FLAGS, REAL_SIZE, Coat, characters, heading_step, pixels

if TYPE_CHECKING:
    from day6_core.ros.programs.turtlesim.model import Segment as Stroke
    from day6_core.ros.programs.turtlesim.model import Simulation, Trail, TurtleScene, TurtleTopics
    from day6_tui.pixels.pictures import Pictures
    from day6_tui.windows.turtlesim.pixels import TurtlePicture


SIDE_WIDTH = 20
"""Columns that must be left beside the world for what is said about the turtles there."""

SIDE_SECONDS = 0.1
"""Numbers that change faster cannot be read."""

PICTURE_SECONDS = 1 / 15
"""Between two pictures of real pixels."""

_RGB = 0xFFFFFF

Place: TypeAlias = tuple[int, int, int, int]
"""Column, row, columns and rows."""


class TurtleSimPane(WindowPane["Simulation"]):
    """Draws a simulation. It keeps the pixels shown, and which part of the trail they already contain."""

    needs = PaneNeeds(Extent(24, 10), Extent(42, 22), Extent(62, 32), 2.0)

    def __init__(self, window: Window[Simulation], look: Look) -> None:
        super().__init__(window, look)
        self._canvas: PixelCanvas | None = None
        self._scene: TurtleScene | None = None
        self._generation = -1
        self._drawn = -1
        self._coats: dict[str, Coat] = {}
        self._followed = ""
        """The turtle described in the status line: the one that moved last."""
        self._names = False
        self._shown_status: list[str] = []
        self._topics: Mapping[str, TurtleTopics] = {}
        self._side: list[Line] = []
        """What stands beside or below the world."""
        self._side_at, self._side_late = -SIDE_SECONDS, False
        """When that was made, and whether it has to be made again."""
        self._picture: TurtlePicture | None = None
        """The world in real pixels, where the terminal shows them."""
        self._drawn_at = 0.0

    # -- geometry ------------------------------------------------------------------------------------------------------

    def _world_place(self) -> Place:
        """The place of the world inside the frame."""
        return _world_in(self.inner_width, self.inner_height)

    def _side_place(self) -> Place | None:
        """The place of what is said about the turtles, where there is room for it."""
        width, height = self.inner_width, self.inner_height
        x, _, columns, rows = self._world_place()
        if width - columns >= SIDE_WIDTH:
            return x + columns + 1, 0, width - columns - 1, height
        if height > rows:
            return 0, rows, width, height - rows
        return None

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._canvas = None

    def restyle(self) -> None:
        self._canvas = self._picture = None
        super().restyle()

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if not self.inner_width or not self.inner_height:
            return False
        if (pictures := self.look.pixels) is not None:
            return self._pull_picture(pictures, now)
        if not self._fits():
            self._take_over()
            self.touch()
            return False
        scene, trail = self.model.scene, self.model.trail
        drawn = (trail.generation, trail.drawn) == (self._generation, self._drawn)
        if scene is self._scene and drawn and self.model.topics is self._topics and not self._side_late:
            return False
        canvas = self._take_over()
        y = self._world_place()[1]
        compared = self._touch_texts(now)
        self.redraw_lines({row + y for row in canvas.take_changes()} - compared)
        return self._side_late

    def _pull_picture(self, pictures: Pictures, now: float) -> bool:
        """Take over what is new as a picture of real pixels."""
        scene, trail, fresh = self.model.scene, self.model.trail, self._picture is None
        picture = self._fitting_picture(pictures)
        if fresh or picture is not self._picture:
            self._picture = picture
            self.touch()
        elif (
            scene is self._scene
            and (trail.generation, trail.drawn) == (self._generation, self._drawn)
            and self.model.topics is self._topics
            and not self._side_late
        ):
            return False
        elif now - self._drawn_at < 0.9 * PICTURE_SECONDS:
            return True
        self._drawn_at = now
        self._follow(scene)
        self._scene, self._generation, self._drawn = scene, trail.generation, trail.drawn
        x, y, columns, rows = self._world_place()
        names = picture.names(scene) if self._names or len(scene.turtles) > 1 else []
        self._topics = self.model.topics
        compared = self._touch_texts(now)
        self.redraw_lines({row + y for row in picture.sheet.put(names)} - compared)
        place = Region(x + self.inner_offset, y + self.inner_offset, columns, rows)
        pictures.show(self, place, picture.cell, picture.pixels(scene, trail, self._coats), picture.sheet.holes)
        return self._side_late

    def _fitting_picture(self, pictures: Pictures) -> TurtlePicture:
        """The picture, or a new one if it has another size."""
        from day6_tui.windows.turtlesim.pixels import TurtlePicture

        size = self._world_place()[2:]
        cell, picture = pictures.cell(*size), self._picture
        if picture is not None and (picture.columns, picture.rows, picture.cell) == (*size, cell):
            return picture
        return TurtlePicture(*size, cell, self.background)

    def _fits(self) -> bool:
        """Whether there is a canvas, of the size of the window."""
        canvas = self._canvas
        return canvas is not None and (canvas.columns, canvas.rows) == self._world_place()[2:]

    def _take_over(self) -> PixelCanvas:
        """Bring the canvas to what the model shows now."""
        if not self._fits():
            self._canvas = None
        scene, fresh = self.model.scene, self._canvas is None
        canvas = self._up_to_date(scene, self.model.trail)
        if scene is not self._scene or fresh:
            self._follow(scene)
            self._scene = scene
            self._put_turtles(canvas, scene)
        self._topics = self.model.topics
        if fresh:
            canvas.take_changes()
            self._side = self._side_now()
        return canvas

    def _up_to_date(self, scene: TurtleScene, trail: Trail) -> PixelCanvas:
        """The canvas with the trail as it is now."""
        red, green, blue = scene.background
        background = red << 16 | green << 8 | blue
        canvas = self._canvas
        generation, drawn, image = trail.generation, trail.drawn, trail.pixels
        segments = trail.segments_since(self._drawn) if generation == self._generation else None
        if canvas is None or background != canvas.background or segments is None:
            if canvas is None:
                _, _, columns, rows = self._world_place()
                canvas = new_canvas(columns, rows, self.look.glyphs.canvas, background, self.look.colours)
                self._canvas = canvas
            else:
                canvas.fill(background)
            if drawn:
                _shrink(image, canvas, range(canvas.width), range(canvas.height))
        else:
            # A block that has the only ink there is keeps it.
            settled = len(trail.inks) == 1
            for area in _joined(_blocks(segment, canvas) for segment in segments):
                _shrink(image, canvas, *area, settled=settled)
        self._generation, self._drawn = generation, drawn
        return canvas

    def _follow(self, scene: TurtleScene) -> None:
        before = {turtle.name: turtle for turtle in self._scene.turtles} if self._scene is not None else {}
        names = [turtle.name for turtle in scene.turtles]
        moved = [turtle.name for turtle in scene.turtles if before and before.get(turtle.name) != turtle]
        if self._followed not in names:
            self._followed = names[0] if names else ""
        if moved and self._followed not in moved:
            self._followed = moved[0]
        for name in names:
            if name not in self._coats:
                worn = {self._coats[other] for other in names if other in self._coats}
                free = [coat for coat in COATS if coat not in worn]
                self._coats[name] = free[0] if free else COATS[len(self._coats) % len(COATS)]

    def _put_turtles(self, canvas: PixelCanvas, scene: TurtleScene) -> None:
        sprites: dict[int, int] = {}
        marks: dict[tuple[int, int], Mark] = {}
        labelled = self._names or len(scene.turtles) > 1
        for number, turtle in enumerate(scene.turtles, 1):
            coat = self._coats[turtle.name]
            x = _clamp(turtle.x / WIDTH, canvas.width)
            y = _clamp(1 - turtle.y / HEIGHT, canvas.height)
            step = heading_step(turtle.theta)
            if canvas.mode in ("half", "braille"):
                size = _size(canvas.width)
                for dx, dy, part in pixels(size, step):
                    index = canvas.index(x + dx, y + dy)
                    if index is not None:
                        sprites[index] = coat[part]
                above = y // canvas.down - (size // 2 + 1) // canvas.down - 1
            else:
                body = "@" if len(scene.turtles) == 1 else str(number % 10)
                for dx, dy, char in characters(step, body):
                    marks[x + dx, y + dy] = Mark(char, 0xFFFFFF, self._flag(coat) if canvas.mode == "cell" else None)
                above = y - 2
            if labelled:
                _put_label(canvas, marks, turtle.name, x // canvas.across, above)
        canvas.set_sprites(sprites)
        canvas.set_marks(marks)

    def _touch_texts(self, now: float) -> set[int]:
        """Compare the status line, and what stands beside the world, with what is shown; the lines that were compared."""
        self._side_late = now - self._side_at < SIDE_SECONDS
        if self._side_late:
            return set()
        self._side_at = now
        status = [piece.text for piece in self.status()]
        if status != self._shown_status:
            self._shown_status = status
            self.touch_status()
        before, self._side = self._side, self._side_now()
        place = self._side_place()
        if place is None:
            return set()
        rows = max(len(before), len(self._side))
        old, new = (lines + [[]] * (rows - len(lines)) for lines in (before, self._side))
        changed = {place[1] + row for row in range(rows) if old[row] != new[row]}
        self.touch_lines(sorted(changed))
        return changed

    def _side_now(self) -> list[Line]:
        place = self._side_place()
        if place is None or self._scene is None:
            return []
        pupils = [Pupil(turtle, self._flag(self._coats[turtle.name])) for turtle in self._scene.turtles]
        return side_lines(pupils, self._followed, self._topics, place[2:], self.look)

    def _flag(self, coat: Coat) -> int:
        """The colour that stands for a turtle behind white characters."""
        return FLAGS[COATS.index(coat)] if self.look.glyphs.canvas in ("cell", "ascii") else coat.pattern

    # -- drawing -------------------------------------------------------------------------------------------------------

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        left, top, columns, rows = self._world_place()
        segments: list[Segment] = []
        if top <= y < top + rows:
            segments = [Segment(" " * left, self.background), *self._world_line(y - top)]
        place = self._side_place()
        if place is not None and place[1] <= y < place[1] + len(self._side):
            used = left + columns if segments else 0
            segments.append(Segment(" " * max(0, place[0] - used), self.background))
            segments += self._side[y - place[1]]
        return segments

    def _world_line(self, row: int) -> list[Segment]:
        if (pictures := self.look.pixels) is not None:
            return self._fitting_picture(pictures).sheet.line(row)
        canvas = self._canvas
        if canvas is None or not self._fits():
            canvas = self._take_over()
        return canvas.line(row)

    def status(self) -> list[Piece]:
        texts, colours = self.look.texts, self.look.colours
        scene = self._scene if self._scene is not None else self.model.scene
        if not scene.turtles:
            return [Piece(f" {texts('turtlesim.none')} ", colours.muted)]
        turtle = next((turtle for turtle in scene.turtles if turtle.name == self._followed), scene.turtles[0])
        text = texts("turtlesim.pose", x=turtle.x, y=turtle.y, theta=turtle.theta, v=turtle.linear_velocity)
        if not self.look.glyphs.unicode:
            text = text.replace("θ", "theta")
        pieces = [Piece(f" {text} ", colours.text)]
        if len(scene.turtles) > 1:
            pieces.insert(0, Piece(f" {turtle.name}", colours.accent))
        return pieces

    def status_right(self) -> list[Piece]:
        return [Piece(f" {self.model.node_name} ", self.look.colours.node)]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        return [("n", self.look.texts("turtlesim.label"))]

    def on_key(self, event: events.Key) -> None:
        if event.key == "n":
            event.stop()
            self._names = not self._names
            self.restyle()


@lru_cache(maxsize=16)
def _world_in(width: int, height: int) -> Place:
    columns, rows = square(width, height)
    if width - columns >= SIDE_WIDTH:
        return 0, (height - rows) // 2, columns, rows
    return (width - columns) // 2, 0, columns, rows


def _clamp(part: float, size: int) -> int:
    """The pixel of a place given as a part of the side; undefined numbers lie at the edge."""
    if not math.isfinite(part):
        return 0
    return max(0, min(size - 1, int(part * size)))


def _size(width: int) -> int:
    """Pixels across a turtle in a world of this many pixels: never too small to be seen."""
    if width < 60:
        return 5 if width < 44 else 7
    return max(9, round(width * REAL_SIZE * 1.3))


def _put_label(canvas: PixelCanvas, marks: dict[tuple[int, int], Mark], name: str, column: int, row: int) -> None:
    width = cell_len(name)
    first = max(0, min(canvas.columns - width, column - width // 2))
    row = row if row >= 0 else min(canvas.rows - 1, row + 5)
    for offset, char in enumerate(name):
        marks[first + offset, row] = Mark(char, -1, canvas.background)


def _blocks(stroke: Stroke, canvas: PixelCanvas) -> tuple[range, range]:
    """The pixels of the canvas that a piece of the trail can have touched."""
    margin = stroke.width * 0.75 + 1  # half the diagonal of the square at a line's end

    def span(a: float, b: float, size: int) -> range:
        first, last = max(0, math.floor(min(a, b) - margin)), min(SIZE - 1, math.ceil(max(a, b) + margin))
        # Block n begins at pixel n * SIZE // size of the image.
        return range(((first + 1) * size - 1) // SIZE, ((last + 1) * size - 1) // SIZE + 1)

    return span(stroke.x0, stroke.x1, canvas.width), span(stroke.y0, stroke.y1, canvas.height)


def _joined(areas: Iterable[tuple[range, range]]) -> list[tuple[range, range]]:
    """The same areas, one in place of two that follow each other where that is no larger than both."""
    found: list[tuple[range, range]] = []
    for area in areas:
        if found:
            columns, rows = (
                range(min(a.start, b.start), max(a.stop, b.stop)) for a, b in zip(found[-1], area, strict=True)
            )
            if len(columns) * len(rows) <= sum(len(across) * len(down) for across, down in (found[-1], area)):
                found[-1] = columns, rows
                continue
        found.append(area)
    return found


def _shrink(image: memoryview, canvas: PixelCanvas, columns: range, rows: range, *, settled: bool = False) -> None:
    """Set pixels of the canvas from their blocks of the path image (one number 0xAARRGGBB per pixel, 0 undrawn).

    With `settled` those that have a colour already are left out.

    A block has the colour of the ink in the diamond between the middles of its sides: a line that passes through a block
    crosses the diamond, one that only clips a corner does not, so thin lines stay thin and unbroken.
    """
    if not columns or not rows:
        return
    width, background = canvas.width, canvas.background
    for y in rows:
        wanted = columns
        if settled:
            free = [x for x in columns if canvas.base[y * width + x] == background]
            if not free:
                continue
            wanted = range(free[0], free[-1] + 1)
        _shrink_row(image, canvas, y, wanted)


def _shrink_row(image: memoryview, canvas: PixelCanvas, y: int, columns: range) -> None:
    xs = [x * SIZE // canvas.width for x in range(columns.start, columns.stop + 1)]
    top, bottom = y * SIZE // canvas.height, (y + 1) * SIZE // canvas.height
    left, right, height = xs[0], xs[-1], bottom - top
    lines = []
    inked: set[int] = set()
    for offset in range(height):
        line = image[(top + offset) * SIZE + left : (top + offset) * SIZE + right].tolist()
        if any(line):
            lines.append((1 - abs(2 * offset + 1 - height) / (height + 1), line))
            inked.update(x for x in range(len(columns)) if any(line[xs[x] - left : xs[x + 1] - left]))
    # Blocks without ink need no check: within one generation of the trail, ink is only added.
    for x in inked:
        half = (xs[x + 1] - xs[x]) / 2
        middle = xs[x] - left + half
        ink: list[int] = []
        for part, line in lines:
            reach = max(0.5, half * part)
            ink += [value for value in line[int(middle - reach + 0.5) : int(middle + reach + 0.5)] if value]
        if ink:
            canvas.set_base(columns.start + x, y, max(set(ink), key=ink.count) & _RGB)
