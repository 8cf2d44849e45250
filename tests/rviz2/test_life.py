"""How RViz starts, waits, follows the clock, and ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosgraph_msgs.msg import Clock

from day6_urdf import shipped_model
from tests.rviz2.rviz_machine import lines

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine


def test_closing_the_window_ends_it_without_a_word(machine: RVizMachine) -> None:
    machine.open()
    window = machine.display.windows[-1]
    window.close_by_user()
    machine.settle()
    assert machine.running is not None
    assert machine.running.program.status == 0 and machine.running.errors == ""
    assert "rviz" not in machine.node.get_node_names()


def test_ctrl_c_ends_it_as_a_node_in_cpp(machine: RVizMachine) -> None:
    machine.open()
    assert machine.running is not None
    machine.running.program.interrupt()
    machine.settle()
    assert machine.running.program.status == 0 and not machine.display.windows
    assert machine.running.log == ["[INFO] [rclcpp]: signal_handler(SIGINT/SIGTERM)"]


def test_nothing_is_drawn_again_while_nothing_happens(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.add("TF")
    machine.fix("base_link")
    machine.advance(3.0)
    version, scene = rviz.version, rviz.scene
    machine.advance(10.0)
    assert rviz.version == version and rviz.scene is scene


def test_scenes_come_as_often_as_the_frame_rate_says(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.start("day6_bot", "wheel_spinner")
    machine.add("TF")
    machine.fix("base_link")
    rviz.edit(rviz.frame_rate, 5)
    machine.advance(2.0)
    version = rviz.version
    machine.advance(4.0)
    assert 18 <= rviz.version - version <= 21


def test_a_user_is_answered_while_the_world_stands_still(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.advance(2.0)
    rviz.edit(rviz.fixed, "odom")
    machine.advance(0.0)
    assert rviz.fixed_frame == "odom"


def test_time_that_goes_back_resets_it(machine: RVizMachine) -> None:
    rviz = machine.open("--ros-args", "-p", "use_sim_time:=true")
    machine.transform("base_link", "arm", static=False)
    machine.publish("/clock", Clock(clock=machine.stamp(50_000_000_000)))
    assert "base_link" in rviz.frames.names()
    machine.publish("/clock", Clock(clock=machine.stamp(10_000_000_000)))
    machine.settle(1.5)
    assert machine.running is not None
    assert "[WARN] [rviz]: Detected jump back in time. Resetting RViz." in machine.running.log
    assert rviz.frames.names() == [] or rviz.frames.pose("arm") is None


def test_the_time_panel_tells_the_node_s_time(machine: RVizMachine) -> None:
    rviz = machine.open()
    rviz.time.expanded = True
    machine.advance(2.0)
    first = float(rviz.time.child("ROS Time").text)
    machine.advance(5.0)
    assert float(rviz.time.child("ROS Time").text) - first > 3.5
    assert float(rviz.time.child("ROS Elapsed").text) > 3.5


def test_a_display_that_is_switched_off_stops_listening(machine: RVizMachine) -> None:
    rviz = machine.open()
    display = machine.add("Odometry", "/odom")
    assert machine.node.count_subscribers("/odom") == 1
    rviz.edit(display, False)
    machine.settle()
    assert machine.node.count_subscribers("/odom") == 0 and lines(display) == {}
    rviz.edit(display, True)
    machine.settle()
    assert machine.node.count_subscribers("/odom") == 1
    machine.do(lambda: rviz.remove_display(display))
    assert machine.node.count_subscribers("/odom") == 0


def test_another_quality_of_service_subscribes_anew(machine: RVizMachine) -> None:
    rviz = machine.open()
    display = machine.add("LaserScan", "/scan")
    rviz.edit(display.child("Topic", "Reliability Policy"), "Best Effort")
    machine.settle()
    (info,) = machine.node.get_subscriptions_info_by_topic("/scan")
    assert info.qos_profile.reliability.name == "BEST_EFFORT"
    assert info.qos_profile.depth in (0, 5)


def test_trails_follow_a_link_that_moves(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("map", "base_link", static=False)
    display = machine.robot()
    rviz.edit(display.child("Links", "base_link", "Show Trail"), True)
    before = len(rviz.scene.lines)
    for x in range(1, 6):
        machine.transform("map", "base_link", (x / 10, 0, 0), static=False)
    assert len(rviz.scene.lines) == before + 1
    assert rviz.scene.lines[-1].vertices[-1][0] == 0.5


def test_the_tree_of_links_and_joints(machine: RVizMachine) -> None:
    rviz = machine.open()
    display = machine.robot(shipped_model().read_text(encoding="utf-8"))
    links = display.child("Links")
    options = 5
    assert [each.name for each in links.children[options:]] == ["base_link", "caster", "left_wheel", "right_wheel"]
    rviz.edit(links.child("Link Tree Style"), "Joints in Alphabetic Order")
    machine.settle()
    assert [each.name for each in links.children[options:]] == ["caster_joint", "left_wheel_joint", "right_wheel_joint"]
    rviz.edit(links.child("Link Tree Style"), "Tree of links and joints")
    machine.settle()
    assert links.child("base_link", "left_wheel_joint", "left_wheel").value is True
    rviz.edit(links.child("All Links Enabled"), False)
    machine.settle()
    assert not rviz.scene.shapes
    rviz.edit(links.child("base_link", "caster_joint", "caster"), True)
    machine.settle()
    assert [shape.name for shape in rviz.scene.shapes] == ["caster"]
    assert links.child("All Links Enabled").value is False
