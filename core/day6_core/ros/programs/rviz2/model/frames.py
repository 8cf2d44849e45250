"""Where frames are in the Fixed Frame, and what RViz says when it does not know (rviz_common/frame_manager.cpp)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from tf2_py import TransformException
from tf2_ros import Buffer

from day6_core.ros.programs.rviz2.model.properties import FIXED_FRAME
from day6_urdf.kinematics import IDENTITY, Transform
from rclpy.duration import Duration
from rclpy.time import Time

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped


class FrameBuffer(Buffer):
    """A tf2 buffer that counts what came in and says so."""

    def __init__(self, cache_time: Duration | None = None) -> None:
        super().__init__(cache_time)
        self.received = 0
        self.on_data: Callable[[], object] | None = None

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        super().set_transform(transform, authority)
        self._count()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        super().set_transform_static(transform, authority)
        self._count()

    def _count(self) -> None:
        self.received += 1
        if self.on_data is not None:
            self.on_data()


class FrameLookups:
    """Answers for one moment: what was looked up is kept until `forget`."""

    def __init__(self, buffer: FrameBuffer) -> None:
        self.buffer = buffer
        self.fixed = ""
        self._known: dict[tuple[str, int], Transform | None] = {}

    def forget(self) -> None:
        """A new moment begins."""
        self._known.clear()

    def pose(self, frame: str, stamp_ns: int = 0) -> Transform | None:
        """The pose of a frame in the Fixed Frame at a time (0: the latest), None if there is none."""
        if frame == FIXED_FRAME:
            return IDENTITY
        frame = frame.removeprefix("/")
        key = (frame, stamp_ns)
        if key not in self._known:
            self._known[key] = self.between(self.fixed.removeprefix("/"), frame, stamp_ns)
        return self._known[key]

    def between(self, target: str, source: str, stamp_ns: int = 0) -> Transform | None:
        """The pose of frame `source` in frame `target`, None if there is none."""
        try:
            rotation, translation, _ = self.buffer._lookup(target, source, stamp_ns)
        except TransformException:
            return None
        return Transform(translation, rotation)

    def names(self) -> list[str]:
        """Every frame heard of, sorted."""
        return sorted(self.buffer._getFrameStrings())

    def parent(self, frame: str) -> str | None:
        """The frame above this one, None at the top."""
        with self.buffer._tree_lock:
            cache = self.buffer._tree.frames.get(frame)
            return None if cache is None else cache.latest_parent

    def latest_ns(self, frame: str) -> int | None:
        """The newest time for which a frame's way to the Fixed Frame is known; None if it is not."""
        try:
            return self.buffer.get_latest_common_time(self.fixed.removeprefix("/"), frame).nanoseconds
        except TransformException:
            return None

    def frame_problem(self, frame: str) -> str | None:
        """What is wrong with a frame by itself."""
        name = frame.removeprefix("/")
        return None if self.buffer._frameExists(name) else f"Frame [{name}] does not exist"

    def transform_problem(self, frame: str, stamp_ns: int = 0) -> str | None:
        """Why there is no transform from a frame to the Fixed Frame (tf_frame_transformer.cpp); None if there is one."""
        source, target = frame.removeprefix("/"), self.fixed.removeprefix("/")
        possible, reason = self.buffer.can_transform_core(target, source, Time(nanoseconds=stamp_ns))
        if possible:
            return None
        if problem := self.frame_problem(target):
            return f"For frame [{source}]: Fixed {problem}"
        if problem := self.frame_problem(source):
            return f"For frame [{source}]: {problem}"
        return f"No transform to fixed frame [{target}]. TF error: [{reason}]"
