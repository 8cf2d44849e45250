"""How sure a pose is, as a ball around it (rviz_default_plugins/…/covariance_property.cpp)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from day6_tui.core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, COLOUR, ENUM, Property, floats
from day6_tui.core.ros.programs.rviz2.model.scene import SPHERE, Scene, Shape
from day6_tui.core.ros.programs.rviz2.model.topics import all_finite
from day6_tui.urdf.kinematics import Transform


class Covariance:
    """The property `Covariance` with what is below it; the orientation's part is kept, not drawn."""

    def __init__(self, add: Callable[[Property], Property], changed: Callable[[], object]) -> None:
        self.shown = add(Property("Covariance", BOOL, True, on_change=changed))
        self.place = place = self.shown.add(Property("Position", BOOL, True, on_change=changed))
        self.colour = place.add(Property("Color", COLOUR, (204, 51, 204), on_change=changed))
        self.alpha = place.add(floats("Alpha", 0.3, 0, 1, on_change=changed))
        self.scale = place.add(floats("Scale", 1, 0, on_change=changed))
        turn = self.shown.add(Property("Orientation", BOOL, True, on_change=changed))
        turn.add(Property("Frame", ENUM, "Local", options=("Local", "Fixed"), on_change=changed))
        turn.add(Property("Color Style", ENUM, "Unique", options=("Unique", "RGB"), on_change=changed))
        turn.add(Property("Color", COLOUR, (255, 255, 127), on_change=changed))
        turn.add(floats("Alpha", 0.5, 0, 1, on_change=changed))
        turn.add(floats("Offset", 1, 0, on_change=changed))
        turn.add(floats("Scale", 1, 0, on_change=changed))
        self._spread: tuple[float, float, float] | None = None

    def take(self, covariance: Sequence[float]) -> None:
        """The 36 numbers of a message."""
        spread = [covariance[index] for index in (0, 7, 14)]
        good = all_finite(spread) and max(spread) > 0 and min(spread) >= 0
        self._spread = (math.sqrt(spread[0]), math.sqrt(spread[1]), math.sqrt(spread[2])) if good else None

    def forget(self) -> None:
        """There is no pose."""
        self._spread = None

    def draw(self, scene: Scene, pose: Transform) -> None:
        """Two standard deviations, at least a tenth of a millimetre thick."""
        if self._spread is not None and self.shown.value and self.place.value:
            x, y, z = (max(1e-4, 2 * self.scale.value * part) for part in self._spread)
            scene.shapes.append(Shape(SPHERE, pose, (x, y, z), rgba(self.colour, self.alpha.value)))
