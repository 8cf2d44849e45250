"""The car from above: what stands where, and what moves when a wheel turns."""

from __future__ import annotations

import itertools
import math

import pytest

from day6_urdf import parse_robot, shipped_model
from day6_urdf.kinematics import link_transforms
from day6_urdf.model import Robot
from day6_urdf.topview.canvas import Canvas, cell_width
from day6_urdf.topview.plan import find_wheels, plan_top, spin_of
from day6_urdf.topview.view import STYLES, render_top
from tests.support.folded import folded

CAR = parse_robot(shipped_model())
PLAN = plan_top(CAR)
SIZES = [(38, 10), (60, 18), (100, 34), (150, 50)]

AT_60x18 = """\
                     .|=|==##=|=|. left_wheel
                     '|=|==##=|=|'
                          ||
         +----------------||----------------+
         |::::::::::::::: ||               []
         |::::::::::::::: ||               []
         |::::::::::::::: || 0.30 m         |
         |::::::::::::::: ||                |
         |::::base_link:: ||      .-.       |
         |::::::::::::::: ||     (   )      |====>
         |::::::::::::::: ||      '-'       |
         |::::::::::::::: ||                |
         |::::::::::::::: ||               []
         |::::::::::::::: ||               []
         +----------------||----------------+
                          ||
                     .|=|==##=|=|.
 |--------| 0.1 m    '|=|==##=|=|' right_wheel
"""


def picture(robot: Robot, columns: int, rows: int, glyphs: str = "ascii", **positions: float) -> list[str]:
    drawn = render_top(plan_top(robot), link_transforms(robot, positions), columns, rows, glyphs)
    return ["".join(text for text, _ in row) for row in drawn]


def turned(angle: float, columns: int = 60, rows: int = 18) -> list[str]:
    return picture(CAR, columns, rows, left_wheel_joint=angle, right_wheel_joint=angle)


def test_the_shipped_car_at_60_by_18() -> None:
    assert "".join(row.rstrip() + "\n" for row in turned(0.0)) == AT_60x18


def test_a_scale_whose_power_of_ten_was_rounded_up_is_drawn() -> None:
    box = (
        '<robot name="r"><link name="b"><visual><geometry><box size="{} 0.35 0.1"/></geometry></visual></link></robot>'
    )
    for length in range(440, 450):
        assert len(picture(parse_robot(box.format(length / 1000)), 120, 43)) == 43


@pytest.mark.parametrize(("columns", "rows"), [*SIZES, (1, 1), (3, 1), (2, 40), (200, 3), (0, 0), (10, 4)])
@pytest.mark.parametrize("glyphs", ["ascii", "half", "cell", "braille"])
def test_every_row_has_exactly_the_cells_it_was_given(columns: int, rows: int, glyphs: str) -> None:
    drawn = render_top(PLAN, link_transforms(CAR, {"left_wheel_joint": 1.0}), columns, rows, glyphs)
    assert len(drawn) == rows
    assert {sum(cell_width(text) for text, _ in row) for row in drawn} <= {columns}
    assert {style for row in drawn for _, style in row if isinstance(style, str)} <= set(STYLES)


@pytest.mark.parametrize(("columns", "rows"), SIZES)
def test_by_default_everything_is_ascii(columns: int, rows: int) -> None:
    assert "".join(turned(0.7, columns, rows)).isascii()


@pytest.mark.parametrize(("columns", "rows"), SIZES)
def test_both_wheels_show_a_turn_of_a_third_of_a_second_at_one_radian_a_second(columns: int, rows: int) -> None:
    before, after = turned(0.0, columns, rows), turned(0.33, columns, rows)
    changed = [row for row in range(rows) if before[row] != after[row]]
    assert any(row < rows // 2 for row in changed) and any(row > rows // 2 for row in changed)


@pytest.mark.parametrize(("columns", "rows"), SIZES[1:])
def test_at_ten_frames_a_second_most_frames_differ_from_the_one_before(columns: int, rows: int) -> None:
    frames = [turned(step * 0.1, columns, rows) for step in range(63)]
    different = sum(a != b for a, b in itertools.pairwise(frames))
    assert different > 40


def mark_column(rows: list[str]) -> int:
    return next(row.index("#") for row in rows if "#" in row)


def test_turning_forwards_moves_the_painted_mark_forwards_over_the_top() -> None:
    columns = [mark_column(turned(angle)) for angle in (-1.0, -0.5, 0.0, 0.5, 1.0)]
    assert columns == sorted(set(columns))
    assert not any("#" in row for row in turned(math.pi))  # it is below, on the ground


def test_after_a_whole_turn_the_picture_is_the_same() -> None:
    assert turned(0.4) == turned(0.4 + 2 * math.pi)


def test_only_the_wheel_whose_joint_turns_changes() -> None:
    rest, left = turned(0.0), picture(CAR, 60, 18, left_wheel_joint=0.5)
    assert rest[9:] == left[9:] and rest[:9] != left[:9]


def test_a_wheel_without_a_transform_is_drawn_as_missing() -> None:
    transforms = link_transforms(CAR, {})
    del transforms["left_wheel"]
    drawn = render_top(PLAN, transforms, 60, 18)
    assert (".???????????.", "missing") in drawn[0]
    assert not any("?" in text for row in drawn[2:] for text, _ in row)


def test_nothing_but_the_root_known_still_draws_the_car_as_the_urdf_says() -> None:
    rows = ["".join(text for text, _ in row) for row in render_top(PLAN, {}, 60, 18)]
    assert rows[3] == turned(0.0)[3]
    assert "?" * 9 in rows[1] and "?" * 9 in rows[17]


@pytest.mark.parametrize(("columns", "rows"), SIZES[1:])
def test_the_picture_is_to_scale(columns: int, rows: int) -> None:
    drawn = turned(0.0, columns, rows)
    top = next(row for row in drawn if "+-" in row)
    length = top.rindex("+") - top.index("+") + 1
    width = 2 * (sum(row.strip().startswith("|:") for row in drawn) + 2)
    bar, metres = drawn[-1].split()[:2]
    decimetre = (len(bar) - 1) * 0.1 / float(metres)
    assert length / decimetre == pytest.approx(4, rel=0.08)
    assert width / decimetre == pytest.approx(2.5, rel=0.1)


def test_the_axle_says_how_wide_it_is() -> None:
    assert any("0.30 m" in row for row in turned(0.0, 44, 12))


def test_labels_replace_the_link_names_and_chinese_takes_two_cells() -> None:
    labels = {"left_wheel": ("左轮", "57°"), "base_link": ("底盘",)}
    drawn = render_top(PLAN, link_transforms(CAR, {}), 60, 18, "half", labels=labels)
    rows = ["".join(text for text, _ in row) for row in drawn]
    assert "左轮 57°" in rows[0] and any("底盘" in row for row in rows) and "right_wheel" in rows[17]
    assert {cell_width(row) for row in rows} == {60}


def test_angles_come_from_the_transforms_alone() -> None:
    wheel = find_wheels(CAR)[0]
    for angle in (-3.0, -1.0, 0.0, 0.3, 3.1):
        assert spin_of(wheel, link_transforms(CAR, {wheel.joint.name: angle})) == pytest.approx(angle)


def robot(*parts: str) -> Robot:
    return parse_robot(f'<robot name="r"><link name="base"/>{"".join(parts)}</robot>')


def rolling(name: str, shape: str, axis: str, kind: str = "continuous", rpy: str = "0 0 0") -> str:
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    return (
        f'<link name="{name}"><visual><origin rpy="{rpy}"/><geometry>{shape}</geometry></visual></link>'
        f'<joint name="{name}_joint" type="{kind}"><parent link="base"/><child link="{name}"/>'
        f'<axis xyz="{axis}"/>{limit}</joint>'
    )


CYLINDER = '<cylinder radius="0.1" length="0.02"/>'


@pytest.mark.parametrize(
    ("part", "is_wheel"),
    [
        (rolling("w", CYLINDER, "0 1 0", rpy="1.5707963 0 0"), True),
        (rolling("w", CYLINDER, "0 -2 0", rpy="1.5707963 0 0"), True),
        (rolling("w", CYLINDER, "1 0 0", rpy="0 1.5707963 0"), True),
        (rolling("w", CYLINDER, "0 1 0", "revolute", "1.5707963 0 0"), True),
        (rolling("w", '<sphere radius="0.1"/>', "0 1 0"), True),
        (rolling("w", CYLINDER, "0 0 1"), False),  # a turntable
        (rolling("w", CYLINDER, "0 1 0"), False),  # it would tumble
        (rolling("w", '<box size="1 1 1"/>', "0 1 0"), False),
        (rolling("w", CYLINDER, "0 1 0", "prismatic", "1.5707963 0 0"), False),
        (rolling("w", CYLINDER, "0 0 0", rpy="1.5707963 0 0"), False),
    ],
)
def test_a_wheel_is_what_turns_about_a_level_axis_and_is_round(part: str, is_wheel: bool) -> None:
    car = robot(part)
    assert bool(find_wheels(car)) == is_wheel
    assert len(picture(car, 40, 12)) == 12


@folded("columns", range(5, 40))
def test_a_ball_is_never_too_small_to_be_drawn(columns: int) -> None:
    far = (
        '<link name="far"><visual><geometry><box size="9 9 1"/></geometry></visual></link>'
        '<joint name="far" type="fixed"><parent link="base"/><child link="far"/></joint>'
    )
    car = robot(rolling("w", '<sphere radius="0.1"/>', "0 1 0"), far)
    assert any("#" in row for row in picture(car, columns, 7))


def test_a_wheel_mounted_the_other_way_round_rolls_forwards_with_negative_angles() -> None:
    car = robot(rolling("w", CYLINDER, "0 -1 0", rpy="1.5707963 0 0"))
    assert mark_column(picture(car, 60, 18, w_joint=-0.5)) > mark_column(picture(car, 60, 18, w_joint=0.5))


def test_a_robot_of_nothing_but_frames_is_an_empty_sheet_with_an_arrow() -> None:
    rows = picture(robot(), 20, 5)
    assert "".join(rows).replace(" ", "") == "==>"


def test_a_chinese_character_that_is_half_overwritten_leaves_a_blank() -> None:
    canvas = Canvas(6, 1)
    canvas.text(0, 0, "左轮x", "label")
    canvas.put(1, 0, "|", "")
    canvas.put(2, 0, "|", "")
    canvas.text(5, 0, "轮", "")
    assert "".join(text for text, _ in canvas.rows()[0]) == " || x "


def test_angle_and_speed_stand_beside_the_wheel_as_far_as_they_fit() -> None:
    labels = {
        "left_wheel": ("left_wheel", "57 deg", "+1.00 rad/s"),
        "right_wheel": ("right_wheel", "172 deg", "-12.00 rad/s"),
    }
    for columns, left, right in (
        (78, "(=##=) left_wheel 57 deg +1.00 rad/s", "(=##=) right_wheel 172 deg -12.00 rad/s"),
        (38, "57 deg (=##=) +1.00 rad/s", "172 deg (=##=) -12.00 rad/s"),
        (24, "(=##=) 57 deg", "(=##=) 172 deg"),
    ):
        drawn = render_top(PLAN, link_transforms(CAR, {}), columns, 10, "ascii", labels=labels)
        rows = [" ".join("".join(text for text, _ in row).replace("|", "=").split()) for row in drawn]
        assert (rows[0], rows[9].split(" m ")[-1]) == (left, right)


def test_a_ball_on_a_joint_with_limits_is_an_elbow_and_no_wheel() -> None:
    ball = '<sphere radius="0.1"/>'
    assert len(find_wheels(robot(rolling("w", ball, "0 1 0")))) == 1
    assert find_wheels(robot(rolling("w", ball, "0 1 0", "revolute"))) == []
