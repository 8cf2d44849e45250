"""The ROS package angles: differences between angles, also for joints with limits. All angles are in radians."""

from __future__ import annotations

from math import fmod, pi

_TURN = 2.0 * pi


def normalize_angle_positive(angle: float) -> float:
    """Return the angle between 0 and 2 pi."""
    return angle % _TURN


def normalize_angle(angle: float) -> float:
    """Return the angle between -pi and pi."""
    positive = normalize_angle_positive(angle)
    return positive - _TURN if positive > pi else positive


def shortest_angular_distance(from_angle: float, to_angle: float) -> float:
    """Return the difference from one angle to another, between -pi and pi."""
    return normalize_angle(to_angle - from_angle)


def two_pi_complement(angle: float) -> float:
    """Return the same rotation in the other direction, between -2 pi and 2 pi."""
    if abs(angle) > _TURN:
        angle = fmod(angle, _TURN)
    return angle - _TURN if angle > 0 else angle + _TURN


def _find_min_max_delta(from_angle: float, left_limit: float, right_limit: float) -> tuple[bool, float, float]:
    """Return whether an angle lies within limits, and how far it can turn in both directions (angles.h, the same name)."""
    left = shortest_angular_distance(from_angle, left_limit)
    right = shortest_angular_distance(from_angle, right_limit)
    other_left, other_right = two_pi_complement(left), two_pi_complement(right)
    if left == 0:
        return True, left, max(right, other_right)
    if right == 0:
        return True, min(left, other_left), right
    least, least_other = sorted((left, other_left))
    most_other, most = sorted((right, other_right))
    if least <= most_other or most >= least_other:
        everywhere = left_limit == -pi and right_limit == pi
        return everywhere, most_other, least_other
    return True, least, most


def shortest_angular_distance_with_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Return whether a joint with limits between -pi and pi can turn from one angle to another, and by how much."""
    valid, least, most = _find_min_max_delta(from_angle, left_limit, right_limit)
    direct = shortest_angular_distance(from_angle, to_angle)
    other = two_pi_complement(direct)
    shorter = direct if abs(direct) < abs(other) else other
    if not valid:
        return False, _towards(abs(most) - abs(least), direct, other, shorter)
    for each in (direct, other):
        if least <= each <= most:
            return True, each
    _, least, most = _find_min_max_delta(to_angle, left_limit, right_limit)
    return False, _towards(abs(least) - abs(most), direct, other, shorter)


def _towards(side: float, direct: float, other: float, shorter: float) -> float:
    if side == 0:
        return shorter
    return min(direct, other) if side > 0 else max(direct, other)


def shortest_angular_distance_with_large_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Like `shortest_angular_distance_with_limits`, for limits that may exceed pi; the left one must be smaller."""
    shorter, longer = sorted(
        (distance := shortest_angular_distance(from_angle, to_angle), two_pi_complement(distance)), key=abs
    )
    if left_limit <= right_limit:
        for each in (shorter, longer):
            if left_limit <= from_angle + each <= right_limit:
                return left_limit <= from_angle <= right_limit, each
    return False, shorter
