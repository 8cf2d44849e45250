"""`ros2 component`: containers, and what they load."""

from __future__ import annotations

import pytest


@pytest.fixture
def container(machine):
    return machine.run("rclcpp_components", "component_container")


def test_the_registered_types_are_listed(machine):
    listed = machine.ros2("component", "types").stdout
    assert "composition\n  composition::Talker\n  composition::Listener\n" in listed
    assert machine.ros2("component", "types", "composition").stdout.startswith("composition::Talker\n")
    assert machine.ros2("component", "types", "nope").stderr == "Unable to find package 'nope'\n"


def test_a_talker_and_a_listener_share_a_container(machine, container):
    loaded = machine.ros2("component", "load", "/ComponentManager", "composition", "composition::Talker")
    assert loaded.stdout == "Loaded component 1 into '/ComponentManager' container node as '/talker'\n"
    machine.ros2(
        *("component", "load", "/ComponentManager", "composition", "composition::Listener", "-n", "ear"),
        *("--node-namespace", "/head"),
    )
    assert machine.ros2("component", "list").stdout == "/ComponentManager\n  1  /talker\n  2  /head/ear\n"
    machine.step(2.0)
    assert "[talker]: Publishing: 'Hello World: 1'" in container.stderr.text
    echo = machine.ros2("topic", "list").stdout
    assert "/chatter\n" in echo and "/head/chatter\n" in echo


def test_a_library_is_loaded_once_from_where_it_is_in_real_ros(machine, container):
    for name, plugin in (("composition", "Talker"), ("image_tools", "Cam2Image"), ("image_tools", "ShowImage")):
        machine.ros2("component", "load", "/ComponentManager", name, f"{name}::{plugin}")
    assert [
        line.partition("Load Library: ")[2] for line in container.stderr.text.splitlines() if "Library" in line
    ] == [
        "/opt/ros/jazzy/lib/libtalker_component.so",
        "/opt/ros/jazzy/lib/libimage_tools.so",
    ]


def test_what_was_unloaded_is_gone(machine, container):
    machine.ros2("component", "load", "/ComponentManager", "composition", "composition::Server")
    assert machine.ros2("component", "unload", "/ComponentManager", "1").stdout == (
        "Unloaded component 1 from '/ComponentManager' container node\n"
    )
    assert "/Server" not in machine.ros2("node", "list").stdout
    again = machine.ros2("component", "unload", "/ComponentManager", "1")
    assert again.status == 1
    assert again.stderr == (
        "Failed to unload component 1 from '/ComponentManager' container node\n    No node found with unique_id: 1\n"
    )


def test_wrong_names_are_told(machine, container):
    assert machine.ros2("component", "load", "/x", "a", "b").stderr == "Unable to find container node '/x'\n"
    wrong_package = machine.ros2("component", "load", "/ComponentManager", "nope", "a")
    assert wrong_package.stderr == ("Failed to load component: Could not find requested resource in ament index\n")
    wrong_type = machine.ros2("component", "load", "/ComponentManager", "composition", "composition::Talk")
    assert wrong_type.stderr == ("Failed to load component: Failed to find class with the requested plugin name.\n")


def test_a_standalone_component_runs_until_ctrl_c(machine):
    command = machine.start("component", "standalone", "composition", "composition::Talker", "-c", "alone")
    command.step(2.5)
    assert "Hello World: 2" in command.stderr
    assert machine.ros2("component", "list", "/alone").stdout == "1  /talker\n"
    command.interrupt()
    assert command.status == 0
