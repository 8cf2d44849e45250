"""The newest transforms of /tf and /tf_static, and the pose of one frame in another: as much of tf2 as a picture needs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from day6_urdf.kinematics import IDENTITY, Transform, compose, inverse

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped


class RobotFrames:
    """A tree of frames: for every child frame its parent and its pose in it. Received transforms stay, as in tf2."""

    def __init__(self) -> None:
        self._parents: dict[str, tuple[str, Transform]] = {}

    def update(self, transforms: Iterable[TransformStamped]) -> bool:
        """Store a message's transforms; return True if one of them is new or changed."""
        changed = False
        for stamped in transforms:
            translation, rotation = stamped.transform.translation, stamped.transform.rotation
            # A leading slash is dropped, as in tf2.
            entry = (
                stamped.header.frame_id.lstrip("/"),
                Transform(
                    (translation.x, translation.y, translation.z), (rotation.x, rotation.y, rotation.z, rotation.w)
                ),
            )
            child = stamped.child_frame_id.lstrip("/")
            if child and child != entry[0] and self._parents.get(child) != entry:
                self._parents[child] = entry
                changed = True
        return changed

    def lookup(self, target: str, source: str) -> Transform | None:
        """Return the pose of frame `source` in frame `target`, None when nothing connects them."""
        if target == source:
            return IDENTITY
        up_from_source = self._up(source)
        for frame, from_target in self._up(target).items():
            if frame in up_from_source:
                return compose(inverse(from_target), up_from_source[frame])
        return None

    def _up(self, frame: str) -> dict[str, Transform]:
        """Return the frame and all above it, with the pose of `frame` in each; a loop is followed once."""
        found = {frame: IDENTITY}
        pose = IDENTITY
        while frame in self._parents:
            parent, step = self._parents[frame]
            if parent in found:
                break
            pose = compose(step, pose)
            found[parent] = pose
            frame = parent
        return found
