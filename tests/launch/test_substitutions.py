"""Texts that are known only while launching."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext
from launch.conditions import (
    IfCondition,
    InvalidConditionExpressionError,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    UnlessCondition,
)
from launch.frontend.parse_substitution import VisitError, parse_substitution
from launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnonName,
    AnySubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    IfElseSubstitution,
    LaunchConfiguration,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PathJoinSubstitution,
    PathSubstitution,
    PythonExpression,
    StringJoinSubstitution,
    SubstitutionFailure,
    TextSubstitution,
    ThisLaunchFileDir,
)
from launch.utilities import perform_substitutions
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare


@pytest.fixture
def context() -> LaunchContext:
    made = LaunchContext()
    made.launch_configurations.update(robot="bot", sim="true", number="3")
    return made


ROBOT = LaunchConfiguration("robot")


@pytest.mark.parametrize(
    ("substitution", "text"),
    [
        (TextSubstitution(text="a b"), "a b"),
        (ROBOT, "bot"),
        (LaunchConfiguration(["ro", "bot"]), "bot"),
        (LaunchConfiguration("other", default="x"), "x"),
        (LaunchConfiguration("other", default=[ROBOT, "_2"]), "bot_2"),
        (LaunchConfiguration("other", default=5), "5"),
        (EnvironmentVariable("NOWHERE_SET", default_value=["x", ROBOT]), "xbot"),
        (PathJoinSubstitution(["a", ROBOT, "c.py"]), os.path.join("a", "bot", "c.py")),
        (PathJoinSubstitution(["a", [ROBOT, ".urdf"]]), os.path.join("a", "bot.urdf")),
        (PathSubstitution("a") / "b" / [ROBOT, ".py"], os.path.join("a", "b", "bot.py")),
        (StringJoinSubstitution(["a", [ROBOT, "s"]], delimiter=", "), "a, bots"),
        (PythonExpression(["1 + ", LaunchConfiguration("number")]), "4"),
        (PythonExpression(["'", ROBOT, "' == 'bot'"]), "True"),
        (PythonExpression("floor(pi)"), "3"),
        (PythonExpression("sys.byteorder in ('little', 'big')", ["sys"]), "True"),
        (NotSubstitution(LaunchConfiguration("sim")), "false"),
        (AndSubstitution("true", "0"), "false"),
        (OrSubstitution("false", "1"), "true"),
        (AnySubstitution("false", "true", "false"), "true"),
        (AllSubstitution("false", "true"), "false"),
        (EqualsSubstitution(ROBOT, "bot"), "true"),
        (EqualsSubstitution("1.0", 1), "true"),
        (EqualsSubstitution("True", True), "true"),
        (EqualsSubstitution(None, ""), "true"),
        (NotEqualsSubstitution(ROBOT, "bot"), "false"),
        (IfElseSubstitution(LaunchConfiguration("sim"), "yes", "no"), "yes"),
        pytest.param(Command("python3 -c 'print(6*7)'"), "42\n", marks=pytest.mark.process),
    ],
)
def test_a_substitution_gives_its_text(context: LaunchContext, substitution: Any, text: str) -> None:
    assert substitution.perform(context) == text


@pytest.mark.parametrize(
    ("text", "performed"),
    [
        ("$(string-join . https://docs ros org)", "https://docs.ros.org"),
        ("$(string-join ', ' a $(var robot)s)", "a, bots"),
        (
            "/$(path-join opt ros lyrical $(string-join . setup bash))",
            os.path.join("/opt", "ros", "lyrical", "setup.bash"),
        ),
        ("$(path-join a \"$(string-join - 'b' c)\")", os.path.join("a", "'b'-c")),
        ("$(string-join .)", TypeError),
        ("$(path-join)", TypeError),
    ],
)
@pytest.mark.parametrize("name", ["kilted", "lyrical"])
def test_lyrical_joins_in_launch_files(
    context: LaunchContext, in_distribution: Callable[[str], None], name: str, text: str, performed: Any
) -> None:
    in_distribution(name)
    if name == "lyrical" and isinstance(performed, str):
        assert perform_substitutions(context, parse_substitution(text)) == performed
    else:
        with pytest.raises(VisitError, match="Unknown substitution" if name == "kilted" else "expects at least"):
            parse_substitution(text)


@pytest.mark.parametrize(
    ("substitution", "message"),
    [
        (LaunchConfiguration("other"), "launch configuration 'other' does not exist"),
        (EnvironmentVariable("NOWHERE_SET"), "environment variable 'NOWHERE_SET' does not exist"),
        (FileContent("/no/such/file"), "File not found: /no/such/file"),
        (FindExecutable(name="no_such_program"), "executable 'no_such_program' not found on the PATH"),
        (ThisLaunchFileDir(), "ThisLaunchFileDir used outside of a launch file (in a script)"),
        (AnySubstitution("true", "maybe"), "Cannot convert value 'maybe' to '<class 'bool'>'"),
        (AllSubstitution("false", "maybe"), "Cannot convert value 'maybe' to '<class 'bool'>'"),
        (NotSubstitution("maybe"), "Cannot convert value 'maybe' to '<class 'bool'>'"),
        pytest.param(
            Command("python3 -c 'import sys; sys.exit(2)'"), "executed command failed", marks=pytest.mark.process
        ),
        pytest.param(
            Command("python3 -c 'import sys; sys.stderr.write(chr(97))'"),
            "executed command showed stderr output",
            marks=pytest.mark.process,
        ),
        pytest.param(Command("no_such_program x"), "file not found", marks=pytest.mark.process),
    ],
)
def test_a_substitution_without_a_text_says_why(context: LaunchContext, substitution: Any, message: str) -> None:
    with pytest.raises(SubstitutionFailure) as failure:
        substitution.perform(context)
    assert message in str(failure.value)


@pytest.mark.process
def test_what_a_command_says_on_stderr_may_be_taken_along(context: LaunchContext) -> None:
    line = "python3 -c 'import sys; sys.stderr.write(chr(97))'"
    assert Command(line, on_stderr="capture").perform(context) == "a"
    assert Command(line, on_stderr="ignore").perform(context) == ""


def test_the_environment_of_the_launch_is_asked(context: LaunchContext) -> None:
    context.environment["LAUNCH_TEST"] = "here"
    assert EnvironmentVariable("LAUNCH_TEST").perform(context) == "here"


def test_the_content_of_a_file(context: LaunchContext, tmp_path: Path) -> None:
    (tmp_path / "bot.txt").write_text("wheels")
    assert FileContent(PathJoinSubstitution([str(tmp_path), [ROBOT, ".txt"]])).perform(context) == "wheels"


def test_an_anonymous_name_stays_the_same_and_is_a_valid_node_name(context: LaunchContext) -> None:
    from rclpy.validate_node_name import validate_node_name

    name = AnonName("talker").perform(context)
    assert AnonName("talker").perform(context) == name
    assert AnonName("listener").perform(context) != name
    validate_node_name(name)


def test_packages_and_their_executables_are_found(context: LaunchContext) -> None:
    from ament_index_python.packages import get_package_share_directory

    share = get_package_share_directory("turtlesim")
    assert FindPackageShare("turtlesim").perform(context) == share
    found = ExecutableInPackage(executable="turtlesim_node", package="turtlesim").perform(context)
    assert Path(found).parts[-3:] == ("lib", "turtlesim", "turtlesim_node")
    with pytest.raises(SubstitutionFailure, match="executable 'turtle' not found on the libexec directory"):
        ExecutableInPackage(executable="turtle", package="turtlesim").perform(context)
    with pytest.raises(LookupError, match="package 'no_such_pkg' not found, searching:"):
        FindPackageShare("no_such_pkg").perform(context)


@pytest.mark.parametrize(
    ("text", "result"),
    [
        ("plain $ text", "plain $ text"),
        ("a $(var robot) b", "a bot b"),
        ("$(var robot)$(var number)", "bot3"),
        ("$(var missing default)", "default"),
        ("$(var missing 'two words')", "two words"),
        ('$(var missing "$(var robot) here")', "bot here"),
        ("$(var $(var missing robot))", "bot"),
        (r"\$(var robot)", "$(var robot)"),
        ("$(eval '1 + $(var number)')", "4"),
        ("$(eval 'sys.maxsize > 1' sys)", "True"),
        ("$(equals $(var robot) bot)", "true"),
        ("$(not $(var sim))", "false"),
        ("$(any false $(var sim))", "true"),
        ("$(if $(var sim) one two)", "one"),
        ("$(env NOWHERE_SET '')", ""),
    ],
)
def test_texts_of_xml_and_yaml_files_may_have_substitutions(context: LaunchContext, text: str, result: str) -> None:
    assert perform_substitutions(context, parse_substitution(text)) == result


@pytest.mark.parametrize("text", ["$(var robot", "$(var 'robot)", "$( var robot)", "$(nothing x)"])
def test_a_text_that_cannot_be_read_is_refused(text: str) -> None:
    with pytest.raises((ValueError, RuntimeError)):
        parse_substitution(text)


def test_conditions_read_true_and_false_in_any_case(context: LaunchContext) -> None:
    assert IfCondition(LaunchConfiguration("sim")).evaluate(context)
    assert IfCondition("True").evaluate(context)
    assert not IfCondition("0").evaluate(context)
    assert UnlessCondition("False").evaluate(context)
    with pytest.raises(InvalidConditionExpressionError) as problem:
        IfCondition("yes").evaluate(context)
    assert "expected one of [true, 1, false, 0] but got 'yes'" in str(problem.value)


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_conditions_compare_launch_configurations(context: LaunchContext) -> None:
    assert LaunchConfigurationEquals("robot", "bot").evaluate(context)
    assert LaunchConfigurationEquals("missing", None).evaluate(context)
    assert not LaunchConfigurationEquals("missing", "x").evaluate(context)
    assert LaunchConfigurationNotEquals("robot", "cat").evaluate(context)


def test_no_modules_in_an_expression_means_none(context: LaunchContext) -> None:
    assert perform_substitutions(context, parse_substitution('$(eval "1 + 1" "")')) == "2"
    with pytest.raises(NameError):
        perform_substitutions(context, parse_substitution('$(eval "ceil(1.3)" "")'))
