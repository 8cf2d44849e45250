"""Two readers, one robot; and yourdfpy loaded lightly."""

from __future__ import annotations

import math
import random
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path

import pytest
import yaml

from day6_urdf import RobotError, copy_model, load_robot, parse_robot, shipped_model, shipped_models
from day6_urdf.model import Box, Collision, Cylinder, Inertial, Joint, Link, Pose, Robot, Sphere, Visual
from tests.support.folded import folded


def rough(value: object) -> object:
    """Return the value with numbers rounded to what two ways of computing agree on, and one sign for each rotation."""
    if isinstance(value, float):
        return round(value, 9) + 0.0
    if isinstance(value, Pose):
        numbers = tuple(round(number, 8) + 0.0 for number in value.rotation)
        return rough(value.xyz), max(numbers, tuple(0.0 - number for number in numbers))
    if isinstance(value, tuple):
        return tuple(rough(item) for item in value)
    if isinstance(value, (Robot, Link, Joint, Visual, Collision, Inertial)):
        return tuple(rough(getattr(value, field.name)) for field in fields(value) if field.compare)
    return value


def test_the_shipped_car_has_the_articles_figures() -> None:
    car = parse_robot(shipped_model())
    assert [link.name for link in car.links] == ["base_link", "left_wheel", "right_wheel", "caster"]
    chassis, left, right, caster = (link.visuals[0] for link in car.links)
    assert (chassis.geometry, chassis.origin.xyz) == (Box((0.4, 0.25, 0.08)), (0.0, 0.0, 0.04))
    assert left.geometry == right.geometry == Cylinder(0.05, 0.03)
    assert caster.geometry == Sphere(0.02)
    assert left.origin.rpy == pytest.approx((1.5707963, 0, 0))
    assert [(joint.type, joint.origin.xyz) for joint in car.joints] == [
        ("continuous", (0.0, 0.15, 0.05)),
        ("continuous", (0.0, -0.15, 0.05)),
        ("fixed", (0.1, 0.0, 0.02)),
    ]
    assert car.joint("left_wheel_joint").axis == car.joint("right_wheel_joint").axis == (0.0, 1.0, 0.0)
    assert chassis.material is not None and chassis.material.color == (0.2, 0.3, 0.9, 1.0)
    assert caster.material is not None and caster.material.color == (0.7, 0.7, 0.7, 1.0)


def test_the_shipped_car_can_be_given_as_a_parameter_on_the_command_line() -> None:
    # -p robot_description:="$(cat day6_bot.urdf)" is read as YAML, in which a colon before a blank would end the string.
    text = shipped_model().read_text(encoding="utf-8")
    value = yaml.safe_load(text)
    assert isinstance(value, str) and parse_robot(value) == parse_robot(text)


def test_the_shipped_car_is_copied_to_where_it_is_short_to_type_but_never_over_somebodys_work(tmp_path: Path) -> None:
    copy = copy_model(tmp_path)
    assert copy == tmp_path / "day6_bot.urdf"
    assert parse_robot(copy) == parse_robot(shipped_model())
    copy.write_text("mine")
    assert copy_model(tmp_path).read_text() == "mine"


def test_a_robot_that_is_not_shipped_is_an_error() -> None:
    assert shipped_model("day6_bot.urdf") == shipped_model()
    with pytest.raises(KeyError):
        shipped_model("no_such_bot")


@pytest.mark.parametrize("read", [parse_robot, load_robot])
def test_the_right_wheel_gets_its_colour_by_name(read: object) -> None:
    assert callable(read)
    right = read(shipped_model()).link("right_wheel").visuals[0]
    assert right.material_name == "dark"
    assert right.material.color == (0.2, 0.2, 0.2, 1.0)


@pytest.mark.parametrize("name", shipped_models())
def test_yourdfpy_reads_every_shipped_robot_as_our_parser_does(name: str) -> None:
    assert rough(load_robot(shipped_model(name))) == rough(parse_robot(shipped_model(name)))


@folded("seed", range(40))
def test_yourdfpy_reads_random_robots_as_our_parser_does(seed: int, random_description: Callable[..., str]) -> None:
    text = random_description(random.Random(seed))
    assert rough(load_robot(text)) == rough(parse_robot(text))


def test_a_robot_with_a_part_yourdfpy_dies_of_is_still_loaded() -> None:
    text = '<robot name="r"><link name="a"><visual><geometry><cone/></geometry></visual></link></robot>'
    assert load_robot(text) == parse_robot(text)
    assert load_robot(text).links[0].name == "a"


def test_it_is_noted_when_yourdfpy_refuses_and_only_then(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level("INFO", "day6_urdf.load"):
        load_robot(shipped_model())
        assert caplog.messages == []
        load_robot('<robot name="r"><link name="a"><visual><geometry><cone/></geometry></visual></link></robot>')
    assert len(caplog.messages) == 1 and caplog.messages[0].startswith("yourdfpy refused 'r': ")


def test_entities_and_comments_do_not_reach_yourdfpy(tmp_path: Path) -> None:
    secret = tmp_path / "secret"
    secret.write_text("secret")
    text = (
        f'<!DOCTYPE robot [<!ENTITY x SYSTEM "{secret.as_uri()}">]><robot name="&x;"><!-- c --><link name="a">'
        '<visual><geometry><!-- first child --><sphere radius="1"/></geometry></visual></link></robot>'
    )
    robot = load_robot(text)
    assert robot.name == "&x;"
    assert robot.link("a").visuals[0].geometry == Sphere(1.0)


def test_errors_carry_what_urdfdom_says() -> None:
    with pytest.raises(RobotError) as caught:
        load_robot('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert str(caught.value) == "Failed to find root link: Two root links found: [a] and [b]"
    assert len(caught.value.diagnostics) == 1


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(RobotError, match=r"File .*none\.urdf does not exist"):
        load_robot(tmp_path / "none.urdf")
    with pytest.raises(RobotError, match="cannot be read"):
        load_robot(tmp_path)


def test_a_reachable_loop_is_found_and_does_not_hang_the_walk() -> None:
    joint = '<joint name="{0}" type="fixed"><parent link="{1}"/><child link="{2}"/></joint>'
    links = "".join(f'<link name="{name}"/>' for name in "abc")
    joints = joint.format("ab", "a", "b") + joint.format("bc", "b", "c") + joint.format("cb", "c", "b")
    robot = parse_robot(f'<robot name="r">{links}{joints}</robot>')
    assert robot.loop == ("b", "c", "b")
    assert [item.name for item in robot.tree()] == ["ab", "bc"]
    assert parse_robot(shipped_model()).loop == ()


def fresh(code: str) -> str:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout


@pytest.mark.process
def test_loading_a_robot_takes_little_of_trimesh_and_numpy_and_the_rest_comes_when_it_is_used() -> None:
    code = (
        "import sys; from day6_urdf import load_robot, shipped_model; load_robot(shipped_model())\n"
        "much = {'scipy', 'networkx', 'PIL', 'shapely', 'trimesh.base', 'numpy.random', 'numpy.ma', '_hashlib'}\n"
        "print(sorted(set(sys.modules) & {'yourdfpy', 'trimesh.transformations', *much}))\n"
        "import numpy, trimesh, trimesh.util\n"
        "print(0 <= trimesh.util._RANDOM_DEFAULT.random() < 1 and 0 <= numpy.random.rand() < 1)\n"
        "print(trimesh.primitives.Box(extents=[1, 2, 3]).volume, trimesh.Scene.__module__, trimesh.load.__name__)"
    )
    assert fresh(code).splitlines() == [
        "['trimesh.transformations', 'yourdfpy']",
        "True",
        "6.0 trimesh.scene.scene load",
    ]


@pytest.mark.process
def test_checking_a_robot_needs_neither_numpy_nor_yourdfpy() -> None:
    code = (
        "import sys; from day6_urdf import parse_robot, shipped_model; import day6_urdf.topview\n"
        "parse_robot(shipped_model()); print(set(sys.modules) & {'numpy', 'yourdfpy', 'lxml', 'xml'} or 'none')"
    )
    assert fresh(code).strip() == "none"


@pytest.mark.process
def test_when_the_light_import_fails_the_plain_one_is_used() -> None:
    code = (
        "import sys, importlib.util\n"
        "from day6_urdf import yourdfpy_robot, load_robot, shipped_model\n"
        "real = importlib.import_module\n"
        "def minding(name, *rest):\n"
        "    if name == 'yourdfpy' and 'trimesh' in sys.modules: raise RuntimeError('it needs more')\n"
        "    return real(name, *rest)\n"
        "importlib.import_module = minding\n"
        "print(load_robot(shipped_model()).name, 'trimesh.base' in sys.modules)"
    )
    assert fresh(code).split() == ["day6_bot", "True"]


def test_a_robot_is_data_that_compares_and_cannot_change() -> None:
    car = parse_robot(shipped_model())
    assert isinstance(car, Robot) and car == parse_robot(shipped_model())
    with pytest.raises(AttributeError):
        car.name = "other"  # type: ignore[misc]
    assert car.root == "base_link"
    assert math.isclose(sum(n * n for n in car.links[1].visuals[0].origin.rotation), 1.0)
