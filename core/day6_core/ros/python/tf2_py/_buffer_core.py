"""BufferCore: the buffer behind tf2_ros.Buffer, with the names, arguments and texts of the real binding."""

from __future__ import annotations

import math
import threading
import warnings
from operator import index
from typing import Any

from geometry_msgs.msg import Quaternion as QuaternionMsg
from geometry_msgs.msg import TransformStamped
from geometry_msgs.msg import Vector3 as Vector3Msg

from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.time import Time
from tf2_py import _rotation as rot
from tf2_py._cache import DEFAULT_CACHE_NS, CachedTransform, shown
from tf2_py._exceptions import TransformException
from tf2_py._reports import frames_as_dot, frames_as_yaml
from tf2_py._tree import FrameTree
from tf2_py._velocity import velocity

_TOLERANCE = 10e-3
"""The largest allowed difference of a quaternion's squared length from 1 (tf2/buffer_core.cpp)."""

_logger = RcutilsLogger()  # tf2 logs without a logger name


def _text(value: object, position: int) -> str:
    if not isinstance(value, str):
        raise TypeError(f"argument {position} must be str, not {type(value).__name__}")
    return value


def _nanoseconds(value: Any, kind: str = "time") -> int:
    """Return the nanoseconds of an rclpy Time or Duration, or of their messages. Raises TypeError for anything else."""
    if hasattr(value, "sec") and hasattr(value, "nanosec"):
        return index(value.sec) * 1_000_000_000 + index(value.nanosec)
    if hasattr(value, "nanoseconds"):
        return index(value.nanoseconds)
    raise TypeError(f"{kind} must have sec and nanosec, or nanoseconds.")


def _number(value: float) -> str:
    """Return a number as C's %f prints it."""
    if math.isnan(value):
        return "-nan" if math.copysign(1.0, value) < 0 else "nan"
    return f"{value:f}"


def _numbers(values: tuple[float, ...]) -> str:
    return "(" + " ".join(map(_number, values)) + ")"


class BufferCore:
    """Stores transforms between frames for `cache_time` (default 10 s) and looks up any time in that span.

    Time 0 always means the latest time at which all frames of the path are known. It is thread-safe.
    """

    def __init__(self, cache_time: Any = None) -> None:
        keep = DEFAULT_CACHE_NS if cache_time is None else _nanoseconds(cache_time, "duration")
        self._tree = FrameTree(keep)
        self._tree_lock = threading.RLock()

    # -- storing -------------------------------------------------------------------------------------------------------

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform. An invalid one, or one that is too old, is only logged. Raises TypeError for other objects."""
        self._set(transform, _text(authority, 2), False, "have members x, y, z")

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform that holds at all times; otherwise like `set_transform`."""
        self._set(transform, _text(authority, 2), True, "be of type Vector3")

    def _set(self, stamped: Any, authority: str, is_static: bool, vector_rule: str) -> None:
        header = stamped.header
        child = stamped.child_frame_id
        translation = stamped.transform.translation
        rotation = stamped.transform.rotation
        parent = header.frame_id
        stamp = _nanoseconds(header.stamp)
        if not isinstance(translation, Vector3Msg):
            warnings.warn("translation should be of type Vector3", UserWarning, stacklevel=3)
            raise TypeError(f"transform.translation must {vector_rule}")
        offset = (float(translation.x), float(translation.y), float(translation.z))
        turn = (float(rotation.x), float(rotation.y), float(rotation.z), float(rotation.w))
        if not isinstance(rotation, QuaternionMsg):
            warnings.warn("translation should be of type Quaternion", UserWarning, stacklevel=3)
        parent = parent[1:] if parent.startswith("/") else parent
        child = child[1:] if child.startswith("/") else child
        turn = rot.normalized(turn)
        if not _acceptable(parent, child, offset, turn, authority):
            return
        with self._tree_lock:
            known = self._tree.insert(child, CachedTransform(stamp, turn, offset, parent), authority, is_static)
        if not known:
            _logger.warning(
                f"TF_OLD_DATA ignoring data from the past for frame {child} at time {shown(stamp)} according to"
                f" authority {authority}\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"
            )

    def clear(self) -> None:
        """Remove all transforms that are not static."""
        with self._tree_lock:
            self._tree.clear()

    # -- looking up ----------------------------------------------------------------------------------------------------

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """Return the transform that takes coordinates in the source frame to the target frame.

        Raises LookupException, ConnectivityException, ExtrapolationException or InvalidArgumentException.
        """
        target, source = _text(target_frame, 1), _text(source_frame, 2)
        rotation, translation, stamp = self._lookup(target, source, _nanoseconds(time))
        return _stamped(target, source, stamp, rot.normalized(rotation), translation)

    def _lookup(self, target: str, source: str, time_ns: int) -> tuple[rot.Quaternion, rot.Vector, int]:
        with self._tree_lock:
            tree = self._tree
            if target == source:
                cache = tree.frames.get(target)
                stamp = cache.latest_stamp if time_ns == 0 and cache is not None else time_ns
                return rot.IDENTITY, rot.ORIGIN, stamp
            tree.check("lookupTransform argument target_frame", target)
            tree.check("lookupTransform argument source_frame", source)
            path = tree.path(target, source, time_ns)
        return *path.transform(), path.time_ns

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """Return the transform from the source frame at one time to the target frame at another.

        `fixed_frame` is assumed not to move in between. Raises the same exceptions as `lookup_transform_core`.
        """
        target, target_ns = _text(target_frame, 1), _nanoseconds(target_time)
        source, source_ns = _text(source_frame, 3), _nanoseconds(source_time)
        fixed = _text(fixed_frame, 5)
        with self._tree_lock:
            for name, frame in (("target", target), ("source", source), ("fixed", fixed)):
                self._tree.check(f"lookupTransform argument {name}_frame", frame)
            first, first_offset, _ = self._lookup(fixed, source, source_ns)
            second, second_offset, stamp = self._lookup(target, fixed, target_ns)
        second_matrix = rot.matrix(second)
        turn = rot.quaternion(rot.matrix_product(second_matrix, rot.matrix(first)))
        return _stamped(target, source, stamp, turn, rot.add(rot.apply(second_matrix, first_offset), second_offset))

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """Return (1, "") if `lookup_transform_core` would succeed, else 0 and the reason."""
        target, source, time_ns = _text(target_frame, 1), _text(source_frame, 2), _nanoseconds(time)
        if target == source:
            return 1, ""
        return self._can([("target", target), ("source", source)], [(target, source, time_ns)])

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        """Return (1, "") if `lookup_transform_full_core` would succeed, else 0 and the reason."""
        target, target_ns = _text(target_frame, 1), _nanoseconds(target_time)
        source, source_ns = _text(source_frame, 3), _nanoseconds(source_time)
        fixed = _text(fixed_frame, 5)
        frames = [("target", target), ("source", source), ("fixed", fixed)]
        # The real one looks up the second path in this direction too; it only changes the error's text.
        return self._can(frames, [(target, fixed, target_ns), (fixed, source, source_ns)])

    def _can(self, frames: list[tuple[str, str]], paths: list[tuple[str, str, int]]) -> tuple[int, str]:
        with self._tree_lock:
            for name, frame in frames:
                problem = self._tree.problem(f"canTransform argument {name}_frame", frame)
                if problem is not None:
                    return 0, problem
            try:
                for target, source, time_ns in paths:
                    self._tree.path(target, source, time_ns)
            except TransformException as error:
                return 0, str(error)
        return 1, ""

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Return the latest time for which both frames are known. Raises TransformException."""
        target, source = _text(target_frame, 1), _text(source_frame, 2)
        with self._tree_lock:
            self._tree.check("get_latest_common_time", target)
            self._tree.check("get_latest_common_time", source)
            try:
                return Time(nanoseconds=self._tree.latest_common_time(target, source))
            except TransformException as error:
                raise TransformException(str(error)) from None

    def lookupVelocityCore(
        self, tracking_frame: str, observation_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[rot.Vector, rot.Vector]:
        """Return linear (m/s) and angular (rad/s) velocity of a frame relative to another, averaged over an interval."""
        observation = _text(observation_frame, 2)
        reference = (observation, rot.ORIGIN, _text(tracking_frame, 1))
        with self._tree_lock:
            return velocity(
                self._tree,
                self._lookup,
                tracking_frame,
                observation,
                reference,
                _nanoseconds(time),
                _nanoseconds(averaging_interval, "duration"),
            )

    def lookupVelocityFullCore(
        self,
        tracking_frame: str,
        observation_frame: str,
        reference_frame: str,
        reference_point: rot.Vector,
        reference_point_frame: str,
        time: Any,
        averaging_interval: Any,
    ) -> tuple[rot.Vector, rot.Vector]:
        """Return the velocity in a third frame's coordinates, of any point; see `lookupVelocityCore`."""
        x, y, z = reference_point
        reference = (_text(reference_frame, 3), (float(x), float(y), float(z)), _text(reference_point_frame, 5))
        with self._tree_lock:
            return velocity(
                self._tree,
                self._lookup,
                _text(tracking_frame, 1),
                _text(observation_frame, 2),
                reference,
                _nanoseconds(time),
                _nanoseconds(averaging_interval, "duration"),
            )

    # -- reports -------------------------------------------------------------------------------------------------------

    def all_frames_as_yaml(self) -> str:
        """Return the state of every frame, as YAML."""
        with self._tree_lock:
            return frames_as_yaml(self._tree)

    def all_frames_as_string(self) -> str:
        """Return a line for every frame with its parent."""
        with self._tree_lock:
            return self._tree.as_string()

    def _allFramesAsDot(self, time: Any = None) -> str:
        with self._tree_lock:
            return frames_as_dot(self._tree, 0 if time is None else _nanoseconds(time))

    def _frameExists(self, frame_id_str: str) -> bool:
        frame = _text(frame_id_str, 1)
        with self._tree_lock:
            return frame in self._tree.frames

    def _getFrameStrings(self) -> list[str]:
        with self._tree_lock:
            return list(self._tree.frames)

    def _chain(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> list[str]:
        """Return the frames of the path from the source to the fixed frame and on to the target frame."""
        target_ns, source_ns = _nanoseconds(target_time), _nanoseconds(source_time)
        with self._tree_lock:
            chain = self._frames_between(fixed_frame, source_frame, source_ns)
            if source_ns != target_ns:
                _join(chain, self._frames_between(target_frame, fixed_frame, target_ns), reverse=False)
        return chain

    def _frames_between(self, target: str, source: str, time_ns: int) -> list[str]:
        for frame in (source, target):
            if frame not in self._tree.frames:
                return []
        path = self._tree.path(target, source, time_ns)
        if path.is_straight:
            return path.frames_from_source or path.frames_from_target
        _join(path.frames_from_source, path.frames_from_target, reverse=True)
        return path.frames_from_source


def _join(chain: list[str], other: list[str], reverse: bool) -> None:
    """Append `other` to `chain` without the frames that both end with; like the original it drops one frame too many."""
    m, n = len(other), len(chain)
    while m > 0 and n > 0:
        m -= 1
        n -= 1
        if chain[n] != other[m]:
            break
    if n > 0:
        del chain[n - 1 :]
    if m < len(other):
        tail = other[: m + 1]
        chain += tail[::-1] if reverse else tail


def _acceptable(parent: str, child: str, offset: rot.Vector, turn: rot.Quaternion, authority: str) -> bool:
    """Return whether a transform is valid; log every problem."""
    problems = []
    if child == parent:
        problems.append(
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  child_frame_id'
            f' "{child}" because they are the same'
        )
    if not child:
        problems.append(
            f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id not set '
        )
    if not parent:
        problems.append(
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}"'
            " because frame_id not set"
        )
    if any(map(math.isnan, offset)) or any(map(math.isnan, turn)):
        problems.append(
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority "{authority}" because of a'
            f" nan value in the transform {_numbers(offset)} {_numbers(turn)}"
        )
    if not abs(sum(each * each for each in turn) - 1.0) < _TOLERANCE:
        problems.append(
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority'
            f' "{authority}" because of an invalid quaternion in the transform {_numbers(turn)}'
        )
    for problem in problems:
        _logger.error(problem)
    return not problems


def _stamped(
    target: str, source: str, stamp: int, rotation: rot.Quaternion, translation: rot.Vector
) -> TransformStamped:
    message = TransformStamped()
    message.header.frame_id = target
    message.child_frame_id = source
    time = message.header.stamp
    time.sec, time.nanosec = divmod(stamp, 1_000_000_000)
    offset, turn = message.transform.translation, message.transform.rotation
    offset.x, offset.y, offset.z = translation
    turn.x, turn.y, turn.z, turn.w = rotation
    return message
