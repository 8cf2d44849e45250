"""`ros2 run`, `ros2 pkg`, `ros2 interface` on a stepped machine."""

from __future__ import annotations

import pytest


def test_run_starts_a_program_in_the_same_session(machine):
    run = machine.start("run", "turtlesim", "turtlesim_node", "--ros-args", "-r", "__node:=kame")
    run.step(0.1)
    assert "Spawning turtle [turtle1]" in run.stderr
    assert machine.ros2("node", "list").stdout == "/kame\n"
    run.interrupt()
    assert (run.status, run.stdout) == (0, "")
    assert machine.ros2("node", "list").stdout == ""


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["no_such_pkg", "talker"], "Package 'no_such_pkg' not found\n"),
        (["turtlesim", "turtlesim_nod"], "No executable found\n"),
        (["std_msgs", "String"], "No executable found\n"),
    ],
)
def test_run_of_what_is_not_there(machine, words, error):
    assert machine.ros2("run", *words) == ("", error, 1)


def test_a_program_that_fails_is_reported_by_run(machine):
    result = machine.ros2("run", "turtlesim", "turtlesim_node", "--ros-args", "-p", "foo")
    assert result.status == 250  # -SIGABRT, as a byte
    assert result.stdout == "[ros2run]: Aborted\n"
    assert "Traceback" not in result.stderr


def test_a_python_program_that_fails_is_reported_by_run(machine):
    result = machine.ros2("run", "demo_nodes_py", "talker", "--ros-args", "-p", "foo")
    assert (result.stdout, result.status) == ("[ros2run]: Process exited with failure 1\n", 1)


def test_pkg_finds_what_came_with_us(machine):
    assert "turtlesim\n" in machine.ros2("pkg", "list").stdout
    assert machine.ros2("pkg", "executables", "turtlesim").stdout == (
        "turtlesim draw_square\nturtlesim mimic\nturtlesim turtle_teleop_key\nturtlesim turtlesim_node\n"
    )
    prefix = machine.ros2("pkg", "prefix", "turtlesim").stdout.strip()
    assert machine.ros2("pkg", "prefix", "--share", "turtlesim").stdout == f"{prefix}/share/turtlesim\n"
    assert machine.ros2("pkg", "executables", "--full-path", "turtlesim").stdout.startswith(
        f"{prefix}/lib/turtlesim/draw_square\n"
    )
    assert machine.ros2("pkg", "executables", "std_msgs") == ("", "", 0)


def test_pkg_of_what_is_not_there(machine):
    assert machine.ros2("pkg", "prefix", "nope") == ("", "Package not found\n", 1)
    assert machine.ros2("pkg", "xml", "nope") == ("", "Package not found\n", 1)
    assert machine.ros2("pkg", "xml", "turtlesim", "-t", "nope") == ("", "XML tag not found\n", 1)
    assert machine.ros2("pkg", "executables", "nope") == ("", "Package 'nope' not found\n", 1)


def test_pkg_xml_shows_the_manifest_or_one_tag(machine):
    assert machine.ros2("pkg", "xml", "std_msgs").stdout.startswith("<package format=")
    assert machine.ros2("pkg", "xml", "std_msgs", "--tag", "name").stdout == "std_msgs\n"


def test_an_overlay_on_the_sessions_path_is_found_first(machine):
    index = machine.cwd / "install" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "mine").touch()
    script = machine.cwd / "install" / "lib" / "mine" / "go"
    script.parent.mkdir(parents=True)
    script.write_text("#!/bin/sh\n", encoding="utf-8")
    script.chmod(0o755)
    assert machine.ros2("pkg", "prefix", "mine").status == 1
    machine.env["AMENT_PREFIX_PATH"] = str(machine.cwd / "install")
    assert machine.ros2("pkg", "prefix", "mine").stdout == f"{machine.cwd / 'install'}\n"
    assert machine.ros2("pkg", "executables", "mine").stdout == "mine go\n"


def test_show_indents_nested_definitions_and_can_leave_comments_out(machine):
    text = machine.ros2("interface", "show", "--no-comments", "geometry_msgs/msg/TwistStamped").stdout
    assert text.splitlines()[:4] == [
        "std_msgs/Header header",
        "\tbuiltin_interfaces/Time stamp",
        "\t\tint32 sec",
        "\t\tuint32 nanosec",
    ]
    assert "\tVector3  linear\n\t\tfloat64 x\n" in text
    assert machine.ros2("interface", "show", "--no-comments", "std_srvs/srv/Empty").stdout == "---\n"
    assert "# " in machine.ros2("interface", "show", "std_srvs/srv/Empty").stdout
    shown = machine.ros2("interface", "show", "--all-comments", "geometry_msgs/msg/TwistStamped").stdout
    assert "\n\t# " in shown


def test_show_reads_the_name_from_standard_input(machine):
    result = machine.ros2("interface", "show", "-", stdin="std_msgs/msg/Bool\n")
    assert result.stdout.endswith("bool data\n")
    assert machine.ros2("interface", "show", "-").stderr.endswith(
        "ros2 interface show: error: the passed value is empty\n"
    )


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("String", "Invalid name 'String'. Expected three parts separated by '/'\n"),
        ("nope/msg/String", "Unknown package 'nope'\n"),
    ],
)
def test_show_of_what_is_not_there(machine, name, error):
    assert machine.ros2("interface", "show", name) == ("", error, 1)


def test_proto_is_ready_to_be_typed(machine):
    assert machine.ros2("interface", "proto", "std_srvs/srv/SetBool").stdout == '"data: false\n"\n'
    assert machine.ros2("interface", "proto", "std_msgs/msg/Strng") == (
        "",
        "AttributeError: module 'std_msgs.msg' has no attribute 'Strng'. Did you mean: 'String'?\n",
        1,
    )


def test_lists_of_interfaces(machine):
    assert machine.ros2("interface", "list", "-a").stdout.startswith("Actions:\n")
    assert (
        machine.ros2("interface", "package", "std_srvs").stdout
        == "std_srvs/srv/Empty\nstd_srvs/srv/SetBool\nstd_srvs/srv/Trigger\n"
    )
    assert machine.ros2("interface", "package", "nope") == ("", "Unknown package 'nope'\n", 1)
    assert "turtlesim\n" in machine.ros2("interface", "packages", "-a").stdout
