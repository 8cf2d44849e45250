"""The viewpoint: RViz's view controllers, with their properties and their rules for the mouse.

Mouse movements are in pixels of a picture 600 pixels high, whatever the size of ours, so that a drag across the window does
what it does in RViz. All turning and moving is also offered in angles and parts of the picture, for keys.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from day6_core.ros.programs.rviz2.model.properties import (
    BOOL,
    ENUM,
    FIXED_FRAME,
    FRAME,
    TEXT,
    VECTOR,
    Property,
    floats,
)
from day6_core.ros.programs.rviz2.model.scene import SPHERE, Colour, Shape
from day6_urdf.kinematics import Transform
from day6_urdf.model import Vector

NOMINAL_HEIGHT = 600.0
FIELD_OF_VIEW = math.radians(45)
"""From top to bottom (Ogre's default)."""

ROTATION_SPEED = 0.005
MOST_PITCH = math.pi / 2 - 0.001
CAMERA_OFFSET = 0.2
"""XYOrbit lifts the camera, so that the focal point appears in the lower half."""

ORTHO_HEIGHT = 500.0
START = 0.785398


@dataclass(frozen=True, slots=True)
class Camera:
    """Right, up and forward are unit vectors in the fixed frame; `metres` is the height of the picture if parallel."""

    position: Vector
    right: Vector
    up: Vector
    forward: Vector
    near: float = 0.01
    metres: float | None = None


class View(Property):
    """The group `Current View`. `touched` is called whenever the picture changes."""

    type = ""
    help = ""
    help_shift = ""

    def __init__(self, frame_choices: Callable[[], list[str]], touched: Callable[[], object]) -> None:
        super().__init__("Current View", TEXT, f"{self.type} (rviz)", read_only=True)
        self.touched = touched
        self.near = floats("Near Clip Distance", 0.01, 0.001, 10000, on_change=touched)
        self.target = Property("Target Frame", FRAME, FIXED_FRAME, options=frame_choices, on_change=touched)
        self.invert = Property("Invert Z Axis", BOOL, False, on_change=touched)
        self.build()
        self.add(self.target)
        self.add(self.near)
        self.origin: Vector = (0.0, 0.0, 0.0)
        """Where the target frame is."""
        self.heading = 0.0
        """How the target frame is turned about the vertical."""
        self.unknown: dict[str, Any] = {}

    @property
    def class_id(self) -> str:
        return f"rviz_default_plugins/{self.type}"

    def build(self) -> None:
        """Add the properties."""

    def zero(self) -> None:
        """Back to the start."""
        for each in self.children:
            if each not in (self.near, self.target):
                each.set(each.default)

    @property
    def at_start(self) -> bool:
        """Whether it is as RViz begins: nobody has moved the camera, nor did a file."""
        return all(each.value == each.default for each in self.children if each not in (self.near, self.target))

    def save_start(self) -> dict[str, Any]:
        """What `save` returns while nobody has moved the camera."""
        start = type(self)(list, lambda: None)
        start.near.value, start.target.value = self.near.value, self.target.value
        return start.save()

    def camera(self) -> Camera:
        raise NotImplementedError

    @property
    def focal_shape(self) -> Shape | None:
        """What marks the focal point while the camera is moved; None for a view that has no such point."""
        return None

    # -- the mouse: dx, dy in nominal pixels ---------------------------------------------------------------------------

    def drag(self, button: str, shift: bool, dx: float, dy: float, aspect: float) -> None:
        """A drag with 'left', 'middle' or 'right'; `aspect` is the picture's width by its height."""
        if button == "left" and not shift:
            self.rotate(dx * ROTATION_SPEED, dy * ROTATION_SPEED)
        elif button == "middle" or (button == "left" and shift):
            self.pan(dx / NOMINAL_HEIGHT, dy / NOMINAL_HEIGHT)
        elif button == "right":
            self.pull(dy, shift)

    def wheel(self, notches: float, shift: bool) -> None:
        """Turns of the wheel, away from the viewer positive."""

    def rotate(self, horizontal: float, vertical: float) -> None:
        """Turn the scene with the hand: radians to the right and downwards."""

    def pan(self, right: float, down: float) -> None:
        """Push the scene: in heights of the picture."""

    def pull(self, down: float, shift: bool) -> None:
        """Drag with the right button, in nominal pixels."""

    def zoom(self, steps: float) -> None:
        """Nearer (positive) or farther by notches of the wheel."""
        self.wheel(steps, False)

    def look_at(self, centre: Vector, radius: float) -> None:
        """Show a ball whole."""

    def turn_to(self, point: Vector) -> None:
        """Look at a point from where the camera is (the originals' `lookAt`)."""

    def from_above(self) -> None:
        """The usual view of a robot: 45 degrees from above, over one shoulder."""

    # -- configuration -------------------------------------------------------------------------------------------------

    def save(self) -> dict[str, Any]:
        saved = {child.name: child.save() for child in self.children if child.should_be_saved}
        return {**self.unknown, **saved, "Class": self.class_id, "Name": self.name, "Value": self.value}

    def load(self, config: Any) -> None:
        if not isinstance(config, dict):
            return
        known = {child.name for child in self.children} | {"Class", "Name", "Value"}
        self.unknown = {key: value for key, value in config.items() if key not in known}
        for child in self.children:
            if child.name in config:
                child.load(config[child.name])


class Orbit(View):
    """Turns about a focal point."""

    type = "Orbit"
    help = "Left-Click: Rotate.  Middle-Click: Move X/Y.  Right-Click/Mouse Wheel: Zoom.  Shift: More options."
    help_shift = "Left-Click: Move X/Y.  Right-Click: Move Z.  Mouse Wheel: Zoom."
    focal_colour: Colour = (1.0, 1.0, 0.0, 0.5)

    def build(self) -> None:
        changed = self.touched
        self.distance = self.add(floats("Distance", 10, 0.001, on_change=changed))
        self.yaw = self.add(floats("Yaw", START, on_change=changed))
        self.pitch = self.add(floats("Pitch", START, -MOST_PITCH, MOST_PITCH, on_change=changed))
        self.focus = self.add(Property("Focal Point", VECTOR, (0.0, 0.0, 0.0), on_change=changed))
        self.focal_size = self.add(floats("Focal Shape Size", 0.05, 0.001, on_change=changed))
        self.focal_fixed = self.add(Property("Focal Shape Fixed Size", BOOL, True, on_change=changed))
        self.add(self.invert)

    def camera(self) -> Camera:
        return self._own_camera()

    def _own_camera(self) -> Camera:
        """The camera as the target frame has it, for views that turn with this frame."""
        yaw, pitch, sign = self.yaw.value, self.pitch.value, 1.0
        if self.invert.value:
            yaw, pitch, sign = -yaw, -pitch, -1.0
        focus = _plus(self.focus.value, self.origin)
        back = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
        position = _plus(focus, _times(back, self.distance.value))
        return _looking(position, _times(back, -1.0), self.near.value, sign)

    def rotate(self, horizontal: float, vertical: float) -> None:
        self.yaw.set((self.yaw.value - horizontal) % (2 * math.pi))
        self.pitch.set(self.pitch.value + vertical)

    def pan(self, right: float, down: float) -> None:
        size = 2 * self.distance.value * math.tan(FIELD_OF_VIEW / 2)
        camera = self._own_camera()
        self._move(_plus(_times(camera.right, -right * size), _times(camera.up, down * size)))

    def _move(self, by: Vector) -> None:
        self.focus.set(_plus(self.focus.value, by))

    def pull(self, down: float, shift: bool) -> None:
        amount = down * 0.1 * self.distance.value / 10
        if shift:
            # Along the camera's own backward axis, as the original does.
            self._move(_times(self._own_camera().forward, -amount))
        else:
            self._nearer(-amount)

    def wheel(self, notches: float, shift: bool) -> None:
        amount = notches * 0.12 * self.distance.value
        if shift:
            self._move(_times(self._own_camera().forward, amount))
        else:
            self._nearer(amount)

    def _nearer(self, metres: float) -> None:
        # Ten metres of a drag must not turn the view inside out: the property has a lower limit.
        self.distance.set(self.distance.value - metres)

    def look_at(self, centre: Vector, radius: float) -> None:
        self.focus.set(self._from_target(centre))
        self.distance.set(max(0.05, radius / math.sin(FIELD_OF_VIEW / 2) * 1.05))

    def turn_to(self, point: Vector) -> None:
        camera = _plus(self._own_camera().position, _times(self.origin, -1.0))
        focus = self._focal(self._from_target(point))
        back = _plus(camera, _times(focus, -1.0))
        distance = math.dist(camera, focus)
        self.focus.set(focus)
        self.distance.set(distance)
        self.pitch.set(math.asin(max(-1.0, min(1.0, back[2] / max(distance, 1e-9)))))
        self.yaw.set(math.atan2(back[1], back[0]) % (2 * math.pi))

    def _focal(self, point: Vector) -> Vector:
        return point

    def _from_target(self, point: Vector) -> Vector:
        """A point of the fixed frame, seen from the target frame."""
        return _plus(point, _times(self.origin, -1.0))

    def _in_fixed_frame(self, point: Vector) -> Vector:
        return _plus(point, self.origin)

    @property
    def focal_shape(self) -> Shape:
        size = self.focal_size.value * (1.0 if self.focal_fixed.value else self.distance.value)
        place = Transform(self._in_fixed_frame(self.focus.value))
        return Shape(SPHERE, place, (size, size, size / 5), self.focal_colour)

    def from_above(self) -> None:
        self.yaw.set(START)
        self.pitch.set(START)


class XYOrbit(Orbit):
    """An orbit whose focal point stays on the ground."""

    type = "XYOrbit"
    help_shift = "Left-Click: Move X/Y.  Right-Click: Zoom."
    focal_colour: Colour = (0.0, 1.0, 1.0, 0.5)

    def _own_camera(self) -> Camera:
        camera = super()._own_camera()
        position = _plus(camera.position, _times(camera.up, self.distance.value * CAMERA_OFFSET))
        return Camera(position, camera.right, camera.up, camera.forward, camera.near)

    def _move(self, by: Vector) -> None:
        x, y, _ = by
        length = math.hypot(x, y)
        limit = 1.0 / max(length, 1.0)  # one metre for one event, so that the horizon does not run away
        focus = self.focus.value
        self.focus.set((focus[0] + x * limit, focus[1] + y * limit, focus[2]))

    def pan(self, right: float, down: float) -> None:
        size = 2 * self.distance.value * math.tan(FIELD_OF_VIEW / 2)
        camera = self._own_camera()
        ahead = (camera.forward[0], camera.forward[1], 0.0)
        length = math.hypot(ahead[0], ahead[1]) or 1.0
        steep = max(0.1, abs(camera.forward[2]))
        self._move(_plus(_times(camera.right, -right * size), _times(ahead, down * size / length / steep)))

    def pull(self, down: float, shift: bool) -> None:
        self._nearer(-down * 0.1 * self.distance.value / 10)

    def wheel(self, notches: float, shift: bool) -> None:
        self._nearer(notches * 0.12 * self.distance.value)

    def look_at(self, centre: Vector, radius: float) -> None:
        super().look_at((centre[0], centre[1], 0.0), radius)

    def _focal(self, point: Vector) -> Vector:
        return point[0], point[1], 0.0


class ThirdPersonFollower(XYOrbit):
    """Turns with the target frame, as somebody does who walks behind it."""

    type = "ThirdPersonFollower"

    def camera(self) -> Camera:
        own = self._own_camera()
        position = self._in_fixed_frame(_plus(own.position, _times(self.origin, -1.0)))
        right, up, forward = (_about_z(axis, self.heading) for axis in (own.right, own.up, own.forward))
        return Camera(position, right, up, forward, own.near)

    def _from_target(self, point: Vector) -> Vector:
        return _about_z(super()._from_target(point), -self.heading)

    def _in_fixed_frame(self, point: Vector) -> Vector:
        return super()._in_fixed_frame(_about_z(point, self.heading))


class TopDownOrtho(View):
    """Straight down, without perspective."""

    type = "TopDownOrtho"
    help = "Left-Click: Rotate.  Middle-Click: Move X/Y.  Right-Click: Zoom.  Shift: More options."
    help_shift = "Left-Click: Move X/Y."

    def build(self) -> None:
        changed = self.touched
        self.scale = self.add(floats("Scale", 10, 1e-6, on_change=changed))
        self.angle = self.add(floats("Angle", 0, on_change=changed))
        self.x = self.add(floats("X", 0, on_change=changed))
        self.y = self.add(floats("Y", 0, on_change=changed))

    def camera(self) -> Camera:
        turn = self.angle.value
        right = (math.cos(turn), math.sin(turn), 0.0)
        up = (-math.sin(turn), math.cos(turn), 0.0)
        place = (self.x.value + self.origin[0], self.y.value + self.origin[1], ORTHO_HEIGHT)
        return Camera(place, right, up, (0.0, 0.0, -1.0), self.near.value, NOMINAL_HEIGHT / self.scale.value)

    def rotate(self, horizontal: float, vertical: float) -> None:
        self.angle.set(self.angle.value + horizontal)

    def pan(self, right: float, down: float) -> None:
        size = NOMINAL_HEIGHT / self.scale.value
        cosine, sine = math.cos(self.angle.value), math.sin(self.angle.value)
        dx, dy = -right * size, down * size
        self.x.set(self.x.value + dx * cosine - dy * sine)
        self.y.set(self.y.value + dx * sine + dy * cosine)

    def pull(self, down: float, shift: bool) -> None:
        self.scale.set(self.scale.value * max(0.05, 1 - down * 0.01))

    def wheel(self, notches: float, shift: bool) -> None:
        self.scale.set(self.scale.value * max(0.05, 1 + notches * 0.12))

    def look_at(self, centre: Vector, radius: float) -> None:
        self.x.set(centre[0] - self.origin[0])
        self.y.set(centre[1] - self.origin[1])
        self.scale.set(NOMINAL_HEIGHT / max(1e-3, radius * 2.2))

    def turn_to(self, point: Vector) -> None:
        self.x.set(point[0] - self.origin[0])
        self.y.set(point[1] - self.origin[1])


class FPS(View):
    """Stands at a place and looks around."""

    type = "FPS"
    help = "Left-Click: Rotate.  Middle-Click: Move X/Y.  Right-Click: Zoom.  Shift: More options."
    help_shift = "Left-Click: Move X/Y.  Right-Click: Move Z."

    def build(self) -> None:
        changed = self.touched
        self.yaw = self.add(floats("Yaw", 0, on_change=changed))
        self.pitch = self.add(floats("Pitch", 0, -MOST_PITCH, MOST_PITCH, on_change=changed))
        self.place = self.add(Property("Position", VECTOR, (5.0, 5.0, 10.0), on_change=changed))
        self.zero()

    def zero(self) -> None:
        self.place.set((5.0, 5.0, 10.0))
        self._turn_to((0.0, 0.0, 0.0))

    def _turn_to(self, point: Vector) -> None:
        dx, dy, dz = (b - a for a, b in zip(self.place.value, point, strict=True))
        self.yaw.set(math.atan2(dy, dx) % (2 * math.pi))
        self.pitch.set(-math.atan2(dz, math.hypot(dx, dy)))

    def camera(self) -> Camera:
        yaw, pitch = self.yaw.value, self.pitch.value
        ahead = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), -math.sin(pitch))
        return _looking(_plus(self.place.value, self.origin), ahead, self.near.value, 1.0)

    def rotate(self, horizontal: float, vertical: float) -> None:
        self.yaw.set((self.yaw.value - horizontal) % (2 * math.pi))
        self.pitch.set(self.pitch.value + vertical)

    def pan(self, right: float, down: float) -> None:
        camera = self.camera()
        step = NOMINAL_HEIGHT * 0.01
        self._move(_plus(_times(camera.right, right * step), _times(camera.up, -down * step)))

    def pull(self, down: float, shift: bool) -> None:
        self._move(_times(self.camera().forward, -down * 0.1))

    def wheel(self, notches: float, shift: bool) -> None:
        self._move(_times(self.camera().forward, notches * 1.2))

    def zoom(self, steps: float) -> None:
        self._move(_times(self.camera().forward, steps * 0.25))

    def _move(self, by: Vector) -> None:
        self.place.set(_plus(self.place.value, by))

    def look_at(self, centre: Vector, radius: float) -> None:
        distance = radius / math.sin(FIELD_OF_VIEW / 2) * 1.05
        back = _times(self.camera().forward, -distance)
        self.place.set(_plus(_plus(centre, back), _times(self.origin, -1.0)))

    def turn_to(self, point: Vector) -> None:
        self._turn_to(_plus(point, _times(self.origin, -1.0)))

    def from_above(self) -> None:
        x, y, _ = self.place.value
        distance = math.hypot(x, y) or 1.0
        self.place.set((x, y, distance))
        self._turn_to((0.0, 0.0, 0.0))


class SavedView(Property):
    """A view that was kept under a name; its line leads back to it."""

    def __init__(self, config: dict[str, Any]) -> None:
        class_id = str(config.get("Class", ""))
        super().__init__(str(config.get("Name", class_id)), TEXT, str(config.get("Value", class_id)), read_only=True)
        self._config = config

    @property
    def config(self) -> dict[str, Any]:
        """What a .rviz file holds of it."""
        return {**self._config, "Name": self.name}

    @property
    def view_type(self) -> str:
        """Its view controller."""
        return str(self._config.get("Class", "")).rpartition("/")[2]


VIEWS: dict[str, type[View]] = {view.type: view for view in (Orbit, XYOrbit, TopDownOrtho, FPS, ThirdPersonFollower)}


def copied(old: View, new: View) -> None:
    """Let a new view show what the old one showed, as far as it can (the originals' `mimic`)."""
    new.target.value, new.origin = old.target.value, old.origin
    if isinstance(old, TopDownOrtho) and isinstance(new, TopDownOrtho):
        for name in ("Scale", "Angle", "X", "Y"):
            new.child(name).value = old.child(name).value
    elif isinstance(old, Orbit) and isinstance(new, Orbit):
        for name in ("Distance", "Yaw", "Pitch", "Focal Point"):
            new.child(name).value = old.child(name).value
        if isinstance(new, XYOrbit):
            x, y, _ = new.focus.value
            new.focus.value = (x, y, 0.0)
    elif isinstance(old, Orbit) and isinstance(new, TopDownOrtho):
        new.x.value, new.y.value, _ = old.focus.value
        # The original keeps Scale 10, with which a small robot is a dot; as much as before is seen instead.
        new.scale.value = NOMINAL_HEIGHT / (2 * old.distance.value * math.tan(FIELD_OF_VIEW / 2))
    elif isinstance(old, Orbit) and isinstance(new, FPS):
        new.place.value = _plus(old.camera().position, _times(old.origin, -1.0))
        new.yaw.value, new.pitch.value = (old.yaw.value + math.pi) % (2 * math.pi), old.pitch.value
    elif isinstance(old, TopDownOrtho) and isinstance(new, Orbit):
        new.focus.value = (old.x.value, old.y.value, 0.0)
        new.distance.value = NOMINAL_HEIGHT / old.scale.value / (2 * math.tan(FIELD_OF_VIEW / 2))
    elif isinstance(old, FPS) and isinstance(new, Orbit):
        camera = old.camera()
        new.distance.value = math.dist(old.place.value, (0.0, 0.0, 0.0))
        new.focus.value = _plus(old.place.value, _times(camera.forward, new.distance.value))
        new.yaw.value, new.pitch.value = (old.yaw.value + math.pi) % (2 * math.pi), old.pitch.value


def view_type_options() -> list[str]:
    """What the panel's `Type` offers."""
    return list(VIEWS)


def type_property(on_change: Callable[[], object]) -> Property:
    """The chooser of the view type."""
    return Property("Type", ENUM, "Orbit", options=view_type_options(), saved=False, on_change=on_change)


def _looking(position: Vector, forward: Vector, near: float, sign: float) -> Camera:
    """A camera whose right is level."""
    fx, fy, fz = forward
    # forward x z, which never vanishes: pitch stays below 90 degrees.
    length = math.hypot(fx, fy)
    right = (fy / length * sign, -fx / length * sign, 0.0)
    up = (right[1] * fz - right[2] * fy, right[2] * fx - right[0] * fz, right[0] * fy - right[1] * fx)
    return Camera(position, right, up, forward, near)


def _about_z(point: Vector, angle: float) -> Vector:
    x, y, z = point
    cosine, sine = math.cos(angle), math.sin(angle)
    return x * cosine - y * sine, x * sine + y * cosine, z


def _plus(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _times(a: Vector, factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor
