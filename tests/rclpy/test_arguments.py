"""ROS arguments of a process and of a node: remap rules, parameters, parameter files, log levels; rcl's words for wrong ones."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rclpy._day6.parameter_files import ParameterTextError, assigned_value
from rclpy.context import Context
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException
from rclpy.node import Node
from rclpy.utilities import remove_ros_args


def parameters_by(world: Any, arguments: list[str], name: str = "robot", namespace: str = "/lab") -> dict[str, Any]:
    """Return the parameters a node gets by these arguments, apart from those every node has."""
    node = world.node(
        name,
        namespace=namespace,
        cli_args=["--ros-args", *arguments],
        automatically_declare_parameters_from_overrides=True,
    )
    own = ("use_sim_time", "start_type_description_service")
    return {key: each.value for key, each in node.get_parameters_by_prefix("").items() if key not in own}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("5", 5),
        ("+5", 5),
        ("-5", -5),
        ("0x1F", 31),
        ("-0X1f", -31),
        ("010", 8),
        ("0", 0),
        ("9223372036854775807", 2**63 - 1),
        ("-9223372036854775808", -(2**63)),
        ("9223372036854775808", 9223372036854775808.0),
        ("08", 8.0),
        ("1.5", 1.5),
        ("-1.5e3", -1500.0),
        ("1e5", 100000.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("0x1.8p1", 3.0),
        (".inf", float("inf")),
        ("-.INF", float("-inf")),
        ("inf", float("inf")),
        ("1e400", "1e400"),
        ("1e-400", "1e-400"),
        ("1e-308", "1e-308"),
        ("2.3e-308", 2.3e-308),
        ("0e0", 0.0),
        ("1_000", "1_000"),
        ("true", True),
        ("True", True),
        ("TRUE", True),
        ("yes", True),
        ("Yes", True),
        ("YES", True),
        ("on", True),
        ("On", True),
        ("ON", True),
        ("y", True),
        ("Y", True),
        ("false", False),
        ("False", False),
        ("FALSE", False),
        ("no", False),
        ("No", False),
        ("NO", False),
        ("off", False),
        ("Off", False),
        ("OFF", False),
        ("n", False),
        ("N", False),
        ("tRUE", "tRUE"),
        ("word", "word"),
        ("two words", "two words"),
        ("'5'", "5"),
        ('"true"', "true"),
        ("!!str 5", "5"),
        ("a:b", "a:b"),
        ("http://host/x", "http://host/x"),
        ("[1, 2, 3]", [1, 2, 3]),
        ("[1.5, 2.0]", [1.5, 2.0]),
        ("[true, no]", [True, False]),
        ("[a, 'b c']", ["a", "b c"]),
        ("[[1, 2], [3]]", [3]),
    ],
)
def test_a_value_on_the_command_line_is_read_as_yaml_in_c(world: Any, text: str, value: Any) -> None:
    found = parameters_by(world, ["-p", f"x:={text}"])
    assert found == {"x": value}
    assert type(found["x"]) is type(value)


@pytest.mark.parametrize("name", ["kilted", "lyrical"])
@pytest.mark.parametrize(
    ("text", "plain", "tagged"),
    [
        ("!!str true", "true", "true"),
        ("!!bool yes", True, True),
        ('!!bool "yes"', "yes", True),
        ("!!int 0", 0, 0),
        ("!!float 10", 10, 10.0),
        ("[!!float 1, 2.5]", None, [1.0, 2.5]),
        ("!!seq [10, 0, -10]", [10, 0, -10], [10, 0, -10]),
        ("!!int yes", True, None),
        ("!!float word", "word", None),
        ("!thing 5", 5, 5),
    ],
)
def test_tags_say_the_type_of_a_value_in_lyrical(
    in_distribution: Callable[[str], None], name: str, text: str, plain: Any, tagged: Any
) -> None:
    in_distribution(name)
    expected = tagged if name == "lyrical" else plain
    if expected is None:
        with pytest.raises(ParameterTextError):
            assigned_value(text)
    else:
        assert assigned_value(text) == expected
        assert type(assigned_value(text)) is type(expected)


@pytest.mark.parametrize("text", [".nan", "nan"])
def test_what_is_no_number_may_be_a_value(world: Any, text: str) -> None:
    value = parameters_by(world, ["-p", f"x:={text}"])["x"]
    assert isinstance(value, float)
    assert value != value


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["-p", "x:=[1, a]"], "Sequence should be of same type. Value type 'string' do not belong at line_num 1"),
        (["-p", "x:=[1, 2.0]"], "Sequence should be of same type. Value type 'double' do not belong at line_num 1"),
        (["-p", "x:=[a, 1]"], "Sequence should be of same type. Value type 'integer' do not belong at line_num 1"),
        (["-p", "x:=[a, true]"], "Sequence should be of same type. Value type 'bool' do not belong at line_num 1"),
        (["-p", "x:={a: 1}"], "Unknown YAML event"),
        (["-p", "x:=[1"], "Error parsing an event"),
        (["-p", "x:=[]"], ""),
        (["-p", "x"], "Expected lexeme type"),
        (["-p", "x:="], "error not set"),
        (["-p", "*:=1"], r"Wildcard '\*' is not implemented"),
        (["-p", "**:=1"], r"Wildcard '\*\*' is not implemented"),
        (["-p", ":=1"], "Expecting token or wildcard"),
        (["-p", "a.:=1"], "Expecting token or wildcard"),
        (["-p", "a b:=1"], "Expected lexeme type"),
        (["-r", "x"], "Expected lexeme type"),
        (["-r", "x:="], "error not set"),
        (["-r", "x:=1y"], "error not set"),
        (["-r", "*:=y"], r"Wildcard '\*' is not implemented"),
        (["-r", "a/**:=y"], r"Wildcard '\*\*' is not implemented"),
        (["-r", r"x:=\1"], "Backreferences are not implemented"),
        (["-r", "__node:=/x"], r"Expected lexeme type 18, got 19 at index 8"),
        (["-r", "__node:=a/b"], r"Expected lexeme type 1, got 19 at index 9"),
        (["-r", "__ns:=x"], r"Expected lexeme type 19, got 18 at index 6"),
        (["-r", "x:y:z:=w"], "Expected lexeme type"),
        (["-r", "a:=b:c"], "Expected lexeme type"),
        (["--params-file", "/no/such/file"], "Error opening YAML file"),
        (["--log-level", "loud"], "Argument does not use a valid severity level"),
        (["--log-level", "x:=loud"], "Argument does not use a valid severity level"),
        (["--log-level", ":=info"], "Argument has an invalid logger item that name is empty"),
        (["--log-level", "x:=info:=debug"], "Expected lexeme type"),
        (["-r"], "Couldn't parse trailing -r flag. No remap rule found."),
        (["-p"], "Couldn't parse trailing -p flag. No parameter override rule found."),
        (["--remap"], "Couldn't parse trailing --remap flag. No remap rule found."),
        (["--params-file"], "Couldn't parse trailing --params-file flag. No file path provided."),
        (["--log-level"], "Couldn't parse trailing log level flag: '--log-level'. No log level provided."),
        (["-e"], "Couldn't parse trailing -e flag. No enclave path provided."),
        (["--log-file-name"], "Couldn't parse trailing --log-file-name flag. No string prefix provided."),
        (["-e", "x"], "Enclave name is not valid: 'context name must be absolute"),
    ],
)
def test_wrong_arguments_are_refused_in_rcls_words(arguments: list[str], reason: str) -> None:
    context = Context()
    if not reason:
        context.init(["--ros-args", *arguments])
        context.shutdown()
        return
    with pytest.raises(RuntimeError, match=reason):
        context.init(["--ros-args", *arguments])
    assert not context.ok()


def test_unknown_arguments_are_named() -> None:
    with pytest.raises(RuntimeError, match=r"\['--wrong', 'more'\]"):
        Context().init(["prog", "own", "--ros-args", "--wrong", "-p", "a:=1", "more", "--", "own too"])


def test_a_nodes_own_arguments_are_refused_in_other_words(world: Any) -> None:
    with pytest.raises(RuntimeError, match="Failed to parse ROS arguments: Couldn't parse remap rule: '-r x'"):
        world.node("n", cli_args=["--ros-args", "-r", "x"])
    with pytest.raises(RuntimeError, match="--wrong"):
        world.node("n", cli_args=["--ros-args", "--wrong"])


@pytest.mark.parametrize(
    ("arguments", "kept"),
    [
        (["prog", "a", "--ros-args", "-p", "x:=1", "--", "b"], ["prog", "a", "b"]),
        (["prog", "--ros-args", "-r", "a:=b"], ["prog"]),
        (["prog", "--", "b"], ["prog", "--", "b"]),
        (["prog", "--ros-args", "--", "b", "--ros-args", "-r", "a:=b", "--", "c"], ["prog", "b", "c"]),
        ([], []),
    ],
)
def test_what_is_left_without_ros_arguments(arguments: list[str], kept: list[str]) -> None:
    assert remove_ros_args(arguments) == kept


def test_arguments_are_texts() -> None:
    for use in (remove_ros_args, lambda args: Context().init(args)):
        with pytest.raises(TypeError):
            use(["prog", 5])  # type: ignore[list-item]


# remapping


@pytest.mark.parametrize(
    ("rules", "name", "topic", "service"),
    [
        (["chatter:=news"], "chatter", "/lab/news", "/lab/news"),
        (["chatter:=/news"], "chatter", "/news", "/news"),
        (["/lab/chatter:=news"], "chatter", "/lab/news", "/lab/news"),
        (["/chatter:=news"], "chatter", "/lab/chatter", "/lab/chatter"),
        (["~/chatter:=news"], "~/chatter", "/lab/news", "/lab/news"),
        (["chatter:=~/news"], "chatter", "/lab/robot/news", "/lab/robot/news"),
        (["chatter:=a", "chatter:=b"], "chatter", "/lab/a", "/lab/a"),
        (["chatter:=a", "a:=b"], "chatter", "/lab/a", "/lab/a"),
        (["robot:chatter:=news"], "chatter", "/lab/news", "/lab/news"),
        (["other:chatter:=news"], "chatter", "/lab/chatter", "/lab/chatter"),
        (["rostopic://chatter:=news"], "chatter", "/lab/news", "/lab/chatter"),
        (["rosservice://chatter:=news"], "chatter", "/lab/chatter", "/lab/news"),
        (["a/b:=c/d"], "a/b", "/lab/c/d", "/lab/c/d"),
        (["a:=c"], "a/b", "/lab/a/b", "/lab/a/b"),
    ],
)
def test_rules_rename_topics_and_services(world: Any, rules: list[str], name: str, topic: str, service: str) -> None:
    arguments = ["--ros-args", *(word for rule in rules for word in ("-r", rule))]
    node = world.node("robot", namespace="lab", cli_args=arguments)
    assert node.resolve_topic_name(name) == topic
    assert node.resolve_service_name(name) == service
    for resolve in (node.resolve_topic_name, node.resolve_service_name):
        assert resolve(name, only_expand=True) == node.resolve_topic_name(name, only_expand=True)
    assert node.resolve_topic_name("chatter", only_expand=True) == "/lab/chatter"


@pytest.mark.parametrize(
    ("rules", "full"),
    [
        (["__node:=new"], "/lab/new"),
        (["__name:=new"], "/lab/new"),
        (["__ns:=/a/b"], "/a/b/robot"),
        (["__ns:=/"], "/robot"),
        (["robot:__node:=new"], "/lab/new"),
        (["other:__node:=new"], "/lab/robot"),
        (["__node:=one", "__node:=two"], "/lab/one"),
        (["__node:=new", "robot:__ns:=/x"], "/lab/new"),
        (["new:__ns:=/x", "__node:=new"], "/x/new"),
    ],
)
def test_rules_rename_nodes(world: Any, rules: list[str], full: str) -> None:
    arguments = ["--ros-args", *(word for rule in rules for word in ("--remap", rule))]
    assert world.node("robot", namespace="lab", cli_args=arguments).get_fully_qualified_name() == full


def test_a_nodes_own_rules_go_before_those_of_the_process() -> None:
    context = Context()
    context.init(["prog", "--ros-args", "-r", "a:=global", "-r", "b:=global", "-p", "x:=1", "-p", "y:=1"])
    own = ["--ros-args", "-r", "a:=own", "-p", "x:=2"]
    node = Node("n", context=context, cli_args=own, automatically_declare_parameters_from_overrides=True)
    assert (node.resolve_topic_name("a"), node.resolve_topic_name("b")) == ("/own", "/global")
    assert (node.get_parameter("x").value, node.get_parameter("y").value) == (2, 1)
    alone = Node("n", context=context, use_global_arguments=False)
    assert alone.resolve_topic_name("a") == "/a"
    context.shutdown()


def test_the_old_syntax_of_rules_still_works() -> None:
    context = Context()
    context.init(["prog", "chatter:=news", "not a rule:=", "--ros-args", "-r", "a:=b"])
    node = Node("n", context=context)
    assert node.resolve_topic_name("chatter") == "/news"
    assert node.resolve_topic_name("a") == "/b"
    context.shutdown()


# parameters for nodes


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["-p", "a:=1", "-p", "b.c:=x"], {"a": 1, "b.c": "x"}),
        (["--param", "robot:a:=1", "--param", "other:a:=2"], {}),
        (["-p", "a/b:=1"], {"a/b": 1}),
        (["-p", "a:=1", "-p", "a:=2"], {"a": 2}),
        (["-p", "a:=1", "-p", "a:=x"], {"a": 1}),
        (["-p", "a:=x", "-p", "a:=1"], {"a": 1}),
        (["-p", "a:=1.5", "-p", "a:=true"], {"a": True}),
        (["-p", "a:=[1]", "-p", "a:=x"], {"a": "x"}),
        (["-p", "a:=[x]", "-p", "a:=[1.5]", "-p", "a:=[2]"], {"a": [2]}),
    ],
)
def test_arguments_set_parameters_of_nodes(world: Any, arguments: list[str], expected: dict[str, Any]) -> None:
    assert parameters_by(world, arguments) == expected


@pytest.mark.parametrize(
    ("pattern", "meant"),
    [
        ("/lab/robot", True),
        ("lab/robot", True),
        ("robot", False),
        ("/robot", False),
        ("/**", True),
        ("/**/robot", True),
        ("/*/robot", True),
        ("/lab/*", True),
        ("/lab/**", True),
        ("/*", False),
        ("/*/*", True),
        ("/*/*/*", False),
        ("/**/other", False),
        ("/lab/robots", False),
        ("/lab/robo", False),
    ],
)
def test_a_pattern_in_a_file_means_some_nodes(world: Any, tmp_path: Path, pattern: str, meant: bool) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(f"{pattern}:\n  ros__parameters:\n    a: 1\n", encoding="utf-8")
    assert parameters_by(world, ["--params-file", str(path)]) == ({"a": 1} if meant else {})


FILES: list[tuple[str, dict[str, Any]]] = [
    ("/**:\n  ros__parameters:\n    a: 1\n    b: {c: 2, d: {e: x}}\n", {"a": 1, "b.c": 2, "b.d.e": "x"}),
    ("/lab:\n  robot:\n    ros__parameters: {a: 1}\n", {"a": 1}),
    ("/lab:\n  '*':\n    ros__parameters: {a: 1}\n", {"a": 1}),
    ("/lab:\n  robot: {ros__parameters: {a: 1}}\n  other: {ros__parameters: {a: 2}}\n", {"a": 1}),
    ("/**: {ros__parameters: {a: 1, b: 1}}\n/lab/robot: {ros__parameters: {a: 2}}\n", {"a": 2, "b": 1}),
    ("/lab/robot: {ros__parameters: {a: 2}}\n/**: {ros__parameters: {a: 1, b: 1}}\n", {"a": 1, "b": 1}),
    ("/**: {ros__parameters: {a: [1, 2], b: [x, 'y z'], c: [0.5]}}\n", {"a": [1, 2], "b": ["x", "y z"], "c": [0.5]}),
    (
        "/**: {ros__parameters: {a: 010, b: 0x10, c: yes, d: '7', e: 1e3}}\n",
        {"a": 8, "b": 16, "c": True, "d": "7", "e": 1000.0},
    ),
    ("/**:\n  ros__parameters:\n    a: |\n      two\n      lines\n", {"a": "two\nlines\n"}),
    ("# nothing\n", {}),
    ("/**: {ros__parameters: {}}\n", {}),
]


@pytest.mark.parametrize(("text", "expected"), FILES)
def test_a_file_sets_parameters_of_nodes(world: Any, tmp_path: Path, text: str, expected: dict[str, Any]) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(text, encoding="utf-8")
    assert parameters_by(world, ["--params-file", str(path)]) == expected


def test_what_is_read_later_goes_before(world: Any, tmp_path: Path) -> None:
    paths = [tmp_path / "1.yaml", tmp_path / "2.yaml"]
    for number, path in enumerate(paths, 1):
        path.write_text(f"/**: {{ros__parameters: {{a: {number}, only{number}: {number}}}}}\n", encoding="utf-8")
    files = [word for path in paths for word in ("--params-file", str(path))]
    assert parameters_by(world, files) == {"a": 2, "only1": 1, "only2": 2}
    assert parameters_by(world, [*files, "-p", "a:=3"])["a"] == 3
    assert parameters_by(world, ["-p", "a:=3", *files])["a"] == 2


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("/**: 5\n", "Cannot have a value before ros__parameters at line 1"),
        ("/**:\n  ros__parameters: 5\n", "Cannot have a value before ros__parameters at line 2"),
        ("ros__parameters:\n  a: 1\n", "There are no node names before ros__parameters at line 1"),
        ("[1, 2]\n", "Sequences cannot be key at line 1"),
        ("/**: [1]\n", "Sequences can only be values and not keys in params. Error at line 1"),
        ("/**:\n  ros__parameters:\n    [a]: 1\n", "Sequences cannot be key at line 3"),
        ("/**:\n  ros__parameters:\n    a: [1, x]\n", "of same type. Value type 'string' do not belong at line_num 3"),
        ("/**:\n  ros__parameters:\n    a:\n", "No value at line 3"),
        ("/**:\n  ros__parameters:\n    '': 1\n", "No key at line 3"),
        ("/**:\n  ros__parameters:\n    a: &x 1\n    b: *x\n", "Will not support aliasing at line 4"),
        ("/**:\n  ros__parameters: {a: 1\n", "Error parsing a event near line"),
        ("/a//b:\n  ros__parameters: {a: 1}\n", "// contains repeated forward slash"),
        ("/a-b:\n  ros__parameters: {a: 1}\n", "node name must not contain characters other than alphanumerics or '_'"),
        ("/1b:\n  ros__parameters: {a: 1}\n", "node name must not start with a number"),
    ],
)  # fmt: skip
def test_a_wrong_file_is_refused_with_its_line(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RuntimeError, match="Couldn't parse params file") as caught:
        Context().init(["--ros-args", "--params-file", str(path)])
    assert reason in str(caught.value)


def test_a_folder_is_no_parameter_file(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Couldn't parse params file: '--params-file"):
        Context().init(["--ros-args", "--params-file", str(tmp_path)])


# names of nodes


@pytest.mark.parametrize(
    ("name", "namespace", "error", "message"),
    [
        ("my node", "", InvalidNodeNameException, "Invalid node name: node name must not contain characters"),
        ("", "", InvalidNodeNameException, "Invalid node name: node name must not be empty"),
        ("1x", "", InvalidNodeNameException, "Invalid node name: node name must not start with a number"),
        ("n", "a/", InvalidNamespaceException, "Invalid namespace: namespace must not end with a '/'"),
        ("n", "/a//b", InvalidNamespaceException, "Invalid namespace: namespace must not contain repeated '/'"),
        (None, "", RuntimeError, "error creating node: name argument is null"),
        (5, "", TypeError, "incompatible constructor arguments"),
    ],
)
def test_a_wrong_name_of_a_node_is_refused(
    world: Any, name: Any, namespace: str, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        world.node(name, namespace=namespace)


@pytest.mark.parametrize(
    ("namespace", "full"), [(None, "/n"), ("", "/n"), ("/", "/n"), ("a", "/a/n"), ("/a", "/a/n"), ("/a/b", "/a/b/n")]
)
def test_a_namespace_is_made_absolute(world: Any, namespace: str | None, full: str) -> None:
    node = world.node("n", namespace=namespace)
    assert node.get_fully_qualified_name() == full
    assert node.get_name() == "n"
    assert node.get_namespace() == full[:-2] or (full, node.get_namespace()) == ("/n", "/")
    assert node.get_logger().name == full[1:].replace("/", ".")


def test_a_rule_in_the_old_syntax_works_and_is_warned_of(capfd: pytest.CaptureFixture[str]) -> None:
    from rclpy.context import Context
    from rclpy.node import Node

    context = Context()
    context.init(["program", "old:=new", "x=1"])
    told = capfd.readouterr().err
    assert told.count("Found remap rule") == 1
    assert "Found remap rule 'old:=new'. This syntax is deprecated. Use '--ros-args --remap old:=new' instead." in told
    assert "[WARN]" in told
    assert Node("n", context=context).resolve_topic_name("old") == "/new"
    context.shutdown()
