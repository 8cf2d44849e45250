"""The visible objects as plain data in the fixed frame: shapes, lines, points, meshes, labels. Metres, colours 0..1.

A display puts its part together in `draw`; whoever paints it (day6_tui/render) knows nothing of displays. Objects are frozen and
are handed on unchanged as long as they look the same, so that a painter may remember what it made of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from day6_urdf.kinematics import IDENTITY, Transform, compose, rotate
from day6_urdf.model import Pose, Quaternion, Vector

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.views import Camera

Colour = tuple[float, float, float, float]
"""Red, green, blue, alpha in 0..1."""

BOX, CYLINDER, SPHERE, CONE = "box", "cylinder", "sphere", "cone"


_PLAIN = (str, float, int, tuple, Pose)
"""What is compared by value, and so are lists of them that are short."""

_SHORT = 64


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """A solid of the given full extents; cylinders and cones stand on z (a cone's tip is up)."""

    kind: str
    pose: Transform
    size: Vector
    colour: Colour
    name: str = ""
    """The link it belongs to, '' for axes and arrows."""
    marked: bool = False
    """A wheel: painted in sectors, because a plain cylinder that turns looks as if it stood."""
    lit: bool = True
    """Shaded; what is in error is plain white all over."""


@dataclass(frozen=True, slots=True, eq=False)
class Lines:
    """Separate segments: vertices 0-1, 2-3 and so on. `colours` is one colour, or one for each vertex."""

    vertices: Sequence[Vector]
    colours: Sequence[Colour]
    pose: Transform = IDENTITY
    width: float = 0.0
    """Metres; 0 is one pixel."""
    lattice: bool = False
    """A grid of one colour in a plane: segments of two directions by turns, each direction in equal steps. A painter may leave
    out lines that come so close that nobody could tell them apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """`xyz` is N x 3 numbers, `colours` one colour or N of them; `size` in metres, 0 for one pixel."""

    xyz: Any
    colours: Any
    size: float = 0.0
    pose: Transform = IDENTITY


@dataclass(frozen=True, slots=True, eq=False)
class Triangles:
    """A mesh: `vertices` N x 3, `faces` M x 3 indices, `colours` None or M x 3 (0..1), which `colour` then only fades."""

    vertices: Any
    faces: Any
    pose: Transform
    scale: Vector
    colour: Colour
    colours: Any = None
    name: str = ""
    lit: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """A rectangle in the x-y plane from the origin of `pose`: `pixels` is rows x columns x 4 (0..255), row 0 lowest."""

    pixels: Any
    pose: Transform
    resolution: float
    behind: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """What is seen by the camera that took a picture; lengths are parts of the picture's width and height."""

    scene: Scene
    camera: Camera
    focal: tuple[float, float]
    middle: tuple[float, float]
    """The optical axis, right of the middle of the picture and below it."""
    zoom: float
    """The size of the picture in the frame it is shown in."""
    far: float
    """Metres; what is farther away is not seen."""
    behind: bool
    """Whether the picture is behind the scene."""
    alpha: float
    """How much of the picture lies over the scene."""


@dataclass(frozen=True, slots=True, eq=False)
class Overlay:
    """A picture that lies on the view: `pixels` is rows x columns x 3 (0..255), row 0 highest."""

    name: str
    pixels: Any
    sight: Sight | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Label:
    """A text at a place; it always faces the viewer."""

    text: str
    position: Vector
    colour: Colour
    is_name: bool = False
    """Whether it only names what is there: it should not cover that."""


@dataclass(frozen=True, slots=True, eq=False)
class Mark:
    """Says that what follows in a scene's lists, up to the next mark, shows the thing `key` of `owner`."""

    owner: Any
    """The display that shows it; None if it cannot be picked, as a grid."""
    key: Any
    starts: tuple[int, ...]
    """The lengths of the lists when it was made."""


@dataclass(slots=True, eq=False)
class Scene:
    """Everything at one moment. Filled by displays, then left alone."""

    background: tuple[int, int, int] = (48, 48, 48)
    shapes: list[Shape] = field(default_factory=list)
    lines: list[Lines] = field(default_factory=list)
    points: list[Points] = field(default_factory=list)
    triangles: list[Triangles] = field(default_factory=list)
    images: list[Image] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)
    overlays: list[Overlay] = field(default_factory=list)
    marks: list[Mark] = field(default_factory=list)

    @property
    def _solid(self) -> tuple[list[Any], ...]:
        """The lists of what can be picked."""
        return self.shapes, self.lines, self.points, self.triangles

    def begin(self, owner: Any, key: Any = "") -> None:
        """Say whose the objects are that are added from now on."""
        self.marks.append(Mark(owner, key, tuple(map(len, self._solid))))

    def looks_like(self, other: Scene) -> bool:
        """Whether it would be painted as the other one; arrays are compared by identity."""
        return self.background == other.background and all(
            len(own) == len(theirs) and all(map(_looks_like, own, theirs))
            for own, theirs in zip(self._lists, other._lists, strict=True)
        )

    @property
    def _lists(self) -> tuple[list[Any], ...]:
        return (*self._solid, self.images, self.labels, self.overlays, self.marks)

    def beside(self, shape: Shape | None) -> Scene:
        """The scene with one more shape, that cannot be picked."""
        return self if shape is None else replace(self, shapes=[*self.shapes, shape])

    def lighten(self, amount: float) -> None:
        """Make what was added since the last mark brighter, and opaque: it is in use."""
        shapes, lines, points, triangles = self.marks[-1].starts

        def lit(colour: Colour) -> Colour:
            red, green, blue, _ = colour
            return min(1.0, red + amount), min(1.0, green + amount), min(1.0, blue + amount), 1.0

        self.shapes[shapes:] = [replace(each, colour=lit(each.colour)) for each in self.shapes[shapes:]]
        for number, each in enumerate(self.lines[lines:], lines):
            self.lines[number] = replace(each, colours=[lit(colour) for colour in each.colours])
        for number, cloud in enumerate(self.points[points:], points):
            self.points[number] = replace(cloud, colours=[lit(colour) for colour in cloud.colours])
        for number, mesh in enumerate(self.triangles[triangles:], triangles):
            colours = mesh.colours + amount if mesh.colours is not None else None
            self.triangles[number] = replace(mesh, colour=lit(mesh.colour), colours=colours)

    def parts(self) -> Iterator[tuple[Mark, Scene]]:
        """What can be picked, each thing as a scene of its own."""
        ends = [mark.starts for mark in self.marks[1:]] + [tuple(map(len, self._solid))]
        for mark, end in zip(self.marks, ends, strict=True):
            if mark.owner is not None and mark.starts != end:
                lists = (each[a:b] for each, a, b in zip(self._solid, mark.starts, end, strict=True))
                shapes, lines, points, triangles = lists
                yield mark, Scene(self.background, shapes, lines, points, triangles)

    def some_point(self) -> Vector | None:
        """A point of the first thing there is."""
        for shape in self.shapes:
            return shape.pose.xyz
        for mesh in self.triangles:
            x, y, z = (float(part * size) for part, size in zip(mesh.vertices[0], mesh.scale, strict=True))
            return placed(mesh.pose, (x, y, z))
        for lines in self.lines:
            return placed(lines.pose, lines.vertices[0])
        for points in self.points:
            x, y, z = map(float, points.xyz[0])
            return placed(points.pose, (x, y, z))
        return None

    def axes(self, pose: Transform, length: float, radius: float, alpha: float = 1.0, grey: float = 0.0) -> None:
        """The three axes of a frame: x red, y green, z blue; `grey` 1 takes all their colour."""
        for axis, turn in enumerate(_AXIS_TURNS):
            centre: Vector = tuple(length / 2 if index == axis else 0.0 for index in range(3))  # type: ignore[assignment]
            red, green, blue = ((1 - grey) * (1.0 if index == axis else 0.0) + grey * 0.7 for index in range(3))
            self.shapes.append(
                Shape(
                    CYLINDER,
                    compose(pose, Transform(centre, turn)),
                    (2 * radius, 2 * radius, length),
                    (red, green, blue, alpha),
                )
            )

    def arrow(
        self,
        pose: Transform,
        shaft_length: float,
        shaft_diameter: float,
        head_length: float,
        head_diameter: float,
        shaft: Colour,
        head: Colour | None = None,
    ) -> None:
        """An arrow from the origin of `pose` along its x."""
        along = compose(pose, Transform((0.0, 0.0, 0.0), Z_TO_X))
        if shaft_length > 0:
            place = compose(along, Transform((0.0, 0.0, shaft_length / 2)))
            self.shapes.append(Shape(CYLINDER, place, (shaft_diameter, shaft_diameter, shaft_length), shaft))
        tip = compose(along, Transform((0.0, 0.0, shaft_length + head_length / 2)))
        self.shapes.append(Shape(CONE, tip, (head_diameter, head_diameter, head_length), head or shaft))


_HALF = 0.5**0.5
Z_TO_X: Quaternion = (0.0, _HALF, 0.0, _HALF)
"""Turns the z axis onto x."""

_AXIS_TURNS: tuple[Quaternion, Quaternion, Quaternion] = (Z_TO_X, (-_HALF, 0.0, 0.0, _HALF), (0.0, 0.0, 0.0, 1.0))


def pointing(start: Vector, end: Vector) -> Transform:
    """The pose at `start` whose x looks to `end`."""
    dx, dy, dz = end[0] - start[0], end[1] - start[1], end[2] - start[2]
    length = (dx * dx + dy * dy + dz * dz) ** 0.5
    if length == 0:
        return Transform(start)
    dx, dy, dz = dx / length, dy / length, dz / length
    if dx < -0.999999:
        return Transform(start, (0.0, 0.0, 1.0, 0.0))
    # The half-way rotation from (1, 0, 0) to (dx, dy, dz).
    w = 1 + dx
    norm = (w * w + dy * dy + dz * dz) ** 0.5
    return Transform(start, (0.0, -dz / norm, dy / norm, w / norm))


def placed(pose: Transform, point: Vector) -> Vector:
    """A point given in the frame `pose`."""
    x, y, z = rotate(pose.rotation, point)
    return pose.xyz[0] + x, pose.xyz[1] + y, pose.xyz[2] + z


def _looks_like(one: Any, other: Any) -> bool:
    """Whether two objects of a scene look the same."""
    if one is other:
        return True
    return type(one) is type(other) and all(
        mine is theirs or (type(mine) is type(theirs) and _is_plain(mine) and mine == theirs)
        for mine, theirs in ((getattr(one, name), getattr(other, name)) for name in one.__slots__)
    )


def _is_plain(value: object) -> bool:
    return isinstance(value, _PLAIN) or (
        isinstance(value, list) and len(value) <= _SHORT and all(isinstance(each, _PLAIN) for each in value)
    )
