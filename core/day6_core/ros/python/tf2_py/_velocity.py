"""The velocity of one frame relative to another: the difference of two lookups, as tf2 computes it."""

from __future__ import annotations

import math
from collections.abc import Callable

from tf2_py import _rotation as rot
from tf2_py._cache import seconds
from tf2_py._exceptions import TransformException
from tf2_py._tree import FrameTree

Lookup = Callable[[str, str, int], tuple[rot.Quaternion, rot.Vector, int]]


def velocity(
    tree: FrameTree,
    lookup: Lookup,
    tracking: str,
    observation: str,
    reference: tuple[str, rot.Vector, str],
    time_ns: int,
    interval_ns: int,
) -> tuple[rot.Vector, rot.Vector]:
    """Return linear (m/s) and angular (rad/s) velocity of the frame `tracking` relative to `observation`.

    `reference` is the frame of the result's coordinates, then the point (metres) whose velocity is meant, and that point's
    frame. The average is over `interval_ns` around `time_ns`, shifted back at the end of the data.
    """
    try:
        latest = seconds(tree.latest_common_time(observation, tracking))
    except (KeyError, TransformException):
        latest = 0.0
    now, interval = seconds(time_ns), interval_ns * 1e-9
    end = min(now + interval * 0.5, latest)
    start = max(0.00001 + interval, end) - interval
    span = end - start

    first_turn, first_offset, _ = lookup(observation, tracking, _to_ns(start))
    last_turn, last_offset, _ = lookup(observation, tracking, _to_ns(end))
    first = rot.matrix(first_turn)
    change = rot.quaternion(rot.matrix_product(rot.transpose(first), rot.matrix(last_turn)))
    angle = 2.0 * math.acos(min(max(change[3], -1.0), 1.0))
    moved = (last_offset[0] - first_offset[0], last_offset[1] - first_offset[1], last_offset[2] - first_offset[2])
    linear = (moved[0] / span, moved[1] / span, moved[2] / span)
    angular = _scaled(rot.apply(first, _axis(change)), angle / span)

    frame, point, point_frame = reference
    turn, offset, _ = lookup(frame, tracking, time_ns)
    turned = rot.matrix(turn)
    out_angular = rot.apply(turned, angular)
    out_linear = rot.add(rot.apply(turned, linear), rot.cross(offset, out_angular))
    # The real one adds angular · delta elementwise, where a cross product would be right; so does this one.
    point_turn, point_offset, _ = lookup(frame, point_frame, time_ns)
    wanted = rot.add(rot.apply(rot.matrix(point_turn), point), point_offset)
    delta = (wanted[0] - offset[0], wanted[1] - offset[1], wanted[2] - offset[2])
    out_linear = rot.add(out_linear, (out_angular[0] * delta[0], out_angular[1] * delta[1], out_angular[2] * delta[2]))
    return out_linear, out_angular


def _to_ns(time: float) -> int:
    whole = math.floor(time)
    return int(whole) * 1_000_000_000 + round((time - whole) * 1e9)


def _scaled(vector: rot.Vector, factor: float) -> rot.Vector:
    return (vector[0] * factor, vector[1] * factor, vector[2] * factor)


def _axis(turn: rot.Quaternion) -> rot.Vector:
    square = 1.0 - turn[3] * turn[3]
    if square < 10.0 * 2.220446049250313e-16:
        return (1.0, 0.0, 0.0)
    length = math.sqrt(square)
    return (turn[0] / length, turn[1] / length, turn[2] / length)
