"""C++ programs whose arguments are wrong: the exception's class and text, SIGABRT, and what `ros2 run` says of it."""

from __future__ import annotations

import re

import pytest


def of_type(name: str, declared: str, given: str) -> str:
    return (
        f"parameter '{name}' has invalid type: Wrong parameter type, parameter {{{name}}} is of type {{{declared}}}, "
        f"setting it to {{{given}}} is not allowed."
    )


ENDS_IN_SLASH = "namespace must not end with a '/', unless only a '/'"
IN_INIT = "failed to initialize rcl: "
WRONG = {
    "a parameter file that is not there": (
        "--params-file no.yaml",
        "RCLInvalidROSArgsError",
        IN_INIT + "Couldn't parse params file: '--params-file no.yaml'. Error: Error opening YAML file, at …, at …",
    ),
    "a parameter file that is no YAML": (
        "--params-file bad.yaml",
        "RCLInvalidROSArgsError",
        IN_INIT
        + "Couldn't parse params file: '--params-file bad.yaml'. Error: Cannot have a value before ros__parameters"
        " at line 1, at …, at …",
    ),
    "a remap rule without :=": (
        "-r foo",
        "RCLInvalidROSArgsError",
        IN_INIT
        + "Couldn't parse remap rule: '-r foo'. Error: Expected lexeme type (19) not found, search ended at index 3, "
        "at …, at …",
    ),
    "a node name that none can have": (
        "-r __node:=a-b",
        "RCLInvalidROSArgsError",
        IN_INIT
        + "Couldn't parse remap rule: '-r __node:=a-b'. Error: Expected lexeme type (1) not found, search ended at "
        "index 9, at …, at …",
    ),
    "a namespace that none can have": (
        "-r __ns:=/a/",
        "RCLError",
        "failed to initialize rcl node: invalid node namespace: " + ENDS_IN_SLASH + ", at …, at …",
    ),
    "unknown words": ("--bogus -x", "UnknownROSArgsError", "found unknown ROS arguments: '--bogus', '-x'"),
    "nothing after -p": (
        "-p",
        "RCLInvalidROSArgsError",
        IN_INIT + "Couldn't parse trailing -p flag. No parameter override rule found., at …",
    ),
    "an enclave that none can have": (
        "-e nowhere",
        "RCLError",
        IN_INIT
        + "Enclave name is not valid: 'context name must be absolute, it must lead with a '/''. Invalid index: 0, "
        "at …",
    ),
    "a value of another type": (
        "-p background_r:=red",
        "InvalidParameterTypeException",
        of_type("background_r", "integer", "string"),
    ),
    "a value of another type in a file": (
        "--params-file typed.yaml",
        "InvalidParameterTypeException",
        of_type("holonomic", "bool", "integer"),
    ),
    "a value out of range": (
        "-p background_g:=-1",
        "InvalidParameterValueException",
        "parameter 'background_g' could not be set: Parameter {background_g} doesn't comply with integer range.",
    ),
    "simulated time that is no bool": (
        "-p use_sim_time:=maybe",
        "InvalidParameterTypeException",
        of_type("use_sim_time", "bool", "string"),
    ),
}


def without_places(text: str) -> str:
    """The text without file names and lines of rcl, which differ from build to build."""
    return re.sub(r"\bat /project/\S+:\d+", "at …", text)


def logged(text: str) -> str:
    return re.sub(r" \[\d+\.\d{9}\]", "", text)


@pytest.mark.parametrize(("words", "kind", "what"), WRONG.values(), ids=WRONG)
def test_turtlesim_ends_as_an_uncaught_exception_ends_a_program(machine, words, kind, what):
    (machine.cwd / "bad.yaml").write_text("a: {ros__parameters: [1\n", encoding="utf-8")
    (machine.cwd / "typed.yaml").write_text("turtlesim: {ros__parameters: {holonomic: 1}}\n", encoding="utf-8")
    result = machine.ros2("run", "turtlesim", "turtlesim_node", "--ros-args", *words.split())
    report = f"terminate called after throwing an instance of 'rclcpp::exceptions::{kind}'\n  what():  {what}\n"
    first = "[ERROR] [rcl]: Failed to parse global arguments\n" if "Couldn't parse" in what else ""
    assert logged(without_places(result.stderr)) == first + report
    assert (result.stdout, result.status) == ("[ros2run]: Aborted\n", 250)
    assert "/turtlesim" not in machine.ros2("node", "list").stdout


def test_without_ros2_run_the_program_is_killed_by_sigabrt(machine):
    from day6_core.ros.programs import load
    from day6_core.session.program import Program

    session = machine.session(["talker", "--ros-args", "--bogus"])
    program = Program(session, load("demo_nodes_cpp", "talker"))
    machine.step()
    assert (program.status, program.killed_by) == (134, 6)


def test_a_wrong_switch_of_the_type_service_is_logged_and_thrown(machine):
    arguments = ("--ros-args", "-p", "start_type_description_service:=5")
    result = machine.ros2("run", "demo_nodes_cpp", "talker", *arguments)
    name = "start_type_description_service"
    what = of_type(name, "bool", "integer")
    assert logged(result.stderr) == (
        f"[ERROR] [talker]: {what}\n"
        "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidParameterTypeException'\n"
        f"  what():  {what}\n"
    )


def test_the_blackboard_fails_as_the_original_does_for_parameters_that_every_node_declares(machine):
    run = ("run", "demo_nodes_cpp", "parameter_blackboard", "--ros-args", "-p")
    declared = machine.ros2(*run, "start_type_description_service:=false").stderr
    assert declared.endswith("  what():  parameter 'start_type_description_service' has already been declared\n")
    typed = machine.ros2(*run, "use_sim_time:=hello").stderr
    assert logged(typed) == (
        "[ERROR] [parameter_blackboard]: Invalid type 'string' for parameter 'use_sim_time', should be 'bool'\n"
        "terminate called after throwing an instance of 'std::invalid_argument'\n"
        "  what():  Invalid type for parameter 'use_sim_time', should be 'bool'\n"
    )


def test_the_arguments_are_read_before_the_program_looks_at_its_own(machine):
    result = machine.ros2("run", "tf2_ros", "tf2_echo", "only_one", "--ros-args", "-p", "3")
    assert "RCLInvalidROSArgsError" in result.stderr and "Usage" not in result.stdout
