"""Files: what is loaded comes back when saved, the real tool's own files survive, and bad ones are refused in words."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import yaml

from day6_core.ros.programs.rviz2.model.config import ConfigError, read_config, write_config
from day6_core.ros.programs.rviz2.model.displays import TYPES
from day6_core.ros.programs.rviz2.rviz2 import default_config
from tests.rviz2.rviz_machine import lines

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine

FOREIGN = """\
Panels:
  - Class: rviz_common/Displays
    Help Height: 78
    Name: Displays
    Property Tree Widget:
      Expanded:
        - /Global Options1
        - /RobotModel1
        - /RobotModel1/Description Topic1
      Splitter Ratio: 0.5
    Tree Height: 617
  - Class: nav2_rviz_plugins/Navigation 2
    Name: Navigation 2
Visualization Manager:
  Class: ""
  Displays:
    - Alpha: 0.5
      Class: rviz_default_plugins/RobotModel
      Collision Enabled: false
      Description File: ""
      Description Source: Topic
      Description Topic:
        Depth: 5
        Durability Policy: Volatile
        History Policy: Keep Last
        Reliability Policy: Reliable
        Value: /robot_description
      Enabled: false
      Links:
        All Links Enabled: true
        Expand Joint Details: false
        Expand Link Details: false
        Expand Tree: false
        Link Tree Style: Tree of links
        base_link:
          Alpha: 0.25
          Show Axes: true
          Show Trail: false
          Value: true
      Mass Properties:
        Inertia: false
        Mass: true
      Name: my robot
      New Property Of Later Versions: 42
      TF Prefix: ""
      Update Interval: 0
      Value: false
      Visual Enabled: true
    - Class: nav2_rviz_plugins/ParticleCloud
      Color: 0; 180; 0
      Enabled: true
      Name: Amcl Particle Swarm
      Topic:
        Value: /particle_cloud
      Value: true
  Enabled: true
  Global Options:
    Background Color: 10; 20; 30
    Fixed Frame: odom
    Frame Rate: 12
  Name: root
  Tools:
    - Class: rviz_default_plugins/MoveCamera
  Transformation:
    Current:
      Class: rviz_default_plugins/TF
  Value: true
  Views:
    Current:
      Angle: 0.5
      Class: rviz_default_plugins/TopDownOrtho
      Enable Stereo Rendering:
        Stereo Eye Separation: 0.05999999865889549
        Stereo Focal Distance: 1
        Swap Stereo Eyes: false
        Value: false
      Invert Z Axis: false
      Name: Current View
      Near Clip Distance: 0.009999999776482582
      Scale: 150.5
      Target Frame: base_link
      Value: TopDownOrtho (rviz_default_plugins)
      X: 1.25
      Y: -2
    Saved: ~
Window Geometry:
  Height: 846
  QMainWindow State: 000000ff00000000fd000000040000
"""


def test_our_default_is_read_and_written_as_it_is() -> None:
    text = default_config()
    assert write_config(read_config(text)) == text


def test_the_writer_writes_what_yaml_reads_back() -> None:
    nasty = {
        "a": ["x: y", "- z", "#no", "true", "12", "", " lead", "tab\there", "quote\"s", "null", "<Fixed Frame>", "中文", "~"],
        "Empty": {}, "List": [], "None": None, "Nested": [[1, [2]], {"k": {}}],
        "Number": 0.03, "Bool": False, "12": "text", "multi": "two\nlines",
    }  # fmt: skip
    read = yaml.safe_load(write_config(nasty))
    assert {str(key): value for key, value in read.items()} == nasty


def test_a_file_of_another_rviz_comes_back_whole(machine: RVizMachine, tmp_path: Path) -> None:
    file = tmp_path / "nav.rviz"
    file.write_text(FOREIGN)
    rviz = machine.open("-d", str(file))
    assert rviz.fixed_frame == "odom" and rviz.background.value == (10, 20, 30) and rviz.frame_rate.value == 12
    robot, cloud = rviz.displays
    assert (robot.name, robot.enabled) == ("my robot", False)
    assert robot.child("Mass Properties", "Mass").value is True
    assert robot.child("Description Topic", "Durability Policy").value == "Volatile"
    assert robot.expanded is False  # the file names it RobotModel, but it is called "my robot"
    assert lines(cloud)["Class"][0] == "Error"
    assert rviz.view.type == "TopDownOrtho" and rviz.view.child("Scale").value == 150.5
    saved = yaml.safe_load(write_config(rviz.save()))
    expected = yaml.safe_load(FOREIGN)
    panels = saved.pop("Panels")
    assert panels[1] == expected["Panels"][1]
    expected.pop("Panels")
    current = saved["Visualization Manager"]["Views"]["Current"]
    assert current.pop("Value") == "TopDownOrtho (rviz)"
    expected["Visualization Manager"]["Views"]["Current"].pop("Value")
    assert saved == expected


def test_every_display_type_survives_saving_and_loading(machine: RVizMachine) -> None:
    rviz = machine.open()
    for name in TYPES:
        machine.add(name)
    text = write_config(rviz.save())
    machine.do(lambda: rviz.load_text(text))
    assert write_config(rviz.save()) == text
    assert [display.name for display in rviz.displays] == ["Grid", *TYPES]
    assert not rviz.modified


@pytest.mark.parametrize("frame", ["base_link", "lidar", "/base_link"])
def test_the_fixed_frame_of_a_file_is_the_one_that_is_used(machine: RVizMachine, tmp_path: Path, frame: str) -> None:
    file = tmp_path / "a.rviz"
    file.write_text(f"Visualization Manager: {{Global Options: {{Fixed Frame: {frame}}}}}")
    machine.transform("base_link", "lidar")
    rviz = machine.open("-d", str(file))
    axes = machine.add("Axes")
    rviz.edit(axes.child("Reference Frame"), "lidar")
    machine.settle()
    assert rviz.statuses.line("Fixed Frame") == ("Ok", "OK")
    assert lines(axes) == {"Transform": ("Ok", "Transform OK")}


def test_changes_are_saved(machine: RVizMachine) -> None:
    rviz = machine.open()
    rviz.edit_text(rviz.displays[0].child("Cell Size"), "0.1")
    rviz.edit_text(rviz.displays[0].child("Color"), "255; 0; 12")
    rviz.edit_text(rviz.displays[0].child("Offset"), "1 2 -0.5")
    machine.settle()
    assert rviz.modified
    grid = yaml.safe_load(write_config(rviz.save()))["Visualization Manager"]["Displays"][0]
    assert (grid["Cell Size"], grid["Color"], grid["Offset"]) == (
        0.10000000149011612,  # single precision, as RViz writes it
        "255; 0; 12",
        {"X": 1, "Y": 2, "Z": -0.5},
    )


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("a: [1, 2", "line 1, column 9"),
        ("- just\n- a list", "this is not an RViz configuration"),
        ("a: &x [1]\nb: [*x, *x]", "aliases are not allowed"),
        ("!!python/object/apply:os.system ['true']", "could not determine a constructor"),
        ("a: " + "[" * 200 + "]" * 200, "nested too deeply"),
        ("", "this is not an RViz configuration"),
        ("\0", "this is not YAML"),
    ],
)
def test_files_that_are_refused(text: str, why: str) -> None:
    with pytest.raises(ConfigError, match=why.replace("(", "\\(")):
        read_config(text)


def test_a_bad_file_on_the_command_line_is_told_and_the_default_is_shown(machine: RVizMachine, tmp_path: Path) -> None:
    file = tmp_path / "broken.rviz"
    file.write_text("a: [")
    rviz = machine.open("-d", str(file))
    assert rviz.message is not None and rviz.message[0] == "rviz.hint.config"
    assert [display.name for display in rviz.displays] == ["Grid"]
    assert machine.running is not None and "broken.rviz" in machine.running.errors


def test_displays_with_values_of_the_wrong_kind_keep_their_own(machine: RVizMachine) -> None:
    rviz = machine.open()
    wrong = {
        "Class": "rviz_default_plugins/Grid", "Name": 5, "Cell Size": "wide", "Plane": "QQ", "Color": [1], "Alpha": {"a": 1},
        "Offset": {"X": "nan"}, "Plane Cell Count": 10**30, "Line Style": {"Value": 3},
    }  # fmt: skip
    machine.do(lambda: rviz.load_config({"Visualization Manager": {"Displays": [wrong, "text", None]}}))
    (grid,) = rviz.displays
    assert grid.name == "5"
    assert grid.child("Cell Size").value == 1.0 and grid.child("Plane").value == "XY"
    assert grid.child("Offset").value == (0.0, 0.0, 0.0)
    assert rviz.scene.lines


def test_the_options_of_the_command_line(machine: RVizMachine, tmp_path: Path) -> None:
    rviz = machine.open("-f", "odom", "-t", "{NAMESPACE} - {CONFIG_FILENAME}", "--ros-args", "-r", "__node:=rviz2")
    assert rviz.fixed_frame == "odom"
    assert machine.display.windows[-1].title == "/ - default.rviz"
    names = machine.node.get_node_names()
    assert "rviz2" in names and any(name.startswith("transform_listener_impl_") for name in names)


@pytest.mark.parametrize(
    ("argument", "status", "said"),
    [("--help", 0, "3D visualization tool for ROS2"), ("--wrong", 1, "Unknown option 'wrong'.")],
)
def test_help_and_unknown_options(machine: RVizMachine, argument: str, status: int, said: str) -> None:
    running = machine.start("rviz2", "rviz2", argument, screen=True)
    assert running.program.status == status
    assert said in running.output + running.errors
    assert not machine.display.windows


def test_the_node_is_called_rviz_as_in_reality(machine: RVizMachine) -> None:
    machine.open()
    assert "rviz" in machine.node.get_node_names()


def test_without_a_screen_it_tells_what_it_would_show(machine: RVizMachine) -> None:
    running = machine.start("rviz2", "rviz2")
    machine.advance(3.0)
    assert running.output.splitlines() == [
        "Fixed Frame: map",
        "Global Status: Warn",
        "  Warn: Fixed Frame: No tf data.  Actual error: Frame [map] does not exist",
        "Grid (Grid)",
        "  Status: Ok",
        "    Ok: Transform: Ok",
    ]


def test_as_a_node_without_a_screen_it_logs_a_warning_and_then_an_error(machine: RVizMachine) -> None:
    running = machine.start("rviz2", "rviz2", background=True)
    machine.until(lambda: "[WARN]" in running.errors)
    machine.transform("odom", "base_link")
    machine.until(lambda: "[ERROR]" in running.errors or running.program.status is not None)
    assert running.errors.endswith("[rviz]: Global Status: Fixed Frame: Frame [map] does not exist\n")


def test_the_tutorials_line_opens_the_configuration_of_turtle_tf2_py(machine: RVizMachine) -> None:
    from ament_index_python.packages import get_package_share_directory

    rviz = machine.open("-d", f"{get_package_share_directory('turtle_tf2_py')}/rviz/turtle_rviz.rviz")
    assert rviz.fixed_frame == "world" and rviz.view.type == "TopDownOrtho" and rviz.message is None
    assert [display.type for display in rviz.displays] == ["Grid", "TF"]
