"""Group: a folder of displays: switched together, moved in and out, and kept in the file with what is below it."""

from __future__ import annotations

from typing import Any

import yaml

from day6_core.ros.programs.rviz2.model.config import write_config
from day6_core.ros.programs.rviz2.rviz2 import panel_text
from tests.rviz2.rviz_machine import RVizMachine

NESTED = """\
Panels:
  - Class: rviz_common/Displays
    Name: Displays
    Property Tree Widget:
      Expanded:
        - /Planner1
        - /Planner1/Inner1
        - /Planner1/Inner1/Frames1
Visualization Manager:
  Class: ""
  Displays:
    - Class: rviz_common/Group
      Displays:
        - Class: rviz_default_plugins/Grid
          Enabled: true
          Name: Floor
          Value: true
        - Class: rviz_common/Group
          Displays:
            - Class: rviz_default_plugins/Axes
              Enabled: true
              Name: Frames
              Value: true
            - Class: nav2_rviz_plugins/ParticleCloud
              Enabled: true
              Name: Swarm
              Value: true
          Enabled: true
          Name: Inner
      Enabled: true
      Name: Planner
    - Class: rviz_common/Group
      Displays: ~
      Enabled: false
      Name: Empty
    - Class: rviz_default_plugins/Camera
      Enabled: true
      Name: Eye
      Topic:
        Value: /image
      Value: true
      Visibility:
        Planner:
          Floor: false
          Value: true
        Value: true
  Global Options:
    Fixed Frame: map
"""


def opened(machine: RVizMachine) -> Any:
    rviz = machine.open()
    machine.do(lambda: rviz.load_text(NESTED))
    machine.transform("map", "odom")
    return rviz


def shape(displays: Any) -> list[Any]:
    """Names with what is below them, and whether the box is set, as the file has them."""
    return [(each["Name"], each["Enabled"], *shape(each.get("Displays") or ())) for each in displays]


def test_groups_in_groups_are_read_shown_and_written(machine: RVizMachine) -> None:
    rviz = opened(machine)
    assert [each.name for each in rviz.displays] == ["Planner", "Floor", "Inner", "Frames", "Swarm", "Empty", "Eye"]
    assert [each.path for each in rviz.displays if each.expanded] == [
        "/root/Planner", "/root/Planner/Inner", "/root/Planner/Inner/Frames",
    ]  # fmt: skip
    assert rviz.scene.lines and rviz.scene.shapes
    saved, expected = yaml.safe_load(write_config(rviz.save())), yaml.safe_load(NESTED)
    displays = saved["Visualization Manager"]["Displays"]
    assert shape(displays) == shape(expected["Visualization Manager"]["Displays"])
    assert displays[0].keys() == {"Class", "Displays", "Enabled", "Name"} and displays[1]["Displays"] is None
    assert displays[2]["Visibility"]["Planner"]["Floor"] is False
    assert displays[2]["Visibility"]["Planner"]["Inner"] == {"Frames": True, "Swarm": True, "Value": True}
    expanded = saved["Panels"][0]["Property Tree Widget"]["Expanded"]
    assert {"/Planner1", "/Planner1/Inner1", "/Planner1/Inner1/Frames1"} <= set(expanded)


def test_the_box_of_a_group_switches_what_is_in_it_and_leaves_its_boxes(machine: RVizMachine) -> None:
    rviz = opened(machine)
    planner = rviz.displays[0]
    rviz.edit(planner, False)
    machine.settle()
    assert not rviz.scene.lines and not rviz.scene.shapes
    assert [owner for owner, _ in rviz.problems() if owner in ("Floor", "Swarm")] == []
    assert "    Swarm (ParticleCloud): disabled" in panel_text(rviz)
    saved = planner.save()
    assert shape([saved]) == [("Planner", False, ("Floor", True), ("Inner", True, ("Frames", True), ("Swarm", True)))]
    rviz.edit(planner, True)
    machine.settle()
    assert rviz.scene.lines and rviz.scene.shapes


def test_a_group_that_is_removed_takes_its_subscriptions_with_it(machine: RVizMachine) -> None:
    rviz = machine.open()
    group, cloud = machine.add("Group"), machine.add("PointCloud2", "/points")
    assert [each.name for each in rviz.outermost][-2:] == ["Group", "PointCloud2"]
    machine.do(lambda: rviz.move_display(cloud, -1))
    assert group.displays == [cloud] and cloud.subscription is not None
    machine.do(lambda: rviz.remove_display(group))
    assert cloud.subscription is None and cloud not in rviz.displays


def test_a_display_moves_into_an_open_group_and_out_at_its_ends(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.do(lambda: rviz.load_text("Visualization Manager: {Displays: []}"))
    first, group, last = machine.add("Grid"), machine.add("Group"), machine.add("Axes")

    def moved(display: Any, step: int) -> Any:
        machine.do(lambda: rviz.move_display(display, step))
        return shape(rviz.save()["Visualization Manager"]["Displays"])

    assert moved(first, 1) == [("Group", True, ("Grid", True)), ("Axes", True)]
    assert moved(last, -1) == [("Group", True, ("Grid", True), ("Axes", True))]
    assert moved(first, -1) == [("Grid", True), ("Group", True, ("Axes", True))]
    assert moved(last, 1) == [("Grid", True), ("Group", True), ("Axes", True)]
    assert moved(last, 1) == [("Grid", True), ("Group", True), ("Axes", True)]
    group.expanded = False
    assert moved(first, 1) == [("Group", True), ("Grid", True), ("Axes", True)]
    group.expanded = True
    machine.do(lambda: rviz.move_display(first, -1))
    copy = machine.do(lambda: rviz.duplicate_display(first))
    assert group.displays == [first, copy]
