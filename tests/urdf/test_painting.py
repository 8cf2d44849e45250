"""The car in coloured dots: what is where, what moves, and what it is that one sees of a wheel's speed."""

from __future__ import annotations

import itertools
import math
from collections import Counter

import pytest

from day6_urdf import parse_robot, shipped_model
from day6_urdf.kinematics import link_transforms
from day6_urdf.model import Robot
from day6_urdf.topview.blocks import DOTS, Blocks, Lines
from day6_urdf.topview.frame import TopFrame
from day6_urdf.topview.paint import DARK, LIGHT, TopColours, Turning, paint_top
from day6_urdf.topview.plan import TopPlan, plan_top
from day6_urdf.topview.view import render_top

CAR = plan_top(parse_robot(shipped_model()))
SIZES = [(38, 12), (58, 11), (78, 11), (60, 18), (118, 36), (200, 60)]
BLUE = 0x334CE6
DISTANCE = 60


def dots(
    plan: TopPlan = CAR,
    size: tuple[int, int] = (60, 18),
    glyphs: str = "half",
    angle: float = 0.3,
    speed: float = 0.0,
    colours: TopColours = DARK,
) -> list[list[int]]:
    """The colours of all dots."""
    turned = {joint.name: angle for joint in plan.robot.joints if joint.type == "continuous"}
    frame = TopFrame(plan, *size, DOTS[glyphs])
    painted = (Lines if glyphs == "braille" else Blocks)(frame, colours.background)
    speeds = {wheel.joint.child: speed for wheel in plan.wheels}
    paint_top(painted, frame, link_transforms(plan.robot, turned), colours, Turning(speeds))
    return painted.lines


def places(lines: list[list[int]], colour: int) -> set[tuple[int, int]]:
    return {(x, y) for y, line in enumerate(lines) for x, found in enumerate(line) if found == colour}


def outline(lines: list[list[int]], background: int = DARK.background) -> list[list[bool]]:
    return [[colour != background for colour in line] for line in lines]


@pytest.mark.parametrize("size", SIZES)
def test_the_body_is_filled_with_the_colour_of_the_urdf_and_has_a_lighter_edge(size: tuple[int, int]) -> None:
    counts = Counter(colour for line in dots(size=size) for colour in line)
    assert counts.most_common(2)[1][0] == BLUE or counts.most_common(1)[0][0] == BLUE
    light = [c for c in counts if c & 0xFF > 0xE6 and (c >> 16) > 0x60 and c != 0xFFFFFF]
    assert light, "the edge"


@pytest.mark.parametrize("size", SIZES)
def test_wheels_are_three_dots_thick_at_least_and_alike_on_both_sides(size: tuple[int, int]) -> None:
    lines = dots(size=size)
    marks = places(lines, DARK.mark)
    upper, lower = ({y for _, y in marks if (y < size[1]) == up} for up in (True, False))
    wheel = [y for y, line in enumerate(lines) if line[min(x for x, _ in marks)] != DARK.background]
    assert len(upper) == len(lower) and len(upper) >= 3 - 2 * (len(upper) > 2)
    assert wheel == [2 * size[1] - 1 - y for y in reversed(wheel)], "the picture is symmetric"
    thick = next(n for n, (a, b) in enumerate(itertools.pairwise(wheel), 1) if b > a + 1 or n == len(wheel) - 1)
    assert thick >= 3


@pytest.mark.parametrize("glyphs", ["half", "cell", "braille"])
@pytest.mark.parametrize("size", SIZES)
def test_what_turns_changes_inside_the_tyre_alone(glyphs: str, size: tuple[int, int]) -> None:
    first = dots(size=size, glyphs=glyphs, angle=0.0)
    seen = [dots(size=size, glyphs=glyphs, angle=0.1 * step) for step in range(1, 60)]
    if glyphs != "braille":
        assert all(outline(other) == outline(first) for other in seen), "an outline flickers"
    changed = {
        (x, y)
        for other in seen
        for y, (new, old) in enumerate(zip(other, first, strict=True))
        for x, (a, b) in enumerate(zip(new, old, strict=True))
        if a != b
    }
    body = places(dots(size=size, glyphs="half" if glyphs == "half" else glyphs), BLUE)
    assert changed and not changed & body


def test_the_mark_goes_forwards_over_the_top_and_is_gone_for_half_a_turn() -> None:
    columns = [min(x for x, _ in places(dots(angle=angle), DARK.mark)) for angle in (-1.2, -0.6, 0.0, 0.6, 1.2)]
    assert columns == sorted(set(columns))
    assert not places(dots(angle=math.pi), DARK.mark)


def tail_of(speed: float, angle: float = 0.3) -> set[int]:
    """The columns of the tail: it has something of the mark's colour, and isn't there when the wheels stand."""
    known = {colour for line in dots(angle=angle) for colour in line}
    lines = dots(angle=angle, speed=speed)
    return {x for line in lines for x, c in enumerate(line) if c not in known and (c >> 16) > (c & 255) + 60}


def test_a_still_picture_shows_which_way_a_wheel_turns_and_how_fast() -> None:
    mark = {x for x, _ in places(dots(), DARK.mark)}
    assert not tail_of(0.0)
    slow, fast, back = tail_of(4.0), tail_of(12.0), tail_of(-4.0)
    assert max(slow) < min(mark) and min(back) > max(mark)
    assert len(fast) > len(slow) > 0


def test_a_fast_tread_is_blurred_and_its_mark_is_not() -> None:
    def treads(speed: float) -> int:
        return len(places(dots(speed=speed), 0x8A919C))

    assert treads(1.0) and not treads(20.0)
    assert places(dots(speed=20.0), DARK.mark)
    # Seen twenty times a second the mark goes on in small steps forwards, never backwards.
    angles = [step * 20.0 * 0.05 for step in range(7)]
    columns = [[x for x, _ in places(dots(angle=a, speed=20.0), DARK.mark)] for a in angles]
    assert [bool(found) for found in columns] == [abs(math.remainder(a, 2 * math.pi)) < math.pi / 2 for a in angles]


@pytest.mark.parametrize("colours", [DARK, LIGHT])
def test_black_and_white_robots_are_seen_on_any_ground(colours: TopColours) -> None:
    for shade in ("0 0 0", "1 1 1", "0.05 0.05 0.1"):
        box = f'<geometry><box size="0.4 0.3 0.1"/></geometry><material name="m"><color rgba="{shade} 1"/></material>'
        plan = plan_top(parse_robot(f'<robot name="r"><link name="a"><visual>{box}</visual></link></robot>'))
        fill = Counter(c for line in dots(plan, colours=colours) for c in line if c != colours.background).most_common(
            1
        )
        apart = sum(abs((fill[0][0] >> s & 255) - (colours.background >> s & 255)) for s in (0, 8, 16))
        assert apart > DISTANCE


def test_a_link_without_a_transform_has_the_colour_of_what_is_missing() -> None:
    frame = TopFrame(CAR, 60, 18, (1, 2))
    painted = Blocks(frame, DARK.background)
    paint_top(painted, frame, {}, DARK, Turning())
    assert places(painted.lines, DARK.missing) and not places(painted.lines, DARK.mark)


# -- other robots ------------------------------------------------------------------------------------------------------


def chain(count: int) -> Robot:
    links = "".join(
        f'<link name="l{n}"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>'
        for n in range(count)
    )
    joints = "".join(
        f'<joint name="j{n}" type="revolute"><parent link="l{n}"/><child link="l{n + 1}"/><origin xyz="0.1 0 0"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        for n in range(count - 1)
    )
    return parse_robot(f'<robot name="r">{links}{joints}</robot>')


def one(geometry: str) -> Robot:
    return parse_robot(
        f'<robot name="r"><link name="a"><visual><geometry>{geometry}</geometry></visual></link></robot>'
    )


ODD = {
    "one link": one('<box size="1 1 1"/>'),
    "nothing": parse_robot('<robot name="r"><link name="a"/></robot>'),
    "zero-sized": one('<box size="0 0 0"/>'),
    "tiny": one('<sphere radius="0.000001"/>'),
    "huge": one('<box size="1000000 2 1"/>'),
    "a mesh that is missing": one('<mesh filename="package://nowhere/a.stl"/>'),
    "500 links": chain(500),
}


@pytest.mark.parametrize("glyphs", ["ascii", "half", "cell", "braille"])
@pytest.mark.parametrize("size", [(20, 5), (1, 1), (78, 11), (200, 60)])
def test_any_robot_fills_any_pane(glyphs: str, size: tuple[int, int]) -> None:
    for name, robot in ODD.items():
        plan = plan_top(robot)
        for zoom in (0.2, 1.0, 20.0):
            rows = render_top(plan, link_transforms(robot, {}), *size, glyphs, zoom=zoom)
            assert [sum(len(text) for text, _ in row) for row in rows] == [size[0]] * size[1], name


def test_a_mesh_is_drawn_by_the_outermost_of_its_corners() -> None:
    robot = one('<mesh filename="a.stl" scale="2 1 1"/>')
    plan = plan_top(robot, lambda name: [(0.1, 0.2, 0.0), (-0.1, 0.2, 0.0), (0.0, -0.2, 0.3)])
    assert plan.bounds == pytest.approx((-0.2, -0.2, 0.2, 0.2))
    assert plan.bodies[0].style == "chassis"


def test_an_arm_stays_in_the_picture_wherever_its_joints_go() -> None:
    robot = chain(3)
    plan = plan_top(robot)
    for angle in (-1.0, 1.0):
        frame = TopFrame(plan, 60, 18, (1, 2))
        painted = Blocks(frame, DARK.background)
        paint_top(painted, frame, link_transforms(robot, {"j0": angle}), DARK, Turning())
        assert not any(painted.lines[0]) or set(painted.lines[0]) == {DARK.background}
        assert set(painted.lines[-1]) == {DARK.background}
