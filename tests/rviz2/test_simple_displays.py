"""Displays of sensors' numbers, of outlines and cells, of forces and velocities: properties, pictures, statuses."""

from __future__ import annotations

import math
from typing import Any

import pytest
from geometry_msgs.msg import (
    AccelStamped,
    Point,
    Point32,
    PolygonStamped,
    PoseWithCovarianceStamped,
    TwistStamped,
    WrenchStamped,
)
from nav_msgs.msg import GridCells
from sensor_msgs.msg import FluidPressure, Illuminance, RelativeHumidity, Temperature

from day6_core.ros.programs.rviz2.model.topics import INVALID_FLOATS
from day6_tui.locale import Texts
from day6_tui.windows.rviz.describing import described
from tests.rviz2.rviz_machine import RVizMachine


@pytest.fixture
def world(machine: RVizMachine) -> RVizMachine:
    machine.open()
    machine.fix("base_link")
    machine.transform("base_link", "sensor", (1, 2, 3))
    return machine


def stamped(kind: type, **fields: Any) -> Any:
    message = kind(**fields)
    message.header.frame_id = "sensor"
    return message


def colour_of(world: RVizMachine) -> tuple[float, ...]:
    return tuple(float(part) for part in world.rviz.scene.points[0].colours[0][:3])


@pytest.mark.parametrize(
    ("name", "kind", "low", "high"),
    [
        ("Temperature", Temperature, 0.0, 100.0),
        ("RelativeHumidity", RelativeHumidity, 0.0, 1.0),
        ("Illuminance", Illuminance, 0.0, 1000.0),
        ("FluidPressure", FluidPressure, 98000.0, 105000.0),
    ],
)
def test_a_number_is_a_coloured_point_at_its_sensor(
    world: RVizMachine, name: str, kind: type, low: float, high: float
) -> None:
    display = world.add(name, "/number")
    assert (display.child("Min Intensity").value, display.child("Max Intensity").value) == (low, high)
    field = {"FluidPressure": "fluid_pressure", "RelativeHumidity": "relative_humidity"}.get(name, name.lower())
    world.publish("/number", stamped(kind, **{field: low}))
    assert world.rviz.scene.points[0].xyz.tolist() == [[1.0, 2.0, 3.0]]
    cold = colour_of(world)
    world.publish("/number", stamped(kind, **{field: high}))
    assert colour_of(world) != cold
    if name == "Temperature":
        assert cold == (1.0, 0.0, 1.0) and colour_of(world) == (1.0, 0.0, 0.0)  # hot is red


def test_a_polygon_is_closed(world: RVizMachine) -> None:
    display = world.add("Polygon", "/outline")
    message = stamped(PolygonStamped)
    message.polygon.points = [Point32(x=float(x), y=float(y)) for x, y in ((0, 0), (1, 0), (1, 1))]
    world.publish("/outline", message)
    lines = world.rviz.scene.lines[-1]
    assert len(lines.vertices) == 6 and lines.vertices[0] == lines.vertices[-1] and lines.pose.xyz == (1, 2, 3)
    message.polygon.points[0].x = math.nan
    world.publish("/outline", message)
    assert display.status("Topic") == ("Error", INVALID_FLOATS)


def test_grid_cells_and_what_is_wrong_with_them(world: RVizMachine) -> None:
    display = world.add("GridCells", "/cells")
    cells = stamped(GridCells, cell_width=0.5, cell_height=0.5, cells=[Point(x=1.0), Point(x=2.0)])
    world.publish("/cells", cells)
    assert world.rviz.scene.points[0].size == 0.5 and len(world.rviz.scene.points[0].xyz) == 2
    cells.cell_width = 0.0
    world.publish("/cells", cells)
    assert display.status("Topic") == ("Error", "One of the Cell's dimension is zero, cells will be invisible.")
    cells.cell_width, cells.cells = 0.5, []
    world.publish("/cells", cells)
    assert display.status("Topic") == ("Warn", "Message is empty: there are no cells to be shown.")


def test_a_wrench_has_an_arrow_for_the_force_and_one_for_the_torque(world: RVizMachine) -> None:
    display = world.add("Wrench", "/wrench")
    message = stamped(WrenchStamped)
    message.wrench.force.x, message.wrench.torque.z = 1.0, 0.1
    world.publish("/wrench", message)
    assert len(world.rviz.scene.shapes) == 2  # shaft and head; the torque is shorter than the arrow is wide
    message.wrench.torque.z = 1.0
    world.publish("/wrench", message)
    # Two arrows, and the head of the circle half-way up the torque, as far from it as a quarter of its length.
    assert len(world.rviz.scene.shapes) == 5
    x, y, z = world.rviz.scene.shapes[-1].pose.xyz
    assert math.hypot(x - 1, y - 2) == pytest.approx((z - 3) / 2, abs=0.01)
    message.wrench.force.y = math.nan
    world.publish("/wrench", message)
    assert display.status("Topic") == ("Error", INVALID_FLOATS)
    world.rviz.edit(display.child("Accept NaN Values"), True)
    world.publish("/wrench", message)
    assert len(world.rviz.scene.shapes) == 5


@pytest.mark.parametrize(
    ("name", "kind", "part"), [("AccelStamped", AccelStamped, "accel"), ("TwistStamped", TwistStamped, "twist")]
)
def test_small_motions_are_hidden_if_wanted(world: RVizMachine, name: str, kind: type, part: str) -> None:
    display = world.add(name, "/motion")
    message = stamped(kind)
    getattr(message, part).linear.x = 0.1
    world.publish("/motion", message)
    assert not world.rviz.scene.shapes
    world.rviz.edit(display.child("Hide Small Values"), False)
    world.settle()
    assert len(world.rviz.scene.shapes) == 2


def test_a_class_that_is_not_here_says_so_in_one_line_and_keeps_its_words(world: RVizMachine) -> None:
    text = (
        "Panels:\n  - Class: nav2_rviz_plugins/Navigation 2\n    Name: N\n"
        "Visualization Manager:\n  Displays:\n    - Class: nav2_rviz_plugins/ParticleCloud\n      Name: Particles\n"
        "      Enabled: true\n      Auto Size: {Value: true}\n    - Class: rviz/Grid\n    - Class: rviz_default_plugins/Gird\n"
        "    - Class: rviz_satellite/AerialMap\n    - Class: rviz_satellite/AerialMap\n"
        "  Tools:\n    - Class: nav2_rviz_plugins/GoalTool\n"
    )
    world.do(lambda: world.rviz.load_text(text))
    display = world.rviz.displays[0]
    said = [line.partition("]: ")[2] for line in world.running.errors.splitlines() if line.startswith("[ERROR]")]
    assert display.status("Class")[1] == said[0]
    assert [line.partition(":")[0] for line in said] == [
        f"class {name} isn't here" for name in (
            "nav2_rviz_plugins/ParticleCloud", "rviz/Grid", "rviz_default_plugins/Gird", "rviz_satellite/AerialMap",
            "nav2_rviz_plugins/GoalTool", "nav2_rviz_plugins/Navigation 2",
        )
    ]  # fmt: skip
    words = (
        "nav2_amcl",
        "rviz_default_plugins/Grid",
        "nothing of that name",
        "rviz_satellite",
        "SetGoal",
        "Navigation2",
    )
    for line, word in zip(said, words, strict=True):
        assert word in line.partition(": ")[2]
    assert display.save()["Auto Size"] == {"Value": True}
    assert world.rviz.save()["Panels"][1] == {"Class": "nav2_rviz_plugins/Navigation 2", "Name": "N"}


def test_a_pose_estimate_is_shown_with_its_covariance(world: RVizMachine) -> None:
    display = world.add("PoseWithCovariance", "/initialpose")
    message = stamped(PoseWithCovarianceStamped)
    message.pose.pose.orientation.w = 1.0
    message.pose.covariance[0] = message.pose.covariance[7] = 0.25
    world.publish("/initialpose", message)
    assert world.rviz.scene.shapes[-1].size == (1.0, 1.0, 0.001)
    message.pose.covariance[35] = math.nan
    world.publish("/initialpose", message)
    assert display.status("Topic") == ("Error", INVALID_FLOATS)


@pytest.mark.parametrize(
    "lang, words", [("en", "it draws the particles of nav2_amcl"), ("zh", "它画 nav2_amcl 的粒子")]
)
def test_a_class_that_is_not_here_is_told_in_plain_words(world: RVizMachine, lang: str, words: str) -> None:
    text = (
        "Visualization Manager:\n  Displays:\n    - Class: nav2_rviz_plugins/ParticleCloud\n      Name: Swarm\n"
        "      Enabled: true\n"
    )
    world.do(lambda: world.rviz.load_text(text))
    assert words in described(world.rviz, Texts(lang))


def test_messages_that_wait_for_a_transform_are_told_with_their_frame(world: RVizMachine) -> None:
    world.add("Polygon", "/polygon")
    message = stamped(PolygonStamped)
    message.header.frame_id = "nowhere"
    for _ in range(3):
        world.publish("/polygon", message)
    words = described(world.rviz, Texts("en"))
    assert "Polygon: 3 messages are waiting for a transform from nowhere to " in words
