"""The only module that uses yourdfpy: it imports it lightly and converts its robot to our plain data.

A plain `import yourdfpy` takes about a second and 100 MB, because of trimesh with scipy, networkx and a dozen others. To read a
URDF takes its module `transformations` only, so nothing else of it is executed until somebody asks for it: a fifth of the time
and memory. It still takes some tenths of a second, so a program calls this from a thread.
"""

from __future__ import annotations

import importlib
import importlib.util
import io
import logging
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

from day6_urdf.model import (
    Box,
    Calibration,
    Collision,
    Cylinder,
    Dynamics,
    Geometry,
    Inertial,
    Joint,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Quaternion,
    Robot,
    Safety,
    Sphere,
    Vector,
    Visual,
)

if TYPE_CHECKING:
    import yourdfpy

_lock = threading.RLock()
_log = logging.getLogger(__name__)


class _Later:
    """A generator of random numbers that is made when it is used first."""

    def __init__(self, *seed: Any) -> None:
        self._seed = seed

    @cached_property
    def _made(self) -> Any:
        import numpy

        return numpy.random.default_rng(*self._seed)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._made, name)


@contextmanager
def _few_names_of_random() -> Iterator[None]:
    """Let numpy.random, which takes 7 MB together with OpenSSL, have only what trimesh needs while it is imported.

    Those are classes of its annotations, and a generator that it may use later. Any other name brings the real module, in
    every thread.
    """
    import numpy

    name, annotated = "numpy.random", ("BitGenerator", "Generator", "SeedSequence")
    if name in sys.modules:
        yield
        return
    stand_in = ModuleType(name)

    def leave() -> None:
        if sys.modules.get(name) is stand_in:
            del sys.modules[name]
        if vars(numpy).get("random") is stand_in:
            del numpy.random

    def real(wanted: str) -> Any:
        if wanted.startswith("__"):  # the import system looks what kind of module it is
            raise AttributeError(wanted)
        leave()
        return getattr(importlib.import_module(name), wanted)

    vars(stand_in).update({each: type(each, (), {}) for each in annotated}, default_rng=_Later, __getattr__=real)
    sys.modules[name] = stand_in
    vars(numpy)["random"] = stand_in
    try:
        yield
    finally:
        leave()


@contextmanager
def _without_trimesh() -> Iterator[None]:
    """Let trimesh be a package whose modules can be imported, but not itself: 10 MB that only its scenes and meshes need.

    Whatever is asked of it later brings it whole.
    """
    spec = importlib.util.find_spec("trimesh")
    loader = spec.loader if spec is not None else None
    if "trimesh" in sys.modules or spec is None or loader is None:
        yield
        return
    package = importlib.util.module_from_spec(spec)
    annotated = {each: type(each, (), {}) for each in ("Scene", "Trimesh")}

    def leave() -> None:
        for each in annotated:
            vars(package).pop(each, None)

    def whole(wanted: str) -> Any:
        if wanted.startswith("__"):  # the import system looks what kind of module it is
            raise AttributeError(wanted)
        with _lock:
            if vars(package).pop("__getattr__", None):
                leave()
                loader.exec_module(package)
        return getattr(package, wanted)

    vars(package).update(annotated, __getattr__=whole)
    sys.modules["trimesh"] = package
    try:
        yield
    except BaseException:
        del sys.modules["trimesh"]
        raise
    finally:
        leave()


def module() -> ModuleType:
    """Return yourdfpy, imported on the first call. Callable from any thread."""
    with _lock:
        # Where something is missing trimesh logs tracebacks to stderr, which would garble a full-screen terminal program.
        for name in ("trimesh", "yourdfpy"):
            logging.getLogger(name).setLevel(logging.CRITICAL)
        loaded = sys.modules.get("yourdfpy")
        if loaded is not None:
            return loaded
        try:
            with _without_trimesh(), _few_names_of_random():
                return importlib.import_module("yourdfpy")
        except Exception as error:  # this trimesh needs them after all: slower and larger, but correct
            _log.info("yourdfpy did not import lightly (%s), importing it in full", error)
            for name in [name for name in sys.modules if name.split(".")[0] in ("yourdfpy", "trimesh")]:
                del sys.modules[name]
            return importlib.import_module("yourdfpy")


def load(text: str) -> yourdfpy.URDF:
    """Return yourdfpy's model of a checked description, without meshes and scene; raises any error of yourdfpy."""
    file = io.BytesIO(text.encode("utf-8"))
    return module().URDF.load(
        file,
        build_scene_graph=False,
        build_collision_scene_graph=False,
        load_meshes=False,
        load_collision_meshes=False,
    )


def robot_of(urdf: yourdfpy.URDF) -> Robot:
    """Return yourdfpy's robot as plain data, with every material used by name resolved."""
    source = urdf.robot
    materials = _Materials(source.materials)
    links = tuple(_link(link, materials) for link in source.links)
    return Robot(source.name, links, tuple(_joint(joint) for joint in source.joints), materials.known())


class _Materials:
    """Materials by name: the global ones, then those defined inside visuals, the first of a name (urdfdom's rule)."""

    def __init__(self, sources: list[Any]) -> None:
        self._known: dict[str, Material] = {}
        for source in sources:
            material = _material(source)
            if material.color is None and material.texture is None:
                material = Material(material.name, (0.0, 0.0, 0.0, 1.0))
            self._known.setdefault(material.name, material)

    def known(self) -> tuple[Material, ...]:
        return tuple(self._known.values())

    def resolve(self, source: Any) -> Material | None:
        own = _material(source)
        defined = own if own.color is not None or own.texture is not None else None
        if not own.name:
            return defined
        if own.name not in self._known and defined is not None:
            self._known[own.name] = defined
        return self._known.get(own.name)


def _material(source: Any) -> Material:
    color = None
    if source.color is not None:
        numbers = [float(number) for number in source.color.rgba]
        color = (numbers[0], numbers[1], numbers[2], numbers[3]) if len(numbers) == 4 else (0.0, 0.0, 0.0, 1.0)
    return Material(source.name or "", color, source.texture.filename if source.texture is not None else None)


def _link(source: Any, materials: _Materials) -> Link:
    visuals = []
    for visual in source.visuals:
        name = (visual.material.name or "") if visual.material is not None else ""
        material = materials.resolve(visual.material) if visual.material is not None else None
        visuals.append(Visual(_geometry(visual.geometry), _pose(visual.origin), visual.name or "", name, material))
    collisions = tuple(
        Collision(_geometry(collision.geometry), _pose(collision.origin), collision.name or "")
        for collision in source.collisions
    )
    return Link(source.name, tuple(visuals), collisions, _inertial(source.inertial))


def _inertial(source: Any) -> Inertial | None:
    if source is None:
        return None
    (ixx, ixy, ixz), (_, iyy, iyz), (_, _, izz) = ([float(item) for item in row] for row in source.inertia)
    return Inertial(float(source.mass), (ixx, ixy, ixz, iyy, iyz, izz), _pose(source.origin))


def _geometry(source: Any) -> Geometry:
    if source.box is not None:
        return Box(_vector(source.box.size))
    if source.cylinder is not None:
        return Cylinder(float(source.cylinder.radius), float(source.cylinder.length))
    if source.sphere is not None:
        return Sphere(float(source.sphere.radius))
    scale = source.mesh.scale
    if scale is None:
        return Mesh(source.mesh.filename)
    return Mesh(source.mesh.filename, _vector(scale) if hasattr(scale, "__len__") else (float(scale),) * 3)


def _joint(source: Any) -> Joint:
    dynamics = source.dynamics
    return Joint(
        source.name,
        source.type,
        source.parent,
        source.child,
        _pose(source.origin),
        # yourdfpy gives every joint an axis; for these types it has no meaning, and urdfdom leaves it at zero.
        (0.0, 0.0, 0.0) if source.type in ("fixed", "floating") else _vector(source.axis),
        _numbers(Limit, source.limit, ("lower", "upper", "effort", "velocity")),
        None
        if source.mimic is None
        else Mimic(source.mimic.joint, _number(source.mimic.multiplier, 1.0), _number(source.mimic.offset, 0.0)),
        # yourdfpy leaves these two as text.
        None if dynamics is None else Dynamics(_number(dynamics.damping, 0.0), _number(dynamics.friction, 0.0)),
        _numbers(
            Safety, source.safety_controller, ("soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity")
        ),
        None
        if source.calibration is None
        else Calibration(_optional(source.calibration.rising), _optional(source.calibration.falling)),
    )


def _numbers(kind: Any, source: Any, names: tuple[str, ...]) -> Any:
    return None if source is None else kind(*(_number(getattr(source, name), 0.0) for name in names))


def _number(value: Any, default: float) -> float:
    return default if value is None else float(value)


def _optional(value: Any) -> float | None:
    return None if value is None else float(value)


def _vector(values: Any) -> Vector:
    x, y, z = (float(value) for value in values)
    return x, y, z


def _pose(matrix: Any) -> Pose:
    if matrix is None:
        return Pose()
    rows = [[float(value) for value in row] for row in matrix]
    return Pose((rows[0][3], rows[1][3], rows[2][3]), _quaternion(rows))


def _quaternion(m: list[list[float]]) -> Quaternion:
    """Return the unit quaternion of a 3x3 rotation matrix, computed from its largest component to avoid cancellation."""
    traces = (
        m[0][0] - m[1][1] - m[2][2],
        m[1][1] - m[0][0] - m[2][2],
        m[2][2] - m[0][0] - m[1][1],
        m[0][0] + m[1][1] + m[2][2],
    )
    largest = traces.index(max(traces))
    double = (1 + traces[largest]) ** 0.5
    if largest == 3:
        numbers = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], double * double]
    else:
        i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
        numbers = [0.0, 0.0, 0.0, m[k][j] - m[j][k]]
        numbers[i], numbers[j], numbers[k] = double * double, m[j][i] + m[i][j], m[k][i] + m[i][k]
    x, y, z, w = (number / (2 * double) for number in numbers)
    return x, y, z, w
