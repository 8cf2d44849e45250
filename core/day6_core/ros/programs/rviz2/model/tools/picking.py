"""Tools that point at things: Publish Point, Measure, Focus Camera (rviz_default_plugins/tools/point, measure, focus)."""

from __future__ import annotations

import math

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import BOOL, COLOUR, Property
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene
from day6_core.ros.programs.rviz2.model.tools.tool import SCREEN, Hit, Pointer, Tool, ToolTopic
from day6_urdf.model import Vector

DARK_YELLOW = (128, 128, 0)


class PointingTool(Tool):
    """Knows what is under the mouse, for its status."""

    arrows = SCREEN
    needs_hit = True
    _hit: Hit | None = None

    def deactivate(self) -> None:
        self._hit = None

    def hover(self, pointer: Pointer) -> bool:
        self._hit = pointer.hit
        return False


class PublishPoint(PointingTool):
    """Sends the point of a surface that was clicked."""

    type, title, short, key = "PublishPoint", "Publish Point", "Point", "u"

    def build(self) -> None:
        self.topic = ToolTopic(self, "geometry_msgs/msg/PointStamped", "/clicked_point")
        self.single = self.add(Property("Single click", BOOL, True))

    def open(self) -> None:
        self.topic.open()

    def close(self) -> None:
        self.topic.close()

    @property
    def status(self) -> str:
        if self._hit is None:
            return "Move over an object to select the target point."
        return f"Left-Click: Select this point. {bracketed(self._hit.point)}"

    def release(self, pointer: Pointer) -> bool:
        self._hit = pointer.hit
        if pointer.hit is None:
            return False
        message = self.topic.message()
        message.point.x, message.point.y, message.point.z = pointer.hit.point
        self.topic.publish(message)
        return bool(self.single.value)


class FocusCamera(PointingTool):
    """Turns the view to what was clicked."""

    type, title, short, key = "FocusCamera", "Focus Camera", "Focus", "c"

    @property
    def status(self) -> str:
        if self._hit is None:
            return "Left-Click: Look in this direction."
        return f"Left-Click: Focus on this point. {bracketed(self._hit.point)}"

    def release(self, pointer: Pointer) -> bool:
        # Where nothing is, a point one metre along the ray (focus_tool.cpp).
        self.rviz.view.turn_to(pointer.hit.point if pointer.hit is not None else pointer.at(1.0))
        return True


class Measure(Tool):
    """The distance between two points that are clicked."""

    type, title, short, key = "Measure", "Measure", "Measure", "n"
    arrows = SCREEN
    needs_hit = True
    takes_right = True

    def build(self) -> None:
        self.colour = self.add(Property("Line color", COLOUR, DARK_YELLOW, on_change=self.rviz.touch))
        self._started = False
        self._line: tuple[Vector, Vector] | None = None
        self._length = -1.0

    @property
    def status(self) -> str:
        length = f"[Length: {self._length:.6g}m] " if self._length > 0 else ""
        return f"{length}Click on two points to measure their distance. Right-click to reset."

    def activate(self) -> None:
        self._started = False

    def hover(self, pointer: Pointer) -> bool:
        if self._started and self._line is not None and pointer.hit is not None:
            self._stretch(pointer.hit.point)
        return False

    drag = hover

    def _stretch(self, point: Vector) -> None:
        assert self._line is not None
        start = self._line[0]
        self._line, self._length = (start, point), math.dist(start, point)

    def release(self, pointer: Pointer) -> bool:
        if pointer.hit is None:
            return False
        point = pointer.hit.point
        if self._started:
            self._stretch(point)
        else:
            self._line = (point, point)
        self._started = not self._started
        return False

    def right(self) -> bool:
        self._started, self._line = False, None
        return False

    def draw(self, scene: Scene) -> None:
        if self._line is not None and self._line[0] != self._line[1]:
            scene.lines.append(Lines(self._line, [rgba(self.colour, 1.0)]))


def bracketed(point: Vector) -> str:
    """A point as the status bar says it: three significant digits."""
    return "[" + ",".join(f"{part:.3g}" for part in point) + "]"
