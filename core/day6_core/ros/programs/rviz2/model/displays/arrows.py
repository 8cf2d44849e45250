"""Poses drawn as arrows or axes: the properties that Odometry, Pose and others have in common."""

from __future__ import annotations

from collections.abc import Callable

from day6_core.ros.programs.rviz2.model.properties import COLOUR, ENUM, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Colour, Scene
from day6_urdf.kinematics import Transform

ARROW, AXES = "Arrow", "Axes"


class PoseShape:
    """The property `Shape` and what belongs to it; below it (Odometry) or beside it (Pose), as in the originals."""

    def __init__(self, add: Callable[[Property], Property], changed: Callable[[], object], below: bool) -> None:
        self._changed = changed
        self.shape = add(Property("Shape", ENUM, ARROW, options=(ARROW, AXES), on_change=self._switched))
        place = self.shape.add if below else add
        self.colour = place(Property("Color", COLOUR, (255, 25, 0), on_change=changed))
        self.alpha = place(floats("Alpha", 1, 0, 1, on_change=changed))
        self.shaft_length = place(floats("Shaft Length", 1, on_change=changed))
        self.shaft_radius = place(floats("Shaft Radius", 0.05, on_change=changed))
        self.head_length = place(floats("Head Length", 0.3, on_change=changed))
        self.head_radius = place(floats("Head Radius", 0.1, on_change=changed))
        self.axes_length = place(floats("Axes Length", 1, on_change=changed))
        self.axes_radius = place(floats("Axes Radius", 0.1, on_change=changed))
        self._hide()

    def _switched(self) -> None:
        self._hide()
        self._changed()

    def _hide(self) -> None:
        arrow = self.shape.value == ARROW
        for each in (self.colour, self.alpha, self.shaft_length, self.shaft_radius, self.head_length, self.head_radius):
            each.hidden = not arrow
        self.axes_length.hidden = self.axes_radius.hidden = arrow

    def draw(self, scene: Scene, pose: Transform) -> None:
        """One arrow or one set of axes."""
        if self.shape.value == AXES:
            scene.axes(pose, self.axes_length.value, self.axes_radius.value, self.alpha.value)
            return
        scene.arrow(
            pose,
            self.shaft_length.value,
            2 * self.shaft_radius.value,
            self.head_length.value,
            2 * self.head_radius.value,
            rgba(self.colour, self.alpha.value),
        )


def rgba(colour: Property, alpha: float) -> Colour:
    """A COLOUR property's value and an alpha as a scene's colour."""
    red, green, blue = colour.value
    return red / 255, green / 255, blue / 255, alpha
