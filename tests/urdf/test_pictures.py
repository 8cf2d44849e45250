"""Robots from above, compared with the pictures in pictures.txt: shapes, slanted wheels, zoom, labels, every kind of line.

After a change made on purpose: `python -m tests.urdf.test_pictures`, then look at the difference.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from day6_urdf import parse_robot, shipped_model
from day6_urdf.kinematics import link_transforms
from day6_urdf.model import Robot
from day6_urdf.topview.canvas import Canvas, cell_width
from day6_urdf.topview.paint import Turning, bars_of, tail, tread_marks
from day6_urdf.topview.plan import find_wheels, hull, plan_top, spin_of, stand, steering_of
from day6_urdf.topview.view import render_top
from tests.support.folded import folded

WRITTEN = Path(__file__).with_name("pictures.txt")


def visual(shape: str, xyz: str = "0 0 0", rpy: str = "0 0 0") -> str:
    return f'<visual><origin xyz="{xyz}" rpy="{rpy}"/><geometry>{shape}</geometry></visual>'


def part(name: str, shapes: str, xyz: str, rpy: str = "0 0 0", kind: str = "fixed", axis: str = "0 1 0") -> str:
    return (
        f'<link name="{name}">{shapes}</link><joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}"/><origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/></joint>'
    )


def robot(base: str, *parts: str) -> Robot:
    return parse_robot(f'<robot name="r"><link name="base">{base}</link>{"".join(parts)}</robot>')


def wheel(
    name: str, xyz: str, rpy: str = "0 0 0", radius: float = 0.1, width: float = 0.04, axis: str = "0 1 0"
) -> str:
    shape = visual(f'<cylinder radius="{radius}" length="{width}"/>', rpy="1.5707963 0 0")
    return part(name, shape, xyz, rpy, "continuous", axis)


BOX = visual('<box size="0.5 0.3 0.1"/>')
LOW_BOX = '<box size="0.2 0.1 0.1"/>'
ROBOTS = {
    "car": parse_robot(shipped_model()),
    "round": robot(
        visual('<cylinder radius="0.2" length="0.1"/>'),
        wheel("left", "0 0.22 0"),
        wheel("right", "0 -0.22 0"),
        part("ball", visual('<sphere radius="0.05"/>'), "-0.12 0 0"),
        part("tiny", visual('<sphere radius="0.008"/>'), "0.12 0.05 0"),
    ),
    "slanted": robot(
        visual('<box size="0.5 0.3 0.1"/>', rpy="0 0 0.5"),
        wheel("a", "0.2 0.2 0", "0 0 0.7854"),
        wheel("b", "0.2 -0.2 0", "0 0 -0.3"),
        wheel("c", "-0.2 -0.2 0", "0 0 1.5708"),
        wheel("d", "-0.2 0.2 0", "0 0 3.1416", 0.06, 0.1),
        part("bar", visual(LOW_BOX, rpy="0 0 1.2"), "0.35 0 0"),
    ),
    "train": robot(
        BOX,
        *(
            wheel(f"{side}{number}", f"{x} {y} 0")
            for number, x in enumerate((-0.2, 0.0, 0.2))
            for side, y in (("l", 0.2), ("r", -0.2))
        ),
        part("arm", visual(LOW_BOX, "0.1 0 0"), "0.3 0.05 0"),
        part("mast", visual('<cylinder radius="0.03" length="0.4"/>', rpy="0 1.5707963 0"), "-0.1 0 0.3", "0 0 0.4"),
        part("eye", visual('<mesh filename="a.stl"/>'), "-0.2 0.08 0"),
    ),
    "balls": robot(
        visual('<box size="0.1 0.6 0.1"/>'),
        part("left", visual('<sphere radius="0.1"/>'), "0 0.3 0", kind="continuous"),
        part("right", visual('<sphere radius="0.07"/>'), "0 -0.3 0", kind="continuous"),
    ),
    "axles": robot(
        visual('<box size="1.2 0.5 0.1"/>'),
        # Two that roll crosswise, against each other, a little apart, too far apart, and one that hangs on another part.
        *(wheel(f"cross{y}", f"-0.5 {y} 0", turn) for y, turn in ((0.3, "0 0 1.5708"), (-0.3, "0 0 0"))),
        *(wheel(f"against{y}", f"-0.2 {y} 0", axis=axis) for y, axis in ((0.3, "0 1 0"), (-0.3, "0 -1 0"))),
        *(wheel(f"near{y}", f"{x} {y} 0") for x, y in ((0.1, 0.3), (0.128, -0.3))),
        *(wheel(f"wide{y}", f"{x} {y} 0") for x, y in ((0.3, 0.3), (0.334, -0.3))),
        wheel("own", "0.55 0.3 0"),
        part("arm", visual(LOW_BOX), "0.55 0 0"),
        wheel("other", "0 -0.3 0").replace('parent link="base"', 'parent link="arm"'),
    ),
    "close": robot(
        visual('<box size="1 0.6 0.1"/>'),
        *(
            wheel(f"{number}{side}", f"{0.3 * number - 0.45} {side * (0.05 + 0.03 * number)} 0", width=0.01)
            for number in range(4)
            for side in (1, -1)
        ),
    ),
    "far": robot(visual('<box size="30 4 1"/>', "8 1 0"), wheel("w", "0 5 0", radius=1.5, width=0.8)),
}
CASES: dict[str, dict[str, Any]] = {
    "car 38x10": {"robot": "car", "size": (38, 10)},
    "car half 60x18": {"robot": "car", "size": (60, 18), "glyphs": "half"},
    "car turned": {"robot": "car", "size": (60, 18), "turned": {"left_wheel_joint": 0.4, "right_wheel_joint": -2.5}},
    "car zoomed and shifted": {"robot": "car", "size": (60, 18), "zoom": 2.0, "shift": (-12, 3)},
    "car from afar": {"robot": "car", "size": (60, 18), "zoom": 0.3},
    "car with labels": {
        "robot": "car",
        "size": (70, 20),
        "labels": {
            "left_wheel": "左轮 57°",
            "base_link": "车",
            "right_wheel": "a very long label of a wheel, longer than it",
        },
    },
    "car with readings": {
        "robot": "car",
        "size": (44, 12),
        "labels": {
            "left_wheel": "left_wheel|57 deg|+1 rad/s",
            "right_wheel": "right_wheel|12 deg|and more words than fit",
        },
    },
    "car 12x6": {"robot": "car", "size": (12, 6)},
    "car 100x34": {"robot": "car", "size": (100, 34), "turned": {"left_wheel_joint": 1.1, "right_wheel_joint": -0.2}},
    "round 60x24": {"robot": "round", "size": (60, 24)},
    "round 30x9": {"robot": "round", "size": (30, 9)},
    "slanted 80x30": {"robot": "slanted", "size": (80, 30), "turned": {"a": 0.3, "b": -0.4, "c": 0.9, "d": 0.2}},
    "slanted half 50x20": {"robot": "slanted", "size": (50, 20), "glyphs": "half"},
    "train 76x26": {"robot": "train", "size": (76, 26)},
    "train half missing": {"robot": "train", "size": (60, 16), "missing": ("l0", "arm", "r2")},
    "balls 50x30": {"robot": "balls", "size": (50, 30), "turned": {"left": 0.5}},
    "car 30x5": {"robot": "car", "size": (30, 5)},
    "car 30x6": {"robot": "car", "size": (30, 6)},
    "car 40x13": {"robot": "car", "size": (40, 13)},
    "car near": {"robot": "car", "size": (60, 13), "zoom": 3.0, "shift": (5, -2), "labels": {"left_wheel": "L"}},
    "car with labels at the edges": {
        "robot": "car",
        "size": (40, 16),
        "shift": (22, 0),
        "labels": {"left_wheel": "a label of some length", "right_wheel": "左轮" * 9},
    },
    "balls with readings": {
        "robot": "balls",
        "size": (50, 12),
        "zoom": 1.7,
        "labels": {"left": "left|5 deg", "right": "right|12 deg"},
    },
    "balls half 40x22": {"robot": "balls", "size": (40, 22), "glyphs": "half", "turned": {"left": -0.9, "right": 0.3}},
    "axles 100x40": {"robot": "axles", "size": (100, 40)},
    "axles 76x18": {"robot": "axles", "size": (76, 18), "turned": {"against0.3": 0.4, "cross0.3": 0.8}},
    "axles 24x14": {"robot": "axles", "size": (24, 14)},
    "close 90x30": {"robot": "close", "size": (90, 30)},
    "close 60x40": {"robot": "close", "size": (60, 40)},
    "round near": {"robot": "round", "size": (60, 30), "zoom": 1.6, "shift": (4, 2), "turned": {"left": 1.5}},
    "round from afar": {"robot": "round", "size": (30, 14), "zoom": 0.4},
    "train low": {"robot": "train", "size": (60, 8), "labels": {"l0": "l0|a b", "l2": "l2|c", "r1": "r1|d|e"}},
    "slanted 44x14": {"robot": "slanted", "size": (44, 14), "turned": {"a": 2.0, "b": 1.0, "c": -0.4, "d": -0.2}},
    "car cell 58x20": {"robot": "car", "size": (58, 20), "glyphs": "cell"},
    "car braille 58x20": {"robot": "car", "size": (58, 20), "glyphs": "braille", "turned": {"left_wheel_joint": 0.5}},
    "car half 78x11 turning": {
        "robot": "car",
        "size": (78, 11),
        "glyphs": "half",
        "turned": {"left_wheel_joint": 0.8, "right_wheel_joint": -0.8},
        "speeds": {"left_wheel": 3.0, "right_wheel": -20.0},
    },
    "car turning": {
        "robot": "car",
        "size": (78, 22),
        "turned": {"left_wheel_joint": 0.8, "right_wheel_joint": -0.8},
        "speeds": {"left_wheel": 3.0, "right_wheel": -20.0},
    },
    "round half 60x24": {"robot": "round", "size": (60, 24), "glyphs": "half"},
    "train cell 76x20": {"robot": "train", "size": (76, 20), "glyphs": "cell"},
    "slanted braille 50x20": {"robot": "slanted", "size": (50, 20), "glyphs": "braille"},
    "far 60x20": {"robot": "far", "size": (60, 20), "turned": {"w": 0.7}},
}


def drawn(robot: str, size: tuple[int, int], glyphs: str = "ascii", **how: Any) -> list[str]:
    """The rows as text; where the look is another than that of an outline, letters below say which."""
    it = ROBOTS[robot]
    transforms = link_transforms(it, how.pop("turned", {}))
    for name in how.pop("missing", ()):
        del transforms[name]
    labels = {link: tuple(text.split("|")) for link, text in how.pop("labels", {}).items()}
    turning = Turning(how.pop("speeds", {}))
    lines, letters = [], {}
    for row in render_top(plan_top(it), transforms, *size, glyphs, labels=labels, turning=turning, **how):
        lines.append("".join(text for text, _ in row).rstrip())
        looks = ""
        for text, style in row:
            if isinstance(style, tuple):  # two colours: a letter for each pair, in the order they come
                style = chr(ord("a") + letters.setdefault(style, len(letters)) % 26)
                looks += style * cell_width(text)
            else:
                looks += (style[:1] or " ").upper() * cell_width(text)
        lines.append(f"  looks {looks}".rstrip())
    names = {letter: pair for pair, letter in letters.items()}
    return [*lines, *(f"{chr(ord('a') + number % 26)} {a:06x} on {b:06x}" for number, (a, b) in sorted(names.items()))]


def written() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for block in WRITTEN.read_text(encoding="utf-8").split("picture of ")[1:]:
        name, *lines = block.split("\n")
        found[name] = lines[:-1]
    return found


@folded("case", CASES)
def test_the_picture_is_the_one_written_down(case: str) -> None:
    assert drawn(**CASES[case]) == written()[case]


def _write() -> None:
    blocks = (f"picture of {case}\n" + "".join(f"{line}\n" for line in drawn(**how)) for case, how in CASES.items())
    WRITTEN.write_text("".join(blocks), encoding="utf-8")


# -- what a picture is made of -----------------------------------------------------------------------------------------


def sheet(canvas: Canvas) -> list[str]:
    return ["".join(text for text, _ in row) for row in canvas.rows()]


@pytest.mark.parametrize(
    ("end", "rows"),
    [
        ((4, 0), ["-----", "     ", "     "]),
        ((0, 2), ["|    ", "|    ", "|    "]),
        ((2, 2), ["\\    ", " \\   ", "  \\  "]),
        ((3, 1), ["\\\\   ", "  \\\\ ", "     "]),
        ((4, 1), ["---  ", "   --", "     "]),
        ((1, 2), ["\\    ", "\\    ", " \\   "]),
        ((0, 0), ["/    ", "     ", "     "]),
    ],
)
def test_a_line_has_the_character_nearest_to_its_slope(end: tuple[int, int], rows: list[str]) -> None:
    canvas = Canvas(5, 3)
    canvas.line(0, 0, *end, "++++-|", "")
    assert sheet(canvas) == rows


def test_a_line_that_rises_leans_the_other_way() -> None:
    canvas = Canvas(3, 3)
    canvas.line(0, 2, 2, 0, "++++-|", "")
    assert sheet(canvas) == ["  /", " / ", "/  "]


def test_what_is_drawn_beside_the_sheet_is_lost() -> None:
    canvas = Canvas(3, 2)
    for column, row in ((-1, 0), (3, 0), (0, -1), (0, 2), (-1, -1)):
        canvas.put(column, row, "x", "")
        canvas.text(column, row, "", "")
    canvas.text(-1, 0, "abcde", "")
    canvas.text(0, 2, "z", "")
    canvas.text(0, -1, "z", "")
    assert sheet(canvas) == ["bcd", "   "]
    canvas.box(0, 0, 2, 1, "123456", "")
    assert sheet(canvas) == ["152", "354"]


def test_room_is_free_where_all_cells_are_there_and_blank() -> None:
    canvas = Canvas(4, 2)
    canvas.put(2, 0, "x", "")
    assert canvas.is_free(0, 0, 2) and canvas.is_free(3, 0, 1) and canvas.is_free(0, 1, 4)
    for column, row, width in ((0, 0, 3), (2, 0, 1), (-1, 1, 2), (1, 1, 4), (0, 2, 1), (0, -1, 1)):
        assert not canvas.is_free(column, row, width)


def test_runs_are_of_one_look_each() -> None:
    canvas = Canvas(5, 1)
    canvas.text(1, 0, "ab", "label")
    canvas.put(3, 0, "c", "mark")
    assert canvas.rows() == [[(" ", ""), ("ab", "label"), ("c", "mark"), (" ", "")]]
    assert Canvas(-1, -1).rows() == [] and Canvas(0, 2).rows() == [[], []]


@pytest.mark.parametrize(("text", "width"), [("", 0), ("ab", 2), ("轮", 2), ("e\u0301", 1), ("Ａ", 2), ("\u200b", 0)])
def test_text_is_as_wide_as_its_cells(text: str, width: int) -> None:
    assert cell_width(text) == width


def test_half_a_wide_character_is_never_left() -> None:
    for column, expected in ((0, "x 轮"), (1, " x轮"), (2, "左x "), (3, "左 x")):
        canvas = Canvas(4, 1)
        canvas.text(0, 0, "左轮", "label")
        canvas.put(column, 0, "x", "mark")
        assert sheet(canvas) == [expected]
        assert sum(cell_width(text) for text, _ in canvas.rows()[0]) == 4
    for column, text, expected in (
        (1, "右", " 右 "),
        (0, "右", "右轮"),
        (2, "右", "左右"),
        (1, "xy", " xy "),
        (0, "x", "x 轮"),
    ):
        canvas = Canvas(4, 1)
        canvas.text(0, 0, "左轮", "label")
        canvas.text(column, 0, text, "mark")
        assert sheet(canvas) == [expected]
    canvas = Canvas(3, 1)
    canvas.text(0, 0, "左轮", "")
    assert sheet(canvas) == ["左 "], "the second one would stick out"


def test_what_is_left_of_a_wide_character_keeps_its_look() -> None:
    canvas = Canvas(5, 1)
    canvas.text(0, 0, "|", "frame")
    canvas.text(1, 0, "轮", "label")
    canvas.put(2, 0, "x", "mark")
    assert canvas.rows() == [[("|", "frame"), (" ", "label"), ("x", "mark"), ("  ", "")]]
    canvas.text(1, 0, "轮", "label")
    canvas.put(1, 0, "x", "mark")
    assert canvas.rows() == [[("|", "frame"), ("x", "mark"), (" ", "label"), ("  ", "")]]


def test_marks_are_painted_on_the_upper_half_first_the_one_that_is_counted() -> None:
    marks = tread_marks(0.1, 0.0, 0.04)
    assert marks[0] == (0.0, True) and [first for _, first in marks[1:]] == [False] * (len(marks) - 1)
    assert sorted(round(place, 4) for place, _ in marks) == [-0.0866, 0.0, 0.0866]
    assert tread_marks(0.1, 3.1416, 0.04)[0][1] is False, "below"
    assert tread_marks(0.1, 0.5, 0.04)[0][0] == pytest.approx(0.1 * 0.479426, abs=1e-6)


def test_a_tread_has_as_many_bars_as_can_be_told_apart() -> None:
    assert [bars_of(0.1, dot) for dot in (0.0, 0.1, 0.03, 0.021, 0.001)] == [6, 6, 6, 9, 12]
    assert len(tread_marks(1.0, 0.01, 0.001)) == 6, "half of twelve are above"


@pytest.mark.parametrize(
    ("spin", "speed", "seen"),
    [
        (0.0, 0.0, []),
        (0.0, 1.0, [(-0.149, 0.0)]),
        (0.0, -1.0, [(0.0, 0.149)]),
        (0.5, 4.0, [(-0.1, 0.479)]),
        (2.0, 4.0, [(0.985, 1.0)]),  # the mark is below, the end of its tail still above
        (-2.0, 4.0, []),
        (3.0, 20.0, [(0.0, 1.0)]),
        (-1.8, 12.0, []),
        (-1.8, 20.0, [(0.996, 1.0)]),
        (0.0, 60.0, [(-1.0, 0.0), (0.3090, 1.0)]),  # never the whole way round: where it is can always be seen
    ],
)
def test_the_tail_is_the_way_the_mark_came(spin: float, speed: float, seen: list[tuple[float, float]]) -> None:
    assert [pytest.approx(part, abs=1e-3) for part in tail(1.0, spin, speed)] == seen


def test_the_hull_is_the_outline_anticlockwise() -> None:
    square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    inside = [(0.5, 0.5), (0.5, 0.0), (1.0, 0.5), (0.2, 0.9)]
    assert hull([*inside, *square, *square]) == square
    assert hull([(1.0, 1.0), (0.0, 0.0)]) == [(0.0, 0.0), (1.0, 1.0)]
    assert hull([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]) == [(0.0, 0.0), (2.0, 2.0)]
    assert hull([(0.0, 0.0), (2.0, 1.0), (1.0, 3.0)]) == [(0.0, 0.0), (2.0, 1.0), (1.0, 3.0)]


@pytest.mark.parametrize(
    ("name", "bounds"),
    [
        ("round", (-0.2, -0.24, 0.2, 0.24)),
        ("train", (-0.3, -0.22, 0.5, 0.22)),
        ("balls", (-0.1, -0.37, 0.1, 0.4)),
        ("far", (-7.0, -1.0, 23.0, 5.4)),
    ],
)
def test_a_plan_has_room_for_bodies_and_wheels(name: str, bounds: tuple[float, ...]) -> None:
    assert plan_top(ROBOTS[name]).bounds == pytest.approx(bounds, abs=1e-3)


def test_the_largest_body_is_the_chassis_and_round_things_are_casters() -> None:
    plan = plan_top(ROBOTS["train"])
    assert [(body.link, body.style) for body in plan.bodies] == [
        ("base", "chassis"), ("arm", "body"), ("mast", "body"), ("eye", "body"),
    ]  # fmt: skip
    assert [(body.link, body.style, body.radius) for body in plan_top(ROBOTS["round"]).bodies] == [
        ("base", "chassis", 0.2), ("ball", "caster", 0.05), ("tiny", "caster", 0.008),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("base", "other", "chassis"),
    [
        ('<box size="1 0.1 9"/>', '<box size="0.3 0.32 0.1"/>', "base"),
        ('<box size="1 0.1 9"/>', '<box size="0.3 0.34 0.1"/>', "other"),
        ('<cylinder radius="0.2" length="0.1"/>', '<box size="0.35 0.35 0.1"/>', "base"),
        ('<cylinder radius="0.2" length="0.1"/>', '<box size="0.36 0.36 0.1"/>', "other"),
        ('<mesh filename="a.stl"/>', '<box size="0.01 0.01 0.1"/>', "other"),
    ],
)
def test_which_body_is_the_largest_is_seen_from_above(base: str, other: str, chassis: str) -> None:
    for xyz in ("0 0 0", "3 -2 1"):
        it = robot(visual(base), part("other", visual(other, rpy="0 0 0.4"), xyz, "0 0 1"))
        assert [body.link for body in plan_top(it).bodies if body.style == "chassis"] == [chassis]


def test_a_wheel_is_measured_by_its_shape() -> None:
    (found,) = find_wheels(ROBOTS["far"])
    assert (found.radius, found.width, found.ball) == (1.5, 0.8, False)
    left, right = find_wheels(ROBOTS["balls"])
    assert (left.radius, left.width, left.ball) == (0.1, 0.2, True)
    assert (right.joint.name, right.width) == ("right", 0.14)


def test_a_wheel_may_have_its_cylinder_to_collide_with_only() -> None:
    mesh, cylinder = '<mesh filename="w.stl"/>', '<cylinder radius="0.3" length="0.1"/>'
    shapes = visual(mesh) + visual(cylinder, rpy="1.5707963 0 0").replace("visual", "collision")
    (found,) = find_wheels(robot(BOX, part("w", shapes, "0 0 0", kind="continuous")))
    assert found.radius == 0.3


@pytest.mark.parametrize(("yaw", "heading"), [("0", (1.0, 0.0)), ("1.5708", (0.0, 1.0)), ("3.1416", (-1.0, 0.0))])
def test_the_top_of_a_wheel_moves_at_a_right_angle_to_its_axis(yaw: str, heading: tuple[float, float]) -> None:
    it = robot(BOX, wheel("w", "0.1 0.2 0.3", f"0 0 {yaw}"))
    (found,) = find_wheels(it)
    place, direction = stand(found, link_transforms(it, {"w": 0.8}))
    assert place == pytest.approx((0.1, 0.2)) and direction == pytest.approx(heading, abs=1e-4)


def test_a_wheel_that_lies_flat_is_drawn_as_if_it_rolled_forwards() -> None:
    it = robot(BOX, wheel("w", "0.1 0.2 0.3"))
    (found,) = find_wheels(it)
    flat = replace(found, joint=replace(found.joint, axis=(0.0, 0.0, 1.0)))
    assert stand(flat, link_transforms(it, {}))[1] == (1.0, 0.0)


@pytest.mark.parametrize("angle", [-3.1, -1.0, 0.0, 0.25, 3.1, 7.0])
def test_the_spin_is_found_in_the_transforms_whatever_the_axis(angle: float) -> None:
    import math

    for axis in ("0 1 0", "0 -3 0", "0 0.5 0"):
        it = robot(BOX, wheel("w", "1 2 3", "0.1 0 0.7").replace('axis xyz="0 1 0"', f'axis xyz="{axis}"'))
        (found,) = find_wheels(it)
        assert spin_of(found, link_transforms(it, {"w": angle})) == pytest.approx(math.remainder(angle, 2 * math.pi))


def test_a_wheel_that_is_steered_has_a_joint_about_the_vertical_above_it() -> None:
    def steered(axis: str, kind: str) -> Robot:
        limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
        fork = part("fork", "", "0 0 0", kind=kind, axis=axis).replace("</joint>", f"{limit}</joint>")
        held = part("held", "", "0 0 0").replace('parent link="base"', 'parent link="fork"')
        rolls = wheel("w", "0 0 0").replace('parent link="base"', 'parent link="held"')
        return robot(BOX, fork, held, rolls)

    for axis, kind, name in (
        ("0 0 1", "revolute", "fork"),
        ("0 0 -2", "continuous", "fork"),
        ("0.1 0 1", "revolute", "fork"),
        ("0.6 0 1", "revolute", None),
        ("0 1 0", "revolute", None),
        ("0 0 1", "prismatic", None),
        ("0 0 1", "fixed", None),
    ):
        it = steered(axis, kind)
        found = steering_of(it, next(each for each in find_wheels(it) if each.joint.name == "w"))
        assert (found.name if found is not None else None) == name, (axis, kind)


if __name__ == "__main__":
    _write()
