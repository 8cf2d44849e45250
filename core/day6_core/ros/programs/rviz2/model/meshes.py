"""Finding and reading the meshes of a robot: STL, OBJ and DAE, by numpy alone, in bounded time and memory.

A terminal has some ten thousand pixels, so a mesh of more triangles than that is made coarser while it is read: corners in
the same small cube become one.

Which files: `package://` is confined to the package, whoever names it. A description or marker that came from this machine (a
file that the user opened, a publisher of one of the user's processes) may name any file by `file://` or its path, as in RViz,
which reads as the user. What came from another machine may not: it could find out what files there are, or make the system
ask a server (`//server/share` on Windows).
"""

from __future__ import annotations

import stat
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlparse

MOST_BYTES = 600_000_000
MOST_TEXT_BYTES = 120_000_000
"""Of OBJ, DAE and STL as text, which take ten times their size while they are read."""

MOST_TRIANGLES = 20_000
CUBES = 126
"""Small cubes along the longest side of a mesh that is made coarser: their numbers fit into 21 bits."""

CHUNK = 200_000
"""Triangles read in one go; between two chunks the work may be given up."""


class MeshError(ValueError):
    """The file isn't a readable mesh."""


class Cancelled(ValueError):
    """The mesh is no longer needed."""


@dataclass(frozen=True, eq=False)
class MeshData:
    """`vertices` N x 3 (metres), `faces` M x 3 indices, `colours` None or M x 3 (0..1)."""

    vertices: Any
    faces: Any
    colours: Any = None


class MeshStore:
    """Reads each mesh of one robot once; `share_of` gives the share folder of a package, or raises LookupError.

    `anywhere`: the robot is of this machine, and its meshes may lie outside packages.
    """

    def __init__(
        self,
        share_of: Callable[[str], str],
        folder: Path | None = None,
        cancelled: Callable[[], bool] = lambda: False,
        progress: Callable[[str], None] = lambda text: None,
        *,
        anywhere: bool = True,
    ) -> None:
        self._anywhere = anywhere
        self._share_of = share_of
        self._folder = folder
        self._cancelled = cancelled
        self._progress = progress
        self._known: dict[str, MeshData | OSError | ValueError] = {}

    def read(self, uri: str) -> MeshData:
        """The mesh of a URI: package://, file://, an absolute path, or one beside the robot's file.

        Raises OSError or ValueError.
        """
        if self._cancelled():
            raise Cancelled(uri)
        if uri not in self._known:
            try:
                self._known[uri] = self._read(uri)
            except LookupError as error:
                self._known[uri] = FileNotFoundError(str(error))
            except (OSError, ValueError) as error:
                self._known[uri] = error
        found = self._known[uri]
        if isinstance(found, Exception):
            raise found
        return found

    def find(self, uri: str) -> Path:
        """The file of a URI. Raises OSError, LookupError for a package that is not there, MeshError for a forbidden place."""
        parsed = urlparse(uri)
        if parsed.scheme == "package":
            return _inside(Path(self._share_of(parsed.netloc)), unquote(parsed.path), uri)
        if not self._anywhere:
            raise MeshError(f"{uri}: a robot of another machine may only use files of packages")
        if parsed.scheme == "file":
            return Path(unquote(parsed.netloc + parsed.path))
        path = Path(uri)
        if path.is_absolute():
            return path
        if self._folder is None:
            raise FileNotFoundError(uri)
        return self._folder / path

    def _read(self, uri: str) -> MeshData:
        path = self.find(uri)
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise MeshError(f"{path.name} is not a file")  # opening a pipe would wait for its other end
        size = status.st_size
        suffix = path.suffix.lower()

        def progress(part: float) -> None:
            if self._cancelled():
                raise Cancelled(uri)
            self._progress(f"{path.name} {part:.0%}")

        if size > MOST_BYTES or (size > MOST_TEXT_BYTES and suffix != ".stl"):
            raise MeshError(f"{path.name} is too large")
        progress(0.0)
        reader = {".stl": read_stl, ".obj": read_obj, ".dae": read_dae}.get(suffix)
        if reader is None:
            raise MeshError(f"{path.name}: this kind of mesh is not known")
        return reader(path, progress)


def _inside(share: Path, name: str, uri: str) -> Path:
    """Return a file of a package, which neither dots nor links lead out of. Raises MeshError.

    With `colcon build --symlink-install` the files are links into the package's sources, and so is its package.xml.
    """
    path = share / name.replace("\\", "/").lstrip("/")
    manifest = share / "package.xml"
    homes = (share.resolve(), manifest.resolve().parent)
    outside = ".." in path.relative_to(share).parts if path.is_relative_to(share) else True
    if outside or not any(path.resolve().is_relative_to(home) for home in homes):
        raise MeshError(f"{uri} leads out of its package")
    return path


Progress = Callable[[float], None]


def read_stl(path: Path, progress: Progress) -> MeshData:
    """An STL file, binary or text."""
    import numpy as np

    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(84)
    count = int.from_bytes(head[80:84], "little") if len(head) == 84 else 0
    if len(head) == 84 and size >= 84 + 50 * count > 84:
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])

        def chunks() -> Iterator[Any]:
            # Opened anew for every pass: a memory map would stay in memory as long as pages are there to be had.
            with path.open("rb") as file:
                file.seek(84)
                done = 0
                while done < count:
                    part = np.fromfile(file, record, min(CHUNK, count - done))
                    if not len(part):
                        raise MeshError(f"{path.name} ends too early")
                    done += len(part)
                    progress(done / count)
                    yield part["corners"].astype(np.float32)

        return coarse(chunks, count)
    if head.lstrip()[:5].lower() != b"solid" or size > MOST_TEXT_BYTES:
        raise MeshError(f"{path.name} is not an STL file")
    numbers = [
        line.split()[1:4]
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines()
        if line.lstrip().startswith("vertex")
    ]
    corners = np.array(numbers[: len(numbers) // 3 * 3], np.float32).reshape(-1, 3, 3)
    return coarse(lambda: iter([corners]), len(corners))


def read_obj(path: Path, progress: Progress) -> MeshData:
    """The vertices and faces of a Wavefront OBJ file; faces of more corners are cut into fans."""
    import numpy as np

    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    with path.open(encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file):
            if number % CHUNK == 0:
                progress(0.5)
            if line.startswith("v "):
                vertices.append([float(part) for part in line.split()[1:4]])
            elif line.startswith("f "):
                corners = [int(part.partition("/")[0]) for part in line.split()[1:]]
                corners = [corner - 1 if corner > 0 else len(vertices) + corner for corner in corners]
                faces += [(corners[0], b, c) for b, c in pairwise(corners[1:])]
    points, triangles = np.array(vertices, np.float32).reshape(-1, 3), np.array(faces, np.int64).reshape(-1, 3)
    if not len(triangles) or triangles.min() < 0 or triangles.max() >= len(points):
        raise MeshError(f"{path.name} has no faces, or faces without vertices")
    if len(triangles) <= MOST_TRIANGLES:
        return MeshData(points, triangles)
    return coarse(
        lambda: (points[triangles[at : at + CHUNK]] for at in range(0, len(triangles), CHUNK)), len(triangles)
    )


def read_dae(path: Path, progress: Progress) -> MeshData:
    """A COLLADA file."""
    from day6_core.ros.programs.rviz2.model.collada import read_collada

    corners, colours = read_collada(path, progress)
    if len(corners) <= MOST_TRIANGLES:
        return _welded(corners, colours)
    return coarse(lambda: iter([corners]), len(corners))


def _welded(corners: Any, colours: Any = None) -> MeshData:
    import numpy as np

    if not len(corners):
        raise MeshError("a mesh without triangles")
    vertices = np.ascontiguousarray(corners, np.float32).reshape(-1, 3)
    if not np.isfinite(vertices).all():
        raise MeshError("a mesh with numbers that are not finite")
    return MeshData(vertices, np.arange(len(vertices)).reshape(-1, 3), colours)


def coarse(chunks: Callable[[], Iterator[Any]], count: int) -> MeshData:
    """A mesh of corners (chunks of M x 3 x 3), made coarser if it has too many triangles."""
    import numpy as np

    if count <= MOST_TRIANGLES:
        parts = list(chunks())
        return _welded(np.concatenate(parts) if parts else np.zeros((0, 3, 3), np.float32))
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for corners in chunks():
        points = corners.reshape(-1, 3)
        if not np.isfinite(points).all():
            raise MeshError("a mesh with numbers that are not finite")
        low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    side = float((high - low).max()) / CUBES or 1.0
    cubes = CUBES + 1
    found = np.zeros(0, np.int64)
    """Triangles as three numbers of cubes, which have 21 bits each."""
    while True:
        for corners in chunks():
            cell = ((corners - low) / side).astype(np.int64)
            key = (cell[..., 0] * cubes + cell[..., 1]) * cubes + cell[..., 2]
            whole = (key[:, 0] != key[:, 1]) & (key[:, 1] != key[:, 2]) & (key[:, 0] != key[:, 2])
            a, b, c = np.sort(key[whole], axis=1).T
            found = np.unique(np.concatenate([found, a << 42 | b << 21 | c]))
            if len(found) > 8 * MOST_TRIANGLES:
                break
        else:
            if len(found) <= 2 * MOST_TRIANGLES:
                break
        # Still too fine: larger cubes.
        side, cubes, found = side * 2, cubes // 2 + 1, np.zeros(0, np.int64)
    corners = np.stack([found >> 42, found >> 21 & 0x1FFFFF, found & 0x1FFFFF], axis=1)
    keys, faces = np.unique(corners, return_inverse=True)
    place = np.stack([keys // (cubes * cubes), keys // cubes % cubes, keys % cubes], axis=1)
    return MeshData((low + (place + 0.5) * side).astype(np.float32), faces.reshape(-1, 3))
