"""What all displays of points have in common (rviz_default_plugins/displays/pointcloud): style, colours, decay.

A cloud's points come with channels, numbers by name. Which `Color Transformer` there is depends on them.
"""

from __future__ import annotations

import colorsys
import math
from collections import deque
from typing import Any, NamedTuple

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import (
    BOOL,
    COLOUR,
    ENUM,
    FLOAT,
    INT,
    TEXT,
    VECTOR,
    Property,
    floats,
)
from day6_core.ros.programs.rviz2.model.scene import Points, Scene
from day6_core.ros.programs.rviz2.model.status import OK
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay
from day6_urdf.kinematics import Transform
from day6_urdf.model import Vector

STYLES = ("Points", "Squares", "Flat Squares", "Spheres", "Boxes", "Tiles")
INTENSITY, AXIS, FLAT, RGB8, RGBF32 = "Intensity", "AxisColor", "FlatColor", "RGB8", "RGBF32"
COLOURS = (AXIS, FLAT, INTENSITY, RGB8, RGBF32)
MOST_CLOUDS = 1000
MOST_KEPT = 1_000_000
"""Points that are remembered at most, whatever Decay Time says."""
MOST_DRAWN = 30_000
"""Of these the painter gets so many at most, evenly chosen: a terminal has far fewer cells."""
RAINBOW_STEPS = 32


class Cloud(NamedTuple):
    """Points in their own frame and in the fixed frame (N x 3), channels (N), and colours (N x 4, 0..1) if it has any."""

    received_ns: int
    own: Any
    xyz: Any
    channels: dict[str, Any]
    colours: Any
    colour_names: tuple[str, ...]


class PointsDisplay(FilteredDisplay):
    """Points coloured by a channel, along an axis, all alike, or by colours of their own."""

    selectable = True

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.selectable_switch = self.add(Property("Selectable", BOOL, True, on_change=changed))
        self.style = self.add(Property("Style", ENUM, "Flat Squares", options=STYLES, on_change=self._switched))
        self.size = self.add(floats("Size (m)", 0.01, 0.0001, on_change=changed))
        self.pixels = self.add(floats("Size (Pixels)", 3, 1, on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.decay = self.add(floats("Decay Time", 0, 0, on_change=changed))
        self.position = self.add(Property("Position Transformer", ENUM, "", options=self._positions, on_change=changed))
        self.how = self.add(
            Property("Color Transformer", ENUM, "", options=lambda: self._possible, on_change=self._switched)
        )
        self.channel = self.add(Property("Channel Name", TEXT, "intensity", on_change=changed))
        self.rainbow = self.add(Property("Use rainbow", BOOL, True, on_change=self._switched))
        self.invert = self.add(Property("Invert Rainbow", BOOL, False, on_change=changed))
        self.low_colour = self.add(Property("Min Color", COLOUR, (0, 0, 0), on_change=changed))
        self.high_colour = self.add(Property("Max Color", COLOUR, (255, 255, 255), on_change=changed))
        self.auto = self.add(Property("Autocompute Intensity Bounds", BOOL, True, on_change=self._switched))
        self.least = self.add(floats("Min Intensity", 0, on_change=changed))
        self.most = self.add(floats("Max Intensity", 4096, on_change=changed))
        self.axis = self.add(Property("Axis", ENUM, "Z", options=("X", "Y", "Z"), on_change=changed))
        self.auto_axis = self.add(Property("Autocompute Value Bounds", BOOL, True, on_change=self._switched))
        self.axis_least = self.auto_axis.add(floats("Min Value", -10, on_change=changed))
        self.axis_most = self.auto_axis.add(floats("Max Value", 10, on_change=changed))
        self.in_fixed_frame = self.add(Property("Use Fixed Frame", BOOL, True, on_change=changed))
        self.colour = self.add(Property("Color", COLOUR, (255, 255, 255), on_change=changed))
        self._possible: tuple[str, ...] = COLOURS
        self.points_shown = 0
        self.of_all = 0
        """How many points the newest message had, if some were left out; else 0."""
        self._clouds: deque[Cloud] = deque(maxlen=MOST_CLOUDS)
        self._drawn: tuple[Any, ...] = ()
        self._points: list[Points] = []
        self._hide()

    @staticmethod
    def _positions() -> tuple[str, ...]:
        return ("XYZ",)

    def _switched(self) -> None:
        self._hide()
        self.changed()

    def _hide(self) -> None:
        self.size.hidden, self.pixels.hidden = self.style.value == "Points", self.style.value != "Points"
        how = self.how.value
        for each in (self.channel, self.rainbow, self.auto):
            each.hidden = how != INTENSITY
        self.invert.hidden = how != INTENSITY or not self.rainbow.value
        self.low_colour.hidden = self.high_colour.hidden = how != INTENSITY or self.rainbow.value
        self.least.hidden = self.most.hidden = how != INTENSITY or self.auto.value
        self.axis.hidden = self.auto_axis.hidden = self.in_fixed_frame.hidden = how != AXIS
        self.axis_least.hidden = self.axis_most.hidden = bool(self.auto_axis.value)
        self.colour.hidden = how != FLAT

    def reset(self) -> None:
        super().reset()
        self._clouds.clear()
        self.points_shown = 0
        self._drawn = ()

    # -- taking in -----------------------------------------------------------------------------------------------------

    def take(self, own: Any, pose: Transform, channels: dict[str, Any], colours: Any, names: tuple[str, ...]) -> None:
        """Keep a cloud: points in its own frame (N x 3), that frame's pose, channels, colours and what these came from."""
        self.drop_status("Message")
        self._choose(names)
        self._clouds.append(Cloud(self.rviz.timer_ns(), own, _moved(own, pose), channels, colours, names))
        while len(self._clouds) > 1 and sum(len(each.own) for each in self._clouds) > MOST_KEPT:
            self._clouds.popleft()
        shown = list(self._clouds) if self.decay.value else [self._clouds[-1]]
        self.points_shown = sum(len(each.own) for each in shown)
        text = f"Showing [{self.points_shown}] points from [{len(shown)}] messages"
        if self.of_all and len(shown) == 1:
            text = f"Showing [{self.points_shown}] of [{self.of_all}] points from [1] messages"
        self.put_status(OK, "Points", text)

    def _choose(self, names: tuple[str, ...]) -> None:
        """Offer the transformers that the newest cloud allows; colours of its own come first, then a channel."""
        possible = (AXIS, FLAT, INTENSITY, *names)
        if not self.position.value:
            self.position.value = "XYZ"
            self.rviz.tree_changed()
        if possible == self._possible and self.how.value in possible:
            return
        self._possible = possible
        if self.how.value not in possible:
            self.how.value = RGB8 if RGB8 in possible else INTENSITY
        self._hide()
        self.rviz.tree_changed()

    @property
    def fading(self) -> bool:
        """Old points vanish by time alone."""
        return bool(self.decay.value) and len(self._clouds) > 1

    # -- selecting -----------------------------------------------------------------------------------------------------

    def thing_at(self, key: Any, point: Vector) -> Any:
        """The point of the newest cloud that lies nearest: its number."""
        import numpy as np

        if not self._clouds or not len(self._clouds[-1].xyz):
            return key
        return int(((self._clouds[-1].xyz - np.array(point)) ** 2).sum(axis=1).argmin())

    def describe(self, key: Any) -> tuple[str, list[Property]] | None:
        if not self._clouds:
            return None
        cloud = self._clouds[-1]
        if not isinstance(key, int):
            return self.name, [Property("Points", INT, len(cloud.xyz), read_only=True)]
        if key >= len(cloud.xyz):
            return None
        lines = [Property("Position", VECTOR, tuple(map(float, cloud.xyz[key])), read_only=True)]
        lines += [
            Property(str(name), FLOAT, float(values[key]), read_only=True)
            for name, values in cloud.channels.items()
            if name not in ("x", "y", "z")
        ]
        return f"Point {key}", lines

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, scene: Scene) -> None:
        if not self._clouds:
            return
        if not self.selectable_switch.value:
            scene.begin(None)
        oldest = self.rviz.timer_ns() - int(self.decay.value * 1e9)
        while len(self._clouds) > 1 and (not self.decay.value or self._clouds[0].received_ns < oldest):
            self._clouds.popleft()
        looks = tuple(each.value for top in self.children if top is not self.statuses for each in top.walk())
        wanted = (self._clouds[-1].own, len(self._clouds), looks)
        if not self._drawn or wanted[0] is not self._drawn[0] or wanted[1:] != self._drawn[1:]:
            self._drawn = wanted
            size = 0.0 if self.style.value == "Points" else self.size.value
            thin = max(1, math.ceil(sum(len(each.xyz) for each in self._clouds) / MOST_DRAWN))
            self._points = [Points(*self._thinned(each, thin), size) for each in self._clouds]
        scene.points += self._points

    def _thinned(self, cloud: Cloud, thin: int) -> tuple[Any, Any]:
        colours = self._colours(cloud)
        return cloud.xyz[::thin], colours if len(colours) == 1 else colours[::thin]

    def _colours(self, cloud: Cloud) -> Any:
        """One colour for all points, or one for each: N x 4."""
        import numpy as np

        how, alpha = self.how.value, self.alpha.value
        if how == FLAT or not len(cloud.xyz):
            return np.array([rgba(self.colour, alpha)])
        if how == AXIS:
            return self._along_axis(cloud)
        if how in (RGB8, RGBF32) and cloud.colours is not None:
            faded = np.array(cloud.colours, np.float32)
            faded[:, 3] *= alpha
            return faded
        channel = cloud.channels.get(self.channel.value)
        if channel is None and self.channel.value == "intensity":
            channel = cloud.channels.get("intensities")
        if how != INTENSITY or channel is None:
            return np.array([(1.0, 1.0, 1.0, alpha)])
        values = np.nan_to_num(np.asarray(channel, np.float64), posinf=999999.0, neginf=-999999.0)
        if self.auto.value:
            self.least.value = max(-999999.0, float(values.min()))
            self.most.value = min(999999.0, float(values.max()))
        part = (values - self.least.value) / ((self.most.value - self.least.value) or 1e20)
        if not self.rainbow.value:
            low, high = np.array(rgba(self.low_colour, alpha)), np.array(rgba(self.high_colour, alpha))
            return low + (high - low) * np.clip(part, 0, 1)[:, None]
        return rainbow(part if self.invert.value else 1 - part, alpha)

    def _along_axis(self, cloud: Cloud) -> Any:
        values = (cloud.xyz if self.in_fixed_frame.value else cloud.own)[:, "XYZ".index(self.axis.value)]
        if self.auto_axis.value:
            self.axis_least.value, self.axis_most.value = float(values.min()), float(values.max())
        least, most = self.axis_least.value, self.axis_most.value
        return rainbow(1 - (values - least) / ((most - least) or 0.001), self.alpha.value)


def rainbow(values: Any, alpha: float) -> Any:
    """Colours (N x 4) of numbers: 0 is violet, then blue, green, yellow, and 1 is red; others count as the nearest."""
    import numpy as np

    steps = RAINBOW_STEPS - 1
    table = np.array([(*colorsys.hsv_to_rgb((1 - step / steps) * 5 / 6, 1.0, 1.0), alpha) for step in range(steps + 1)])
    return table[np.round(np.clip(values, 0, 1) * steps).astype(int)]


def _moved(points: Any, pose: Transform) -> Any:
    import numpy as np

    from day6_core.ros.programs.rviz2.model.turning import matrix

    return points @ np.array(matrix(pose.rotation)).T + np.array(pose.xyz)
