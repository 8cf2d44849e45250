"""Looks at the first robot that comes: RViz's camera, 10 m away, shows most as a speck."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_tui.windows.rviz.extent import frame, is_speck, outline, robot_of
from day6_tui.windows.rviz.view import View3D


class Framing:
    """Frames the robot by itself while the camera stands where RViz starts it, and again when the picture has another shape.

    A camera that somebody moved, or that a file placed elsewhere, stays; if it hardly shows the robot, to frame it is offered.
    """

    def __init__(self, rviz: RViz, view: View3D) -> None:
        self._rviz = rviz
        self._view = view
        self._loaded = rviz.loaded
        self._looked_at: tuple[int, ...] = ()
        self._camera: int | None = None
        """The `view_version` in which the robot was framed, or to frame it was offered; None before it is there."""
        self._framed: tuple[int, ...] = ()
        """The size of the picture in which it was framed, its parts, and those of them in place; () if it was not framed."""
        self._over = False

    @property
    def offered(self) -> bool:
        """Whether a key should be named that frames the robot."""
        return self._camera is not None and not self._framed and not self._over

    @property
    def holds(self) -> bool:
        """Whether the camera is where this put it, by nobody's wish."""
        return bool(self._framed) and self._camera == self._rviz.view_version

    def pull(self) -> bool:
        """Follow the scene and the size of the picture; return whether the offer came or went."""
        rviz, view = self._rviz, self._view
        offered = self.offered
        if rviz.loaded != self._loaded:
            self._loaded, self._looked_at, self._camera, self._framed, self._over = rviz.loaded, (), None, (), False
        if self._camera is not None and rviz.view_version != self._camera:
            self._over = True
        state = (view.columns, view.rows, rviz.version)
        if self._over or offered or state == self._looked_at or not view.columns or not view.rows:
            return self.offered != offered
        self._looked_at = state
        robot = robot_of(rviz.scene)
        in_place = [part.lit for part in robot.shapes] + [part.lit for part in robot.triangles]
        if in_place and rviz.statuses.level < ERROR:
            self._look((view.columns, view.rows, len(in_place), sum(in_place)))
        return self.offered != offered

    def _look(self, now: tuple[int, ...]) -> None:
        """The robot is there."""
        rviz, aspect = self._rviz, self._view.aspect
        points = outline(rviz.scene)
        if now == self._framed or not points:
            return
        if self._framed or rviz.view.at_start:
            frame(rviz.view, points, aspect)
            self._framed = now
        else:
            self._over = not is_speck(rviz.view.camera(), points, aspect)
        self._camera = rviz.view_version
