"""The world from above in real pixels: what never moves is drawn once per view, and the trail is added to it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import Surface
from day6_tui.pixels.sheet import Sheet
from day6_tui.windows.robot.robot_pixels import SurfacePainter
from day6_tui.windows.world.picture import (
    BEAM,
    FIRM,
    FLOOR,
    GRID,
    HIT,
    LINE,
    NOSE,
    OUTSIDE,
    TRAIL,
    WALL,
    WorldView,
    nose_of,
    placing,
)
from day6_urdf.topview.frame import life_size
from day6_urdf.topview.paint import STANDING, TopColours, paint_bodies, paint_casters, paint_tyre
from day6_urdf.topview.plan import TopPlan, plan_top, spin_of

if TYPE_CHECKING:
    from rich.style import Style

    from day6_core.ros.programs.day6_world.model import Scan, Trail, WorldSnapshot
    from day6_core.ros.programs.day6_world.scenery import Scenery
    from day6_urdf.model import Robot

FARTHEST_BEAM = 20.0
"""Metres that a ray without an end is drawn."""

Spot = tuple[float, float]


def darker(colour: int) -> int:
    """The colour of an outline."""
    return sum(int((colour >> shift & 255) * 0.6) << shift for shift in (0, 8, 16))


class WorldPixels:
    """A view of `cell` pixels per cell. `colours` are by kind, as in `world_picture`; `top` those of the robot."""

    def __init__(
        self,
        view: WorldView,
        cell: tuple[int, int],
        scenery: Scenery,
        colours: Sequence[int],
        top: TopColours,
        blank: Style,
    ) -> None:
        self.view, self.cell = view, cell
        self.sheet = Sheet(view.columns, view.rows, blank)
        self._colours, self._top = colours, top
        self._width, self._height = view.columns * cell[0], view.rows * cell[1]
        self._metre = min(cell[0], cell[1] / 2) / view.scale
        """Pixels of a metre: the view takes a cell for twice as high as wide, and none is exactly that."""
        self._ground = self._scenery(scenery)
        self._trail_seen = (-1, 0)
        self._bare = self._ground.image.copy()
        self._plan: TopPlan | None = None

    def pixels(self, snapshot: WorldSnapshot, trail: Trail) -> Array:
        """A moment: height x width x 3 bytes."""
        self._take_trail(trail)
        surface = Surface(self._width, self._height, 0, base=self._ground.image)
        if snapshot.scan is not None:
            self._paint_scan(surface, snapshot.scan)
        if snapshot.robot is not None:
            self._paint_robot(surface, snapshot, snapshot.robot)
        return surface.pixels()

    def _place(self, spot: Spot) -> Spot:
        x, y = spot
        return (
            self._width / 2 + (x - self.view.x) * self._metre,
            self._height / 2 - (y - self.view.y) * self._metre,
        )

    def _scenery(self, scenery: Scenery) -> Surface:
        colours = self._colours
        surface = Surface(self._width, self._height, colours[OUTSIDE])
        x, y = scenery.size[0] / 2, scenery.size[1] / 2
        surface.polygon([self._place(spot) for spot in ((-x, -y), (x, -y), (x, y), (-x, y))], colours[FLOOR])
        for across in range(math.ceil(-x), math.floor(x) + 1):
            surface.line([self._place((across, -y)), self._place((across, y))], colours[GRID], 0.5)
        for up in range(math.ceil(-y), math.floor(y) + 1):
            surface.line([self._place((-x, up)), self._place((x, up))], colours[GRID], 0.5)
        thick = max(1.5, scenery.line_width * self._metre)
        for ax, ay, bx, by in scenery.line:
            ends = [self._place((ax, ay)), self._place((bx, by))]
            surface.line(ends, colours[LINE], thick)
            for spot in ends:
                surface.disc(*spot, thick / 2, colours[LINE])
        for solid in scenery.solids:
            spots = [self._place(point) for point in solid.points]
            if len(spots) == 1:
                surface.disc(*spots[0], solid.radius * self._metre, colours[WALL])
            else:
                surface.polygon(spots, colours[WALL], darker(colours[WALL]))
        return surface

    def _take_trail(self, trail: Trail) -> None:
        points, (generation, count) = trail.points, self._trail_seen
        if generation != trail.generation or len(points) < count:
            self._ground.image.paste(self._bare)
            count = 0
        first = max(0, count - 1)
        self._ground.line([self._place(point) for point in points[first:]], self._colours[TRAIL], 1.5)
        self._trail_seen = (trail.generation, len(points))

    def _paint_scan(self, surface: Surface, scan: Scan) -> None:
        start = self._place((scan.x, scan.y))
        hits = []
        for number, length in enumerate(scan.ranges):
            angle, reach = scan.first + number * scan.step, min(length, FARTHEST_BEAM)
            end = self._place((scan.x + reach * math.cos(angle), scan.y + reach * math.sin(angle)))
            if number % 3 == 0:
                surface.line([start, end], self._colours[BEAM], 0.5)
            if math.isfinite(length):
                hits.append(end)
        for end in hits:
            surface.disc(*end, 1.8, self._colours[HIT])

    def _paint_robot(self, surface: Surface, snapshot: WorldSnapshot, robot: Robot) -> None:
        plan = self._plan
        if plan is None or plan.robot is not robot:
            plan = self._plan = plan_top(robot)
        posed = placing(snapshot.pose)

        def place(spot: Spot) -> Spot:
            return self._place(posed([spot])[0])

        given = {**plan.rest, **snapshot.transforms()}
        painter = SurfacePainter(surface, place, self._metre)
        paint_bodies(painter, plan, given, given, self._top)
        paint_casters(painter, plan, given, given, self._top)
        for tyre in life_size(plan, given):
            paint_tyre(
                painter,
                tyre,
                spin_of(tyre.wheel, given),
                (1 / self._metre, 1 / self._metre),
                given,
                self._top,
                STANDING,
            )
        surface.polygon([place(spot) for spot in nose_of(plan)], self._colours[FIRM if snapshot.bumped else NOSE])
