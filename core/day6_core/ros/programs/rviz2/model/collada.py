"""COLLADA (.dae): the triangles of the scene with their diffuse colours; textures, bones and animation are left out."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.plain_xml import plain_xml

DEEPEST = 64
MOST_INSTANCES = 2000
_GREY = (0.7, 0.7, 0.7)


def read_collada(path: Path, progress: Callable[[float], None]) -> tuple[Any, Any]:
    """Corners (M x 3 x 3, metres) and colours (M x 3) of a file. Raises ValueError."""
    import numpy as np

    try:
        root = plain_xml(path.read_bytes())
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from None
    progress(0.4)
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2]
    file = _Collada(root)
    corners, colours = file.scene()
    if not corners:
        raise ValueError(f"{path.name} has no triangles")
    unit = root.find("asset/unit")
    metres = float(unit.get("meter", "1")) if unit is not None else 1.0
    return np.concatenate(corners) * metres, np.concatenate(colours)


class _Collada:
    def __init__(self, root: Any) -> None:
        self._root = root
        self._by_id = {element.get("id"): element for element in root.iter() if element.get("id")}
        self._instances = 0
        self._known: dict[str, list[tuple[str, Any]]] = {}

    def scene(self) -> tuple[list[Any], list[Any]]:
        """All geometries of the scene, each where its node puts it."""
        import numpy as np

        corners: list[Any] = []
        colours: list[Any] = []
        link = self._root.find("scene/instance_visual_scene")
        scene = self._target(link) if link is not None else self._root.find("library_visual_scenes/visual_scene")
        for node in scene.findall("node") if scene is not None else ():
            self._walk(node, np.eye(4), corners, colours, 0)
        if scene is None:
            for geometry in self._root.iter("geometry"):
                self._put(geometry, {}, np.eye(4), corners, colours)
        return corners, colours

    def _target(self, link: Any) -> Any:
        return self._by_id.get((link.get("url") or "").lstrip("#"))

    def _walk(self, node: Any, above: Any, corners: list[Any], colours: list[Any], depth: int) -> None:
        if depth > DEEPEST:
            return
        pose = above
        for child in node:
            if child.tag in _STEPS:
                pose = pose @ _STEPS[child.tag](_numbers(child))
        for child in node:
            if child.tag == "instance_geometry":
                geometry = self._target(child)
                materials = {each.get("symbol"): each.get("target") for each in child.iter("instance_material")}
                if geometry is not None:
                    self._put(geometry, materials, pose, corners, colours)
            elif child.tag == "node":
                self._walk(child, pose, corners, colours, depth + 1)
            elif child.tag == "instance_node" and (target := self._target(child)) is not None:
                self._walk(target, pose, corners, colours, depth + 1)

    def _put(self, geometry: Any, materials: Any, pose: Any, corners: list[Any], colours: list[Any]) -> None:
        import numpy as np

        self._instances += 1
        if self._instances > MOST_INSTANCES:
            raise ValueError("too many instances")
        for symbol, triangles in self._triangles(geometry):
            moved = triangles.reshape(-1, 3) @ pose[:3, :3].T + pose[:3, 3]
            corners.append(moved.reshape(-1, 3, 3).astype(np.float32))
            colour = self._colour(materials.get(symbol) or symbol)
            colours.append(np.tile(np.array(colour, np.float32), (len(triangles), 1)))

    def _triangles(self, geometry: Any) -> list[tuple[str, Any]]:
        """Material symbols and corners of the primitives of one geometry, read once."""
        import numpy as np

        key = geometry.get("id") or str(id(geometry))
        if key in self._known:
            return self._known[key]
        found: list[tuple[str, Any]] = []
        for primitive in geometry.findall("mesh/*"):
            if primitive.tag not in ("triangles", "polylist", "polygons"):
                continue
            inputs = primitive.findall("input")
            vertex = next((each for each in inputs if each.get("semantic") == "VERTEX"), None)
            if vertex is None:
                continue
            stride = 1 + max(int(each.get("offset", "0")) for each in inputs)
            points = self._positions(vertex)
            for index, sizes in _polygons(primitive, stride, int(vertex.get("offset", "0"))):
                fans = _fans(index, sizes)
                if len(fans) and (fans.min() < 0 or fans.max() >= len(points)):
                    raise ValueError("a face without vertices")
                if len(fans):
                    found.append((primitive.get("material", ""), np.asarray(points)[fans]))
        self._known[key] = found
        return found

    def _positions(self, vertex: Any) -> Any:
        import numpy as np

        vertices = self._by_id.get(vertex.get("source", "").lstrip("#"))
        link = vertices.find("input[@semantic='POSITION']") if vertices is not None else None
        source = self._by_id.get(link.get("source", "").lstrip("#")) if link is not None else None
        array = source.find("float_array") if source is not None else None
        if source is None or array is None:
            raise ValueError("a mesh without positions")
        numbers = np.array((array.text or "").split(), np.float64)
        accessor = source.find("technique_common/accessor")
        stride = int(accessor.get("stride", "3")) if accessor is not None else 3
        return numbers[: len(numbers) // stride * stride].reshape(-1, stride)[:, :3]

    def _colour(self, material: str | None) -> tuple[float, ...]:
        element = self._by_id.get((material or "").lstrip("#"))
        link = element.find("instance_effect") if element is not None else None
        effect = self._target(link) if link is not None else None
        if effect is None:
            return _GREY
        for diffuse in effect.iter("diffuse"):
            colour = diffuse.find("color")
            if colour is not None:
                numbers = _numbers(colour)
                if len(numbers) >= 3 and all(map(math.isfinite, numbers)):
                    return tuple(numbers[:3])
        return _GREY


def _numbers(element: Any) -> list[float]:
    return [float(part) for part in (element.text or "").split()]


def _polygons(primitive: Any, stride: int, offset: int) -> list[tuple[Any, Any]]:
    """Vertex indices and numbers of corners."""
    import numpy as np

    parts = []
    counts = primitive.find("vcount")
    for lump in primitive.findall("p"):
        index = np.array((lump.text or "").split(), np.int64)
        index = index[: len(index) // stride * stride].reshape(-1, stride)[:, offset]
        if counts is not None:
            sizes = np.array((counts.text or "").split(), np.int64)
        elif primitive.tag == "polygons":
            sizes = np.array([len(index)], np.int64)
        else:
            sizes = np.full(len(index) // 3, 3, np.int64)
        parts.append((index, sizes))
    return parts


def _fans(index: Any, sizes: Any) -> Any:
    """Polygons cut into triangles around their first corner: M x 3 indices."""
    import numpy as np

    if len(sizes) and sizes.sum() > len(index):
        raise ValueError("a polygon with too few corners")
    starts = np.cumsum(sizes) - sizes
    found = []
    for size in np.unique(sizes).tolist():
        first = starts[sizes == size]
        for corner in range(1, min(size, 10_000) - 1):
            found.append(np.stack([index[first], index[first + corner], index[first + corner + 1]], axis=1))
    return np.concatenate(found) if found else np.zeros((0, 3), np.int64)


def _matrix(numbers: list[float]) -> Any:
    import numpy as np

    return np.array(numbers[:16]).reshape(4, 4)


def _translate(numbers: list[float]) -> Any:
    import numpy as np

    result = np.eye(4)
    result[:3, 3] = numbers[:3]
    return result


def _scale(numbers: list[float]) -> Any:
    import numpy as np

    return np.diag([*numbers[:3], 1.0])


def _rotate(numbers: list[float]) -> Any:
    import numpy as np

    x, y, z, degrees = numbers[:4]
    length = math.sqrt(x * x + y * y + z * z) or 1.0
    half = math.radians(degrees) / 2
    from day6_core.ros.programs.rviz2.model.turning import matrix

    sine = math.sin(half) / length
    result = np.eye(4)
    result[:3, :3] = matrix((x * sine, y * sine, z * sine, math.cos(half)))
    return result


_STEPS: dict[str, Callable[[list[float]], Any]] = {
    "matrix": _matrix,
    "translate": _translate,
    "scale": _scale,
    "rotate": _rotate,
}
