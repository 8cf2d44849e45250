"""The transforms of a robot: fixed ones and those that follow a joint, as in KDL's tree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from day6_urdf.kinematics import canonical, is_moving, joint_transform
from day6_urdf.model import Joint, Quaternion, Robot, Vector


class FrameTransform(NamedTuple):
    """One transform for /tf, before it has a stamp and a prefix."""

    parent: str
    child: str
    translation: Vector
    rotation: Quaternion


class Segments:
    """The joints of a robot, sorted by name as in the original's maps."""

    def __init__(self, robot: Robot) -> None:
        joints = sorted(robot.tree(), key=lambda joint: joint.name)
        self._moving = {joint.name: joint for joint in joints if is_moving(joint)}
        # A planar joint is published as if it were fixed, a floating one not at all.
        self._fixed = [joint for joint in joints if not is_moving(joint) and joint.type != "floating"]
        self._mimics = [joint for joint in sorted(robot.joints, key=lambda joint: joint.name) if joint.mimic]

    def fixed(self) -> list[FrameTransform]:
        return [_transform(joint, 0.0) for joint in self._fixed]

    def moving(self, names: Sequence[str], positions: Sequence[float]) -> list[FrameTransform]:
        """Return the transforms of the joints that are named; unknown names are ignored.

        Of a joint named twice the first counts. Mimicking joints follow the one they mimic if that is named, each once
        and in the order of their names, so that a mimic of a mimic follows only where its turn comes later.
        """
        known: dict[str, float] = {}
        for name, position in zip(names, positions, strict=True):
            known.setdefault(name, position)
        self._follow(known)
        return [_transform(self._moving[name], known[name]) for name in sorted(known) if name in self._moving]

    def _follow(self, known: dict[str, float]) -> None:
        for joint in self._mimics:
            mimic = joint.mimic
            if mimic is not None and mimic.joint in known:
                known.setdefault(joint.name, known[mimic.joint] * mimic.multiplier + mimic.offset)


class Throttle:
    """Lets a joint through at most `publish_frequency` times a second, by the stamps of the messages (nanoseconds)."""

    def __init__(self) -> None:
        self._published: dict[str, int] = {}
        self._last_call_ns = 0

    def went_back(self, now_ns: int) -> bool:
        """Note a call; True when time ran backwards since the last one: then every joint may be published again."""
        back = self._last_call_ns > now_ns
        if back:
            self._published.clear()
        self._last_call_ns = now_ns
        return back

    def admits(self, names: Sequence[str], stamp_ns: int, now_ns: int, frequency: float) -> bool:
        """Say whether a message with this stamp is due. The joint that waits longest decides; a new one waits from 0.

        So a message without a stamp never is due (see `ignore_timestamp`). A frequency of 0 holds nothing back.
        """
        oldest = min([now_ns, *(self._published.get(name, 0) for name in names)])
        # Whole milliseconds, as in the original.
        interval_ns = int(1000.0 / frequency) * 1_000_000 if frequency > 0 else 0
        return stamp_ns >= oldest + interval_ns

    def note(self, names: Sequence[str], stamp_ns: int) -> None:
        for name in names:
            self._published[name] = stamp_ns


class StaticFrames:
    """All static transforms sent so far, the newest of every child frame: tf2_ros sends them all every time."""

    def __init__(self) -> None:
        self._sent: dict[str, object] = {}

    def merged(self, transforms: Mapping[str, object]) -> list[object]:
        """Take in transforms by child frame and return everything that has to be sent."""
        self._sent.update(transforms)
        return list(self._sent.values())


def _transform(joint: Joint, position: float) -> FrameTransform:
    pose = joint_transform(joint, position)
    return FrameTransform(joint.parent, joint.child, pose.xyz, canonical(pose.rotation))
