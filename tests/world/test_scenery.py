"""World files: what they may say, and that a wrong one says where it is wrong."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest

from day6_core.ros.environment import SHARE_PATH
from day6_core.ros.programs.day6_world._drive import find_drive
from day6_core.ros.programs.day6_world._simulation import Simulation, collision_shapes
from day6_core.ros.programs.day6_world.scenery import SceneryError, read_scenery, shipped_worlds
from day6_core.ros.programs.day6_world.shapes import Outline, RayCaster, box, overlap
from day6_urdf import parse_robot, shipped_model
from day6_urdf.kinematics import link_transforms

WORLDS = shipped_worlds(SHARE_PATH / "day6_world")


def write(tmp_path: Path, text: str) -> Path:
    file = tmp_path / "yard.yaml"
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize("name", sorted(WORLDS))
def test_every_shipped_world_can_be_read_and_starts_on_free_floor(name: str) -> None:
    scenery = read_scenery(WORLDS[name])
    car = box(0, 0, 0.4, 0.33).moved(*scenery.start[:2], math.cos(scenery.start[2]), math.sin(scenery.start[2]))
    assert not any(overlap(car, solid) for solid in scenery.solids)


def test_a_world_of_one_s_own(tmp_path: Path) -> None:
    scenery = read_scenery(
        write(
            tmp_path,
            "size: [4, 2]\nborder: false\nstart: {x: 1, yaw: 90}\nwalls: [{from: [0, -1], to: [0, 1]}]\n"
            "cylinders: [{x: 1.5, y: 0, radius: 0.2}]\nline: {points: [[0, 0], [1, 0], [1, 1]], width: 0.04}\n",
        )
    )
    assert scenery.name == "yard" and scenery.size == (4.0, 2.0)
    assert scenery.start == (1.0, 0.0, pytest.approx(math.pi / 2))
    assert len(scenery.solids) == 2 and len(scenery.line) == 2 and scenery.line_width == 0.04


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("size: [4]", "world.size: two numbers are expected, like [1.0, 2.0]"),
        ("size: [4, 0]", "size: both lengths have to be greater than 0"),
        ("walls: [{from: [0, 0]}]", "walls[0].to: two numbers are expected"),
        ("boxes: [{x: 1, y: .nan, size: [1, 1]}]", "boxes[0].y: a number is expected, not nan"),
        ("boxes: [{x: 1, size: [1, 1]}]", "boxes[0].y: a number is expected, not None"),
        ("cylinders: [{x: 1, y: 1, radius: 0}]", "cylinders[0].radius: has to be greater than 0"),
        ("wall: []", "world: 'wall' is not known here"),
        ("[1, 2]", "world: names and values are expected here, not list"),
        ("walls: 3", "world.walls: a list of at most 2000 is expected"),
        ("a: &x [1]\nb: *x", "aliases (*name) are not allowed"),
        ("size: [4, 4", "no YAML: "),
        ("x: !!python/object/apply:os.getcwd []", "no YAML: "),
        ("size: [1e9, 1]", "world.size: a number is expected"),
    ],
)
def test_a_wrong_world_file_says_where_it_is_wrong(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(SceneryError) as error:
        read_scenery(write(tmp_path, text))
    assert said in str(error.value)


def test_a_huge_file_is_not_read(tmp_path: Path) -> None:
    with pytest.raises(SceneryError, match="more than 200 kB"):
        read_scenery(write(tmp_path, "# " + "x" * 300_000))


@pytest.mark.long
@pytest.mark.parametrize("seed", range(8))
def test_rays_find_the_same_as_walking_along_them(seed: int) -> None:
    import random

    choice = random.Random(seed)
    shapes = [
        box(
            choice.uniform(-3, 3),
            choice.uniform(-3, 3),
            choice.uniform(0.2, 1),
            choice.uniform(0.2, 1),
            choice.uniform(0, 3),
        )
        for _ in range(4)
    ]
    shapes.append(Outline(((choice.uniform(-3, 3), choice.uniform(-3, 3)),), 0.4))
    spot = Outline(((0.0, 0.0),), 1e-6)
    if any(overlap(spot, shape) for shape in shapes):
        return
    count = 24
    lengths = RayCaster(shapes).cast(0.0, 0.0, -math.pi, 2 * math.pi / count, count, 8.0)
    for number, length in enumerate(lengths):
        angle = -math.pi + number * 2 * math.pi / count
        walked = next(
            (
                step * 0.01
                for step in range(1, 800)
                if any(
                    overlap(Outline(((step * 0.01 * math.cos(angle), step * 0.01 * math.sin(angle)),), 1e-6), shape)
                    for shape in shapes
                )
            ),
            math.inf,
        )
        if math.isfinite(walked):
            # A corner that is only grazed may lie between two steps of the walk.
            assert length <= walked + 1e-6 and length > walked - 0.3


@pytest.mark.parametrize("name", ["maze", "walls"])
def test_what_the_car_hits_does_not_depend_on_where_it_was_before(name: str) -> None:
    car, scenery, picker = parse_robot(shipped_model("day6_bot_gazebo")), read_scenery(WORLDS[name]), random.Random(2)
    drive = find_drive(car)
    assert drive is not None
    simulation, shapes = Simulation(scenery), collision_shapes(car, link_transforms(car, {}))
    simulation.enter(car, drive)
    found = []
    for number in range(1000):
        if number % 50 == 0:
            simulation.order_velocity(picker.uniform(-1, 1), picker.uniform(-2, 2))
        simulation.step()
        reach = 10 ** picker.uniform(-3, 0)
        x, y, yaw = (part + picker.uniform(-reach, reach) for part in simulation.pose)
        there = [shape.moved(x, y, math.cos(yaw), math.sin(yaw)) for shape in shapes]
        found.append(any(overlap(shape, solid) for shape in there for solid in scenery.solids))
        assert simulation._hits((x, y, yaw), shapes) is found[-1]
    assert 50 < sum(found) < 950
