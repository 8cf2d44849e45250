"""The view controllers: RViz's rules for the mouse, and what a change of view keeps."""

from __future__ import annotations

import math

import pytest

from day6_core.ros.programs.rviz2.model.views import FPS, VIEWS, Orbit, TopDownOrtho, View, XYOrbit, copied


def view(kind: type[View]) -> View:
    return kind(list, lambda: None)


def test_orbit_starts_ten_metres_off_and_45_degrees_above() -> None:
    orbit = view(Orbit)
    assert orbit.camera().position == pytest.approx((5, 5, 10 * math.sin(0.785398)), abs=1e-4)
    assert orbit.camera().forward == pytest.approx((-0.5, -0.5, -(0.5**0.5)), abs=1e-5)
    assert orbit.camera().right[2] == 0 and orbit.camera().up[2] > 0


def test_the_left_button_turns_by_five_thousandths_of_a_radian_a_pixel() -> None:
    orbit = view(Orbit)
    orbit.drag("left", False, 100, 0, 1.5)
    assert orbit.child("Yaw").value == pytest.approx(0.785398 - 0.5)
    orbit.drag("left", False, 0, 40, 1.5)
    assert orbit.child("Pitch").value == pytest.approx(0.785398 + 0.2)
    orbit.drag("left", False, 0, 10_000, 1.5)
    assert orbit.child("Pitch").value == pytest.approx(math.pi / 2 - 0.001)


def test_yaw_stays_between_nothing_and_a_full_turn() -> None:
    orbit = view(Orbit)
    orbit.drag("left", False, 1000, 0, 1.5)
    assert 0 <= orbit.child("Yaw").value < 2 * math.pi


@pytest.mark.parametrize(("button", "shift"), [("middle", False), ("left", True)])
def test_the_middle_button_and_shift_push_the_picture_with_the_hand(button: str, shift: bool) -> None:
    orbit = view(Orbit)
    camera = orbit.camera()
    orbit.drag(button, shift, 600, 0, 1.5)  # as far as the picture is high
    seen = 2 * 10 * math.tan(math.radians(22.5))
    moved = orbit.child("Focal Point").value
    assert moved == pytest.approx(tuple(-seen * part for part in camera.right))


def test_the_wheel_goes_an_eighth_nearer_and_never_through() -> None:
    orbit = view(Orbit)
    orbit.wheel(1, False)
    assert orbit.child("Distance").value == pytest.approx(8.8)
    for _ in range(300):
        orbit.wheel(1, False)
    assert orbit.child("Distance").value == pytest.approx(0.001)


def test_the_right_button_zooms() -> None:
    orbit = view(Orbit)
    orbit.drag("right", False, 0, 10, 1.5)
    assert orbit.child("Distance").value == pytest.approx(11.0)


def test_xyorbit_keeps_its_focal_point_on_the_ground() -> None:
    xy = view(XYOrbit)
    xy.drag("middle", False, 40, 25, 1.5)
    x, y, z = xy.child("Focal Point").value
    assert (x, y) != (0, 0) and z == 0
    assert xy.camera().position[2] > view(Orbit).camera().position[2]


def test_the_view_from_above_is_parallel() -> None:
    top = view(TopDownOrtho)
    assert top.camera().metres == pytest.approx(60) and top.camera().forward == (0, 0, -1)
    top.drag("right", False, 0, -10, 1.5)
    assert top.child("Scale").value == pytest.approx(11)
    top.drag("middle", False, 22, 0, 1.5)
    assert top.child("X").value == pytest.approx(-2)
    top.drag("left", False, 100, 0, 1.5)
    assert top.child("Angle").value == pytest.approx(0.5)


def test_first_person_looks_at_the_origin_and_walks() -> None:
    fps = view(FPS)
    camera = fps.camera()
    length = math.dist((5, 5, 10), (0, 0, 0))
    assert camera.forward == pytest.approx((-5 / length, -5 / length, -10 / length))
    fps.zoom(4)
    assert math.dist(fps.child("Position").value, (0, 0, 0)) < length


def test_zero_brings_the_start_back() -> None:
    for kind in VIEWS.values():
        changed = view(kind)
        start = changed.camera()
        changed.rotate(0.3, 0.1)
        changed.pan(0.2, 0.1)
        changed.zoom(2)
        assert changed.camera() != start
        changed.zero()
        assert changed.camera() == start


def test_45_degrees_from_above() -> None:
    orbit = view(Orbit)
    orbit.rotate(1.0, -2.0)
    orbit.from_above()
    assert orbit.camera().forward[2] == pytest.approx(-math.sin(math.pi / 4), abs=1e-5)


@pytest.mark.parametrize("first", VIEWS.values())
@pytest.mark.parametrize("second", VIEWS.values())
def test_another_view_looks_at_the_same_place(first: type[View], second: type[View]) -> None:
    old, new = view(first), view(second)
    old.look_at((2.0, -1.0, 0.0), 1.0)
    copied(old, new)
    # Where the middle of the new picture meets the ground.
    camera = new.camera()
    if first is not FPS or second is not TopDownOrtho:  # seen from above a first person has no focal point
        if first is FPS or second is FPS or issubclass(first, XYOrbit) or issubclass(second, XYOrbit):
            assert camera.forward[2] < 0
            return
        t = -camera.position[2] / camera.forward[2]
        assert camera.position[0] + t * camera.forward[0] == pytest.approx(2.0, abs=1e-6)
        assert camera.position[1] + t * camera.forward[1] == pytest.approx(-1.0, abs=1e-6)


def test_looking_at_something_shows_it_whole() -> None:
    orbit = view(Orbit)
    orbit.look_at((0, 0, 0), 1.0)
    distance = orbit.child("Distance").value
    assert math.asin(1.0 / distance) < math.radians(22.5)
