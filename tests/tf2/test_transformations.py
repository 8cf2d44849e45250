"""tf_transformations: known values, and what must hold for all numbers."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import tf_transformations as t
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.tf2.conftest import matrix_of

ANGLE = st.floats(-3.1, 3.1)
AXES = sorted(t._AXES2TUPLE)


def axis_turn(axis: str, angle: float) -> np.ndarray:
    half = angle / 2
    turn = [math.sin(half) if axis == each else 0.0 for each in "xyz"]
    return matrix_of((0, 0, 0), (*turn, math.cos(half)))


@given(angles=st.tuples(ANGLE, ANGLE, ANGLE), axes=st.sampled_from(AXES))
@settings(max_examples=200, deadline=None)
def test_euler_angles_are_three_turns_one_after_the_other(angles: tuple[float, float, float], axes: str) -> None:
    turns = [axis_turn(axis, angle) for axis, angle in zip(axes[1:], angles, strict=True)]
    expected = turns[2] @ turns[1] @ turns[0] if axes[0] == "s" else turns[0] @ turns[1] @ turns[2]
    assert np.allclose(t.euler_matrix(*angles, axes=axes), expected)
    quaternion = t.quaternion_from_euler(*angles, axes=axes)
    assert np.allclose(t.quaternion_matrix(quaternion), expected)
    back = t.euler_from_quaternion(quaternion, axes)
    assert np.allclose(t.euler_matrix(*back, axes=axes), expected, atol=1e-6)
    assert np.allclose(t.euler_matrix(*t.euler_from_matrix(expected, axes), axes=axes), expected, atol=1e-6)
    assert t._TUPLE2AXES[t._AXES2TUPLE[axes]] == axes


def test_known_values() -> None:
    assert t.quaternion_from_euler(0, 0, math.pi / 2) == pytest.approx((0, 0, math.sqrt(0.5), math.sqrt(0.5)))
    assert t.quaternion_from_euler(0, 0, 0) == (0.0, 0.0, 0.0, 1.0)
    assert repr(t.euler_from_quaternion([0, 0, 0, 1])) == "(0.0, -0.0, 0.0)"  # the sign is the real package's
    assert t.euler_from_quaternion([0.06146124, 0, 0, 0.99810947]) == pytest.approx((0.123, 0, 0))
    assert t.quaternion_multiply([1, -2, 3, 4], [-5, 6, 7, 8]) == (-44, -14, 48, 28)
    assert t.quaternion_about_axis(0.123, (1, 0, 0)) == pytest.approx((0.06146124, 0, 0, 0.99810947))
    assert t.quaternion_from_euler(1, 2, 3, "ryxz") == pytest.approx(
        (0.310622, -0.718287, 0.444435, 0.435953), abs=1e-6
    )
    with pytest.raises(KeyError):
        t.quaternion_from_euler(0, 0, 0, "sxxx")


def test_plain_functions_return_tuples_and_matrix_functions_arrays() -> None:
    for value in (
        t.quaternion_from_euler(1, 2, 3),
        t.euler_from_quaternion((0, 0, 0, 1)),
        t.quaternion_about_axis(1, (0, 0, 1)),
    ):
        assert type(value) is tuple and all(type(each) is float for each in value)
    for array in (t.quaternion_inverse((0, 0, 1, 1)), t.quaternion_conjugate((0, 0, 1, 1)), t.euler_matrix(1, 2, 3)):
        assert type(array) is np.ndarray
    assert t.ROTATION_IDENTITY.shape == (3, 3)


def unit(chance: random.Random, size: int = 4) -> list[float]:
    parts = [chance.gauss(0, 1) for _ in range(size)]
    return [part / math.sqrt(sum(each * each for each in parts)) for part in parts]


@pytest.mark.parametrize("seed", range(10))
def test_quaternions_agree_with_their_matrices(seed: int) -> None:
    chance = random.Random(seed)
    p, q = unit(chance), unit(chance)
    assert np.allclose(t.quaternion_matrix(q), matrix_of((0, 0, 0), q))
    assert np.allclose(
        t.quaternion_matrix(t.quaternion_multiply(p, q)), t.quaternion_matrix(p) @ t.quaternion_matrix(q)
    )
    assert np.allclose(t.quaternion_multiply(q, t.quaternion_inverse(q)), (0, 0, 0, 1))
    sign = math.copysign(1, q[3])
    assert np.allclose(t.quaternion_from_matrix(t.quaternion_matrix(q)), sign * np.array(q))
    half = t.quaternion_slerp(p, q, 0.5)
    assert np.allclose(abs(np.dot(half, p)), abs(np.dot(half, q)))
    assert np.allclose(t.quaternion_slerp(p, q, 0.0), p) and np.allclose(t.quaternion_slerp(p, q, 1.0), q)
    assert t.vector_norm(t.random_quaternion()) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", range(10))
def test_matrices_can_be_taken_apart_and_put_together(seed: int) -> None:
    chance = random.Random(seed)
    angle, axis, point = chance.uniform(-2, 2), unit(chance, 3), [chance.uniform(-2, 2) for _ in range(3)]
    turn = t.rotation_matrix(angle, axis, point)
    assert t.is_same_transform(turn, t.rotation_matrix(*t.rotation_from_matrix(turn)))
    assert np.allclose(turn @ [*point, 1], [*point, 1])
    mirror = t.reflection_matrix(point, axis)
    assert t.is_same_transform(mirror, t.reflection_matrix(*t.reflection_from_matrix(mirror)))
    assert np.allclose(mirror @ mirror, np.eye(4))
    scale = t.scale_matrix(1.7, point, axis)
    assert t.is_same_transform(scale, t.scale_matrix(*t.scale_from_matrix(scale)))
    across = np.cross(axis, unit(chance, 3))
    shear = t.shear_matrix(0.5, across, point, axis)
    assert t.is_same_transform(shear, t.shear_matrix(*t.shear_from_matrix(shear)))
    flat = t.projection_matrix(point, axis)
    assert np.allclose(flat @ flat, flat)
    assert t.is_same_transform(flat, t.projection_matrix(*t.projection_from_matrix(flat)))
    both = t.compose_matrix([1, 2, 3], [0.1, 0.2, 0.3], [0.4, 0.5, 0.6], point)
    assert t.is_same_transform(both, t.compose_matrix(*t.decompose_matrix(both)))
    assert np.allclose(t.concatenate_matrices(both, t.inverse_matrix(both)), np.eye(4))


@pytest.mark.parametrize("usesvd", [True, False])
def test_superimposition_finds_the_movement_of_a_cloud(usesvd: bool) -> None:
    chance = random.Random(2)
    cloud = np.array([[chance.uniform(-1, 1) for _ in range(8)] for _ in range(3)])
    matrix = matrix_of((1, 2, 3), unit(chance))
    moved = 2.5 * matrix[:3, :3] @ cloud + matrix[:3, 3:]
    found = t.superimposition_matrix(cloud, moved, scaling=True, usesvd=usesvd)
    assert np.allclose(found[:3, :3] @ cloud + found[:3, 3:], moved)


def test_a_ball_dragged_to_the_right_turns_about_the_vertical() -> None:
    ball = t.Arcball()
    ball.place([100, 100], 100)
    ball.down([100, 100])
    ball.drag([150, 100])
    angle, axis, _ = t.rotation_from_matrix(ball.matrix())
    assert np.allclose(np.array(axis) * math.copysign(1, angle), (0, 1, 0))
    assert abs(angle) == pytest.approx(2 * math.asin(0.5))
