"""The tree of a buffer's frames, and the path from one frame to another at some time."""

from __future__ import annotations

from tf2_py._cache import DEFAULT_CACHE_NS, Cache, CachedTransform, StaticCache, TimeCache
from tf2_py._exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
)
from tf2_py._rotation import IDENTITY, ORIGIN, Quaternion, Vector, add, conjugate, multiply, rotate

MAX_DEPTH = 1000
"""A longer path has run into a loop (tf2/buffer_core.hpp)."""

_ALWAYS = 1 << 63  # later than any time


class FramePath:
    """The transforms from a source frame and from a target frame up to their common ancestor."""

    __slots__ = ("frames_from_source", "frames_from_target", "from_source", "from_target", "is_straight", "time_ns")

    def __init__(self, time_ns: int) -> None:
        self.time_ns = time_ns
        self.is_straight = False
        """One frame is an ancestor of the other, below the root."""
        self.from_source: list[CachedTransform] = []
        self.from_target: list[CachedTransform] = []
        self.frames_from_source: list[str] = []
        self.frames_from_target: list[str] = []

    def transform(self) -> tuple[Quaternion, Vector]:
        """Return the rotation and translation that take coordinates in the source frame to the target frame."""
        rotation, translation = _accumulated(self.from_source)
        if not self.from_target:
            return rotation, translation
        up, offset = _accumulated(self.from_target)
        down = conjugate(up)
        back = rotate(down, (-offset[0], -offset[1], -offset[2]))
        if not self.from_source:
            return down, back
        return multiply(down, rotation), add(rotate(down, translation), back)


def _accumulated(entries: list[CachedTransform]) -> tuple[Quaternion, Vector]:
    rotation, translation = IDENTITY, ORIGIN
    for entry in entries:
        translation = add(rotate(entry.rotation, translation), entry.translation)
        rotation = multiply(entry.rotation, rotation)
    return rotation, translation


class FrameTree:
    """Frames in the order in which they first appeared. It is not thread-safe by itself."""

    def __init__(self, keep_ns: int = DEFAULT_CACHE_NS) -> None:
        self.keep_ns = keep_ns
        self.frames: dict[str, Cache | None] = {}
        """Every frame that ever appeared; None for one that was never a child."""
        self.authorities: dict[str, str] = {}

    def insert(self, child: str, entry: CachedTransform, authority: str, is_static: bool) -> bool:
        """Store a transform; returns False if it is too old. A frame may change from static to moving and back."""
        cache = self.frames.get(child)
        if cache is None or cache.is_static is not is_static:
            self.frames[child] = cache = StaticCache(entry) if is_static else TimeCache(self.keep_ns)
        self.frames.setdefault(entry.parent, None)
        if not cache.insert(entry):
            return False
        self.authorities[child] = authority
        return True

    def clear(self) -> None:
        """Remove the moving transforms; the frames' names stay."""
        for cache in self.frames.values():
            if cache is not None:
                cache.clear()

    def check(self, argument: str, frame: str) -> None:
        """Raise InvalidArgumentException for an impossible name, LookupException for an unknown frame."""
        problem = naming_problem(frame)
        if problem is not None:
            raise InvalidArgumentException(f'Invalid argument "{frame}" passed to {argument} - {problem}')
        if frame not in self.frames:
            raise LookupException(f'"{frame}" passed to {argument} does not exist. ')

    def problem(self, argument: str, frame: str) -> str | None:
        """Return why a frame cannot be looked up, None if it can."""
        problem = naming_problem(frame)
        if problem is None and frame not in self.frames:
            problem = "frame does not exist"
        return None if problem is None else f'Invalid frame ID "{frame}" passed to {argument} - {problem}'

    def path(self, target: str, source: str, time_ns: int) -> FramePath:
        """Return the path between two existing frames; time 0 is the latest common time.

        Raises ExtrapolationException, ConnectivityException, or LookupException for a loop.
        """
        if source == target:
            return FramePath(time_ns)
        if time_ns == 0:
            time_ns = self.latest_common_time(target, source)
        path = FramePath(time_ns)
        frames = self.frames
        failure: ExtrapolationException | None = None
        top = frame = source
        while True:
            path.frames_from_source.append(frame)
            cache = frames[frame]
            if cache is None:
                top = frame
                break
            try:
                entry = cache.at(time_ns)
            except ExtrapolationException as error:
                top = frame
                failure = error
                break
            if frame == target:
                path.is_straight = True
                return path
            path.from_source.append(entry)
            top = frame
            frame = entry.parent
            if len(path.from_source) > MAX_DEPTH:
                raise self._loop()

        frame = target
        while frame != top:
            cache = frames[frame]
            path.frames_from_target.append(frame)
            if cache is None:
                break
            try:
                entry = cache.at(time_ns)
            except ExtrapolationException as error:
                raise ExtrapolationException(_between(str(error), target, source)) from None
            if frame == source:
                path.from_source.clear()
                path.frames_from_source.clear()
                path.is_straight = True
                return path
            path.from_target.append(entry)
            frame = entry.parent
            if len(path.from_target) > MAX_DEPTH:
                raise self._loop()
        if frame != top:
            if failure is not None:
                raise ExtrapolationException(_between(str(failure), target, source))
            raise _unconnected(target, source)
        return path

    def latest_common_time(self, target: str, source: str) -> int:
        """Return the latest time at which all moving frames between two frames are known; 0 if no frame moves.

        Raises ConnectivityException, or LookupException for a loop.
        """
        frames = self.frames
        if source == target:
            cache = frames[source]
            return 0 if cache is None else cache.latest_stamp
        passed: list[tuple[int, str]] = []
        common = _ALWAYS
        frame = source
        while (cache := frames[frame]) is not None and (parent := cache.latest_parent) is not None:
            if cache.latest_stamp:
                common = min(common, cache.latest_stamp)
            passed.append((cache.latest_stamp, parent))
            frame = parent
            if frame == target:
                return 0 if common == _ALWAYS else common
            if len(passed) > MAX_DEPTH:
                raise self._loop()

        above_source = {parent for _, parent in passed}
        common = _ALWAYS
        frame = target
        depth = 0
        while (cache := frames[frame]) is not None and (parent := cache.latest_parent) is not None:
            if cache.latest_stamp:
                common = min(common, cache.latest_stamp)
            if parent in above_source:
                break
            frame = parent
            if frame == source:
                return 0 if common == _ALWAYS else common
            depth += 1
            if depth > MAX_DEPTH:
                raise self._loop()
        else:
            raise _unconnected(target, source)
        for stamp, above in passed:
            if stamp:
                common = min(common, stamp)
            if above == parent:
                break
        return 0 if common == _ALWAYS else common

    def _loop(self) -> LookupException:
        return LookupException(f"The tf tree is invalid because it contains a loop.\n{self.as_string()}\n")

    def as_string(self) -> str:
        """Return a line for each frame that has, or had, a parent."""
        return "".join(
            f"Frame {frame} exists with parent {cache.latest_parent or 'NO_PARENT'}.\n"
            for frame, cache in self.frames.items()
            if cache is not None
        )


def naming_problem(frame: str) -> str | None:
    """Return why a frame can't have this name, None if it can."""
    if not frame:
        return "in tf2 frame_ids cannot be empty"
    if frame.startswith("/"):
        return "in tf2 frame_ids cannot start with a '/'"
    return None


def _between(text: str, target: str, source: str) -> str:
    return f"{text}, when looking up transform from frame [{source}] to frame [{target}]"


def _unconnected(target: str, source: str) -> ConnectivityException:
    return ConnectivityException(
        f"Could not find a connection between '{target}' and '{source}' because they are not part of the same tree."
        "Tf has two or more unconnected trees."
    )
