"""Robots of others: from packages that are installed, or a folder given by DAY6_ROBOTS (skipped where there are none).

For the whole of it: `pip install --no-deps --target DIR jvrc-description robot-properties-fingers upkie-description
airo-models dexmate-urdf icub-models cookie-description`, then DAY6_ROBOTS=DIR.
"""

from __future__ import annotations

import importlib.util
import io
import os
import random
from pathlib import Path

import pytest

from day6_urdf import RobotError, parse_robot, yourdfpy_robot
from day6_urdf.kinematics import link_transforms, matrix
from day6_urdf.load import load_robot
from day6_urdf.xmlreader import read_xml, write_xml

pytestmark = pytest.mark.outside

PACKAGES = (
    "jvrc_description",
    "robot_properties_fingers",
    "upkie_description",
    "airo_models",
    "dexmate_urdf",
    "icub_models",
    "cookie_description",
)


def folders() -> list[Path]:
    given = os.environ.get("DAY6_ROBOTS")
    found = [Path(given)] if given else []
    for name in PACKAGES:
        spec = importlib.util.find_spec(name)
        if spec is not None and spec.submodule_search_locations:
            found.append(Path(next(iter(spec.submodule_search_locations))))
    return found


def descriptions() -> list[Path]:
    return sorted({path for folder in folders() for path in folder.rglob("*.urdf")})


@pytest.mark.skipif(not descriptions(), reason="no packages with robots are installed, see above")
@pytest.mark.parametrize("path", descriptions(), ids=lambda path: path.name)
def test_a_real_robots_links_stand_where_yourdfpy_puts_them(path: Path) -> None:
    try:
        robot = parse_robot(path)
    except RobotError as error:
        assert error.diagnostics[-1].text, "refused without a reason"
        return
    text = write_xml([e for e in read_xml(path.read_text(encoding="utf-8", errors="replace")) if e.tag == "robot"][:1])
    urdf = yourdfpy_robot.module().URDF.load(
        io.BytesIO(text.encode()), load_meshes=False, build_collision_scene_graph=False, load_collision_meshes=False
    )
    choice = random.Random(path.name)
    movable = set(urdf.actuated_joint_names)
    positions = {joint.name: choice.uniform(-1, 1) for joint in robot.joints if joint.name in movable}
    urdf.update_cfg(positions)
    for link, transform in link_transforms(robot, positions).items():
        theirs = urdf.get_transform(link, robot.root)
        for row, their_row in zip(matrix(transform), theirs, strict=True):
            assert row == pytest.approx(list(their_row), abs=1e-9), link


@pytest.mark.skipif(not descriptions(), reason="no packages with robots are installed, see above")
def test_thirty_of_them_load_and_both_readers_agree_on_their_parts() -> None:
    loaded = 0
    for path in descriptions():
        try:
            robot = load_robot(path)
        except RobotError:
            continue
        ours = parse_robot(path)
        assert [link.name for link in robot.links] == [link.name for link in ours.links]
        assert [(j.name, j.type, j.parent, j.child) for j in robot.joints] == [
            (j.name, j.type, j.parent, j.child) for j in ours.joints
        ]
        loaded += 1
    assert loaded >= min(30, len(descriptions()) - 3)
