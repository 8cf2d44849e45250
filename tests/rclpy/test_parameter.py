"""Parameters: types of values, declaring, getting, setting, descriptors with their ranges and steps, callbacks."""

from __future__ import annotations

import array
from pathlib import Path
from typing import Any

import pytest
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterValue,
    SetParametersResult,
)
from rcl_interfaces.msg import Parameter as ParameterMessage

from rclpy.exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import (
    Parameter,
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from tests.support.folded import folded

Type = Parameter.Type

VALUES: list[tuple[Any, Type, str]] = [
    (None, Type.NOT_SET, ""),
    (True, Type.BOOL, "bool_value"),
    (7, Type.INTEGER, "integer_value"),
    (0.5, Type.DOUBLE, "double_value"),
    ("word", Type.STRING, "string_value"),
    ([b"p", b"v"], Type.BYTE_ARRAY, "byte_array_value"),
    ([True, False], Type.BOOL_ARRAY, "bool_array_value"),
    ([1, -2], Type.INTEGER_ARRAY, "integer_array_value"),
    ([1.5, 2.5], Type.DOUBLE_ARRAY, "double_array_value"),
    (["a", "b"], Type.STRING_ARRAY, "string_array_value"),
]


@pytest.mark.parametrize(("value", "type_", "field"), VALUES)
def test_a_value_has_its_type_and_goes_into_a_message_and_back(value: Any, type_: Type, field: str) -> None:
    parameter = Parameter("p", value=value)
    assert (parameter.name, parameter.type_, parameter.value) == ("p", type_, value)
    message = parameter.to_parameter_msg()
    assert (message.name, message.value.type) == ("p", type_.value)
    if field:
        held = getattr(message.value, field)
        assert (list(held) if isinstance(value, list) else held) == value
    assert message.value == parameter.get_parameter_value()
    assert parameter_value_to_python(message.value) == value
    back = Parameter.from_parameter_msg(message)
    assert (back.name, back.type_) == ("p", type_)
    assert (list(back.value) if isinstance(value, list) else back.value) == value


def test_the_numbers_of_the_types_are_those_of_the_message() -> None:
    assert [type_.value for _, type_, _ in VALUES] == list(range(10))


@pytest.mark.parametrize(
    ("value", "type_"),
    [
        ([], Type.BYTE_ARRAY),
        ((1, 2), Type.INTEGER_ARRAY),
        (array.array("d", [1.0]), Type.DOUBLE_ARRAY),
        ([1, True], Type.INTEGER_ARRAY),
    ],
)
def test_sequences_of_other_kinds_have_types_too(value: Any, type_: Type) -> None:
    assert Type.from_parameter_value(value) == type_


@pytest.mark.parametrize("value", [{"a": 1}, object, [1, "a"], [1, 2.0], [None]])
def test_what_is_no_value_of_a_parameter_is_refused(value: Any) -> None:
    with pytest.raises(TypeError, match=r"The given value is not (a list of )?one of the allowed types"):
        Parameter("p", value=value)


@folded("type_, value, own, _field", ((type_, *each) for type_ in Type for each in VALUES))
def test_value_and_type_have_to_agree(type_: Type, value: Any, own: Type, _field: str) -> None:
    fits = type_ == own or (type_, own) in ((Type.INTEGER, Type.BOOL), (Type.INTEGER_ARRAY, Type.BOOL_ARRAY))
    assert type_.check(value) == fits
    if fits:
        assert Parameter("p", type_, value).value == value
    else:
        with pytest.raises(ValueError, match="do not agree"):
            Parameter("p", type_, value)


@pytest.mark.parametrize(
    ("type_", "value", "fits"),
    [
        (Type.BYTE_ARRAY, [b"ab"], False),
        (Type.BYTE_ARRAY, [b"a", b""], False),
        (Type.BYTE_ARRAY, [], True),
        (Type.STRING_ARRAY, [], True),
        (Type.INTEGER_ARRAY, array.array("q", [1]), True),
        (Type.DOUBLE_ARRAY, array.array("d", [1.0]), True),
        (Type.STRING_ARRAY, ("a",), True),
        (Type.INTEGER_ARRAY, 5, False),
        (Type.STRING_ARRAY, "word", False),
    ],
)
def test_arrays_fit_by_their_elements(type_: Type, value: Any, fits: bool) -> None:
    assert type_.check(value) is fits


def test_a_type_must_be_one() -> None:
    with pytest.raises(TypeError, match="type must be an instance of '<enum 'Type'>'"):
        Parameter("p", 2, 5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"^Type '1' and value '5' do not agree$"):
        Parameter("p", Type.BOOL, 5)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", True),
        ("5", 5),
        ("-0x1F", -31),
        ("0.5", 0.5),
        ("word", "word"),
        ("", ""),
        ("null", "null"),
        ("'5'", "5"),
        ("[1, 2]", [1, 2]),
        ("[true, false]", [True, False]),
        ("[0.5]", [0.5]),
        ("[a, b]", ["a", "b"]),
        ("[1, a]", "[1, a]"),
        ("[1, 2.0]", "[1, 2.0]"),
        ("[a: b", "[a: b"),
    ],
)
def test_a_text_stands_for_what_yaml_reads_in_it(text: str, value: Any) -> None:
    assert parameter_value_to_python(get_parameter_value(text)) == value


def test_a_type_that_there_is_not_has_no_value() -> None:
    with pytest.raises(RuntimeError, match="unexpected parameter type 17"):
        parameter_value_to_python(ParameterValue(type=17))


# declaring


@pytest.mark.parametrize(("value", "type_", "_field"), VALUES[1:])
def test_a_declared_parameter_has_its_default(world: Any, value: Any, type_: Type, _field: str) -> None:
    node = world.node("n")
    assert not node.has_parameter("p")
    assert node.declare_parameter("p", value).value == value
    assert node.has_parameter("p")
    parameter = node.get_parameter("p")
    assert (parameter.type_, parameter.value) == (type_, value)
    assert node.get_parameter_type("p") == type_.value
    descriptor = node.describe_parameter("p")
    assert (descriptor.name, descriptor.type, descriptor.dynamic_typing) == ("p", type_.value, False)


def test_several_parameters_are_declared_in_a_namespace(world: Any) -> None:
    node = world.node("n")
    declared = node.declare_parameters("arm", [("speed", 2), ("name", "left", ParameterDescriptor(description="d"))])
    assert [(each.name, each.value) for each in declared] == [("arm.speed", 2), ("arm.name", "left")]
    assert node.describe_parameter("arm.name").description == "d"
    assert [each.name for each in node.declare_parameters("", [("plain", 1)])] == ["plain"]


def test_an_override_goes_before_the_default_unless_it_is_ignored(world: Any) -> None:
    overrides = [Parameter("a", value=5), Parameter("b", value=6), Parameter("c", value=1.5)]
    node = world.node("n", parameter_overrides=overrides)
    assert node.declare_parameter("a", 1).value == 5
    assert node.declare_parameter("b", 1, ignore_override=True).value == 1
    assert node.declare_parameter("c", Type.DOUBLE).value == 1.5
    assert not node.has_parameter("d")


def test_overrides_declare_parameters_where_the_node_wants_that(world: Any) -> None:
    overrides = [Parameter("a", value=5), Parameter("b.c", value="x")]
    node = world.node("n", parameter_overrides=overrides, automatically_declare_parameters_from_overrides=True)
    assert (node.get_parameter("a").value, node.get_parameter("b.c").value) == (5, "x")
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"Parameter\(s\) already declared: \['a'\]"):
        node.declare_parameter("a", 1)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (("", 1), InvalidParameterException, "^Invalid parameter name: $"),
        ((5, 1), TypeError, "First element 5 at index 0 in parameters list is not a str."),
        (("p", Type.NOT_SET), ValueError, "Cannot declare parameter {p} as statically typed of type NOT_SET"),
        (
            ("p", Type.INTEGER, ParameterDescriptor(dynamic_typing=True)),
            ValueError,
            "`dynamic_typing=True` is not allowed when the parameter type is provided",
        ),
        (
            ("p", None, ParameterDescriptor()),
            ValueError,
            "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET",
        ),
        (("p", 1, "descriptor"), TypeError, "Third element descriptor at index 0 in parameters list is not a"),
        (
            ("wanted", "text"),
            InvalidParameterTypeException,
            "Trying to set parameter 'wanted' to '5' of type 'INTEGER', expecting type 'STRING': wanted",
        ),
        (
            ("p", 11, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10)])),
            InvalidParameterValueException,
            r"Invalid parameter value \(11\) for parameter. Reason: Parameter p out of range. Min: 0, Max: 10, value: 11: p",
        ),
    ],
)
def test_a_declaration_that_cannot_be_is_refused(
    world: Any, arguments: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    node = world.node("n", parameter_overrides=[Parameter("wanted", value=5)])
    with pytest.raises(error, match=message):
        node.declare_parameter(*arguments)
    assert not node.has_parameter("p")


@pytest.mark.parametrize("entry", [(), ("p", 1, ParameterDescriptor(), 4)])
def test_a_declaration_has_one_to_three_parts(world: Any, entry: tuple[Any, ...]) -> None:
    with pytest.raises(TypeError, match="Invalid parameter tuple length at index 1 in parameters list:"):
        world.node("n").declare_parameters("", [("first", 1), entry])


def test_a_parameter_is_declared_once(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"^Parameter\(s\) already declared: \['p'\]$"):
        node.declare_parameters("", [("q", 1), ("p", 1)])
    assert not node.has_parameter("q")


def test_a_name_alone_makes_a_parameter_of_any_type_with_a_warning(world: Any) -> None:
    node = world.node("n")
    with pytest.warns(UserWarning, match="declaring a parameter only providing its name is deprecated"):
        node.declare_parameter("p")
    assert node.get_parameter("p").type_ == Type.NOT_SET
    assert node.describe_parameter("p").dynamic_typing
    for value in (5, "x", None):
        assert node.set_parameters([Parameter("p", value=value)])[0].successful
    assert not node.has_parameter("p")


def test_a_parameter_declared_by_type_has_no_value_yet(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", Type.INTEGER)
    with pytest.raises(ParameterUninitializedException, match="The parameter 'p' is not initialized: p"):
        node.get_parameter("p")
    assert node.get_parameter_or("p", Parameter("p", value=3)).value == 3
    assert node.set_parameters([Parameter("p", value=4)])[0].successful
    assert node.get_parameter("p").value == 4
    assert node.get_parameter_or("p", Parameter("p", value=3)).value == 4


def test_a_parameter_is_forgotten_when_it_is_undeclared(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    node.undeclare_parameter("p")
    assert not node.has_parameter("p")
    with pytest.raises(ParameterNotDeclaredException, match=r"Invalid access to undeclared parameter\(s\): p"):
        node.undeclare_parameter("p")
    with pytest.raises(ParameterNotDeclaredException):
        node.describe_parameter("p")
    with pytest.raises(ParameterImmutableException, match="Attempted to modify read-only parameter: fixed"):
        node.undeclare_parameter("fixed")
    assert node.declare_parameter("p", "again").value == "again"


# getting


def test_undeclared_parameters_are_refused_or_not_set(world: Any) -> None:
    strict, free = world.node("strict"), world.node("free", allow_undeclared_parameters=True)
    for ask in (strict.get_parameter, strict.get_parameter_type, strict.describe_parameter):
        with pytest.raises(ParameterNotDeclaredException, match=r"^Invalid access to undeclared parameter\(s\): p$"):
            ask("p")
    assert free.get_parameter("p").type_ == Type.NOT_SET
    assert free.get_parameter_type("p") == Type.NOT_SET
    assert free.describe_parameter("p") == ParameterDescriptor()
    assert strict.get_parameter_or("p").type_ == Type.NOT_SET
    assert strict.get_parameter_or("p", Parameter("x", value=1)).value == 1


def test_several_parameters_are_asked_for_in_their_order(world: Any) -> None:
    node = world.node("n")
    node.declare_parameters("", [("a", 1), ("b", "x")])
    assert [each.value for each in node.get_parameters(["b", "a"])] == ["x", 1]
    assert node.get_parameter_types(["b", "a"]) == [4, 2]
    assert [each.name for each in node.describe_parameters(["b", "a"])] == ["b", "a"]
    for ask in (node.get_parameters, node.get_parameter_types):
        with pytest.raises(TypeError, match="All names must be instances of type str"):
            ask(["a", 5])


NAMES = ["a", "a.b", "a.c.d", "ab", "b.c"]


@pytest.mark.parametrize(
    ("prefixes", "depth", "names", "found_prefixes"),
    [
        ([], 0, NAMES, ["a", "a.c", "b"]),
        ([], 1, ["a", "ab"], []),
        ([], 2, ["a", "a.b", "ab", "b.c"], ["a", "b"]),
        (["a"], 0, ["a", "a.b", "a.c.d"], ["a", "a.c"]),
        (["a"], 1, ["a", "a.b"], ["a"]),
        (["a"], 2, ["a", "a.b", "a.c.d"], ["a", "a.c"]),
        (["a.c", "b"], 0, ["a.c.d", "b.c"], ["a.c", "b"]),
        (["nothing"], 0, [], []),
    ],
)
def test_parameters_are_listed_by_prefix_and_depth(
    world: Any, prefixes: list[str], depth: int, names: list[str], found_prefixes: list[str]
) -> None:
    node = world.node("n")
    node.declare_parameters("", [(name, 1) for name in NAMES])
    result = node.list_parameters(prefixes, depth)
    own = {"use_sim_time", "start_type_description_service"}
    assert [name for name in result.names if name not in own] == names
    assert sorted(result.prefixes) == found_prefixes


@pytest.mark.parametrize(
    ("prefixes", "depth", "error", "message"),
    [
        ("a", 0, TypeError, "The prefixes argument must be a list"),
        ([1], 0, TypeError, "All prefixes must be instances of type str"),
        ([], "1", TypeError, "The depth must be instance of type int"),
        ([], -1, ValueError, "The depth must be greater than or equal to zero"),
    ],
)
def test_a_list_of_parameters_is_asked_for_properly(
    world: Any, prefixes: Any, depth: Any, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        world.node("n").list_parameters(prefixes, depth)


def test_parameters_below_a_prefix_are_named_without_it(world: Any) -> None:
    node = world.node("n")
    node.declare_parameters("", [(name, index) for index, name in enumerate(NAMES)])
    found = node.get_parameters_by_prefix("a")
    assert {name: each.value for name, each in found.items()} == {"b": 1, "c.d": 2}
    assert set(node.get_parameters_by_prefix("")) >= set(NAMES)


# setting, and what the descriptor allows


def descriptor_of(low: Any, high: Any, step: Any) -> ParameterDescriptor:
    if isinstance(low, int):
        return ParameterDescriptor(integer_range=[IntegerRange(from_value=low, to_value=high, step=step)])
    return ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=low, to_value=high, step=step)])


@pytest.mark.parametrize(
    ("low", "high", "step", "value", "reason"),
    [
        (0, 10, 0, 0, ""),
        (0, 10, 0, 10, ""),
        (0, 10, 0, 7, ""),
        (0, 10, 0, -1, "Parameter p out of range. Min: 0, Max: 10, value: -1"),
        (0, 10, 0, 11, "Parameter p out of range. Min: 0, Max: 10, value: 11"),
        (10, 0, 0, 7, ""),
        (10, 0, 0, 11, "Parameter p out of range. Min: 0, Max: 10, value: 11"),
        (1, 10, 3, 4, ""),
        (1, 10, 3, 7, ""),
        (1, 11, 3, 11, ""),
        (1, 10, 3, 5, "The parameter value for p is not a valid step. Min: 1, max: 10, value: 5, step: 3"),
        (1, 10, 3, 3, "The parameter value for p is not a valid step. Min: 1, max: 10, value: 3, step: 3"),
        (0.0, 1.0, 0.0, 0.0, ""),
        (0.0, 1.0, 0.0, 1.0, ""),
        (0.0, 1.0, 0.0, 0.3, ""),
        (1.0, 2.0, 0.0, 0.9999995, ""),
        (1.0, 2.0, 0.0, 2.0000015, ""),
        (1.0, 2.0, 0.0, 0.99, "Parameter p out of range Min: 1.0, Max: 2.0, value: 0.99"),
        (1.0, 2.0, 0.0, 2.01, "Parameter p out of range Min: 1.0, Max: 2.0, value: 2.01"),
        (2.0, 1.0, 0.0, 1.5, ""),
        (1.0, 2.0, 0.25, 1.75, ""),
        (1.0, 2.0, 0.25, 1.5000005, ""),
        (1.0, 2.0, 0.3, 1.9, ""),
        (1.0, 2.0, 0.3, 2.0, ""),
        (
            1.0, 2.0, 0.25, 1.3,
            "The parameter value for p is not close enough to a valid step. Min: 1.0, max: 2.0, value: 1.3, step: 0.25",
        ),
        (
            1.0, 2.0, 0.25, 1.4,
            "The parameter value for p is not close enough to a valid step. Min: 1.0, max: 2.0, value: 1.4, step: 0.25",
        ),
    ],
)  # fmt: skip
def test_a_number_stays_in_its_range_and_on_its_steps(
    world: Any, low: Any, high: Any, step: Any, value: Any, reason: str
) -> None:
    node = world.node("n")
    node.declare_parameter("p", high, descriptor_of(low, high, step))
    result = node.set_parameters([Parameter("p", value=value)])[0]
    assert (result.successful, result.reason) == (not reason, reason)
    assert node.get_parameter("p").value == (high if reason else value)


def test_a_range_is_for_numbers_of_its_own_type(world: Any) -> None:
    node = world.node("n")
    descriptor = ParameterDescriptor(
        dynamic_typing=True,
        integer_range=[IntegerRange(from_value=0, to_value=1)],
        floating_point_range=[FloatingPointRange(from_value=5.0, to_value=6.0)],
    )
    node.declare_parameter("p", 1, descriptor)
    outcomes = [node.set_parameters([Parameter("p", value=value)])[0].successful for value in (2, 5.5, 1.0, "x", True)]
    assert outcomes == [False, True, False, True, True]


def test_a_read_only_parameter_keeps_its_value(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1, ParameterDescriptor(read_only=True))
    result = node.set_parameters([Parameter("p", value=2)])[0]
    assert (result.successful, result.reason) == (False, "Trying to set a read-only parameter: p.")
    assert node.get_parameter("p").value == 1
    with pytest.raises(ParameterImmutableException):
        node.set_descriptor("p", ParameterDescriptor())


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("x", "Wrong parameter type, expected '2' got '4'"),
        (1.0, "Wrong parameter type, expected '2' got '3'"),
        (None, "Static parameter cannot be undeclared"),
    ],
)
def test_a_parameter_keeps_its_type(world: Any, value: Any, reason: str) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    result = node.set_parameters([Parameter("p", value=value)])[0]
    assert (result.successful, result.reason) == (False, reason)
    assert node.get_parameter("p").value == 1


def test_a_parameter_of_dynamic_type_takes_any(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1, ParameterDescriptor(dynamic_typing=True))
    assert node.set_parameters([Parameter("p", value="x")])[0].successful
    assert node.describe_parameter("p").type == Type.STRING.value


def test_parameters_are_set_one_by_one_or_all_together(world: Any) -> None:
    node = world.node("n")
    node.declare_parameters("", [("a", 1), ("b", 1)])
    changes = [Parameter("a", value=2), Parameter("b", value="wrong")]
    assert [each.successful for each in node.set_parameters(changes)] == [True, False]
    assert node.get_parameter("a").value == 2
    changes = [Parameter("a", value=3), Parameter("b", value="wrong")]
    result = node.set_parameters_atomically(changes)
    assert (result.successful, result.reason) == (False, "Wrong parameter type, expected '2' got '4'")
    assert node.get_parameter("a").value == 2
    assert node.set_parameters_atomically([Parameter("a", value=3), Parameter("b", value=4)]).successful
    assert [each.value for each in node.get_parameters(["a", "b"])] == [3, 4]


def test_an_undeclared_parameter_can_be_set_only_where_that_is_allowed(world: Any) -> None:
    strict, free = world.node("strict"), world.node("free", allow_undeclared_parameters=True)
    with pytest.raises(ParameterNotDeclaredException):
        strict.set_parameters([Parameter("p", value=1)])
    with pytest.raises(TypeError, match="parameter must be instance of type"):
        strict.set_parameters(["p"])
    assert free.set_parameters([Parameter("p", value=1)])[0].successful
    assert free.get_parameter("p").value == 1
    assert free.has_parameter("p")
    assert free.describe_parameter("p").dynamic_typing
    assert free.set_parameters([Parameter("p", Type.NOT_SET)])[0].successful
    assert not free.has_parameter("p")


def test_a_new_descriptor_holds_for_the_value_or_its_alternative(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 5)

    def ranged(low: int, high: int) -> ParameterDescriptor:
        return ParameterDescriptor(type=2, integer_range=[IntegerRange(from_value=low, to_value=high)])

    assert node.set_descriptor("p", ranged(0, 9)).integer_value == 5
    assert node.describe_parameter("p").integer_range[0].to_value == 9
    alternative = ParameterValue(type=2, integer_value=11)
    assert node.set_descriptor("p", ranged(10, 12), alternative).integer_value == 11
    assert node.get_parameter("p").value == 11
    with pytest.raises(InvalidParameterValueException, match=r"out of range. Min: 0, Max: 1, value: 11"):
        node.set_descriptor("p", ranged(0, 1))
    assert node.describe_parameter("p").integer_range[0].to_value == 12
    with pytest.raises(ParameterNotDeclaredException):
        node.set_descriptor("q", ParameterDescriptor())
    assert world.node("free", allow_undeclared_parameters=True).set_descriptor("q", ParameterDescriptor()).type == 0


# callbacks


def accept(*_: Any) -> SetParametersResult:
    return SetParametersResult(successful=True)


def test_callbacks_run_in_three_stages_the_last_added_first(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    ran: list[tuple[str, int]] = []

    def noted(name: str, answer: Any) -> Any:
        def callback(parameters: list[Any]) -> Any:
            ran.append((name, node.get_parameter("p").value))
            return parameters if answer is None else answer

        return callback

    for number in "12":
        node.add_post_set_parameters_callback(noted(f"post{number}", ""))
        node.add_on_set_parameters_callback(noted(f"on{number}", accept()))
    node.add_pre_set_parameters_callback(noted("pre", None))
    assert node.set_parameters([Parameter("p", value=2)])[0].successful
    assert ran == [("pre", 1), ("on2", 1), ("on1", 1), ("post2", 2), ("post1", 2)]


def test_callbacks_of_every_kind_come_last_added_first(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    ran: list[str] = []
    noted = {
        f"{stage}{number}": lambda parameters, name=f"{stage}{number}", answer=answer: (
            ran.append(name) or (parameters if answer is None else answer)
        )
        for stage, answer in (("pre", None), ("on", accept()), ("post", ""))
        for number in (1, 2, 3)
    }
    add = {
        "pre": (node.add_pre_set_parameters_callback, node.remove_pre_set_parameters_callback),
        "on": (node.add_on_set_parameters_callback, node.remove_on_set_parameters_callback),
        "post": (node.add_post_set_parameters_callback, node.remove_post_set_parameters_callback),
    }
    for name, callback in noted.items():
        add[name[:-1]][0](callback)
    assert node.set_parameters_atomically([Parameter("p", value=2)]).successful
    assert ran == ["pre3", "pre2", "pre1", "on3", "on2", "on1", "post3", "post2", "post1"]
    for name in ("pre2", "on2", "post2"):
        add[name[:-1]][1](noted[name])
    ran.clear()
    node.set_parameters([Parameter("p", value=3)])
    assert ran == ["pre3", "pre1", "on3", "on1", "post3", "post1"]
    for name in ("pre2", "on2", "post2"):
        with pytest.raises(ValueError):
            add[name[:-1]][1](noted[name])


def test_a_callback_that_refuses_ends_the_matter(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    asked: list[str] = []

    def refuse(_: Any) -> SetParametersResult:
        return SetParametersResult(successful=False, reason="not today")

    node.add_on_set_parameters_callback(lambda _: asked.append("first") or accept())
    node.add_on_set_parameters_callback(refuse)
    node.add_post_set_parameters_callback(lambda _: asked.append("post"))
    result = node.set_parameters([Parameter("p", value=2)])[0]
    assert (result.successful, result.reason, asked) == (False, "not today", [])
    assert node.get_parameter("p").value == 1
    node.remove_on_set_parameters_callback(refuse)
    assert node.set_parameters([Parameter("p", value=2)])[0].successful
    assert asked == ["first", "post"]
    with pytest.raises(ValueError):
        node.remove_on_set_parameters_callback(refuse)


def test_a_callback_before_changes_what_is_set(world: Any) -> None:
    node = world.node("n")
    node.declare_parameters("", [("a", 1), ("b", 1)])

    def double(parameters: list[Any]) -> list[Any]:
        return [*parameters, Parameter("b", value=parameters[0].value * 2)]

    node.add_pre_set_parameters_callback(double)
    assert node.set_parameters([Parameter("a", value=5)])[0].successful
    assert [each.value for each in node.get_parameters(["a", "b"])] == [5, 10]
    node.remove_pre_set_parameters_callback(double)
    node.add_pre_set_parameters_callback(lambda _: [])
    result = node.set_parameters([Parameter("a", value=6)])[0]
    assert not result.successful
    assert result.reason == (
        "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the original "
        "parameters list."
    )
    assert node.get_parameter("a").value == 5


def test_a_callback_after_is_called_no_more_once_it_was_removed(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    seen: list[int] = []

    def note(parameters: list[Any]) -> None:
        seen.append(parameters[0].value)

    node.add_post_set_parameters_callback(note)
    node.set_parameters([Parameter("p", value=2)])
    node.remove_post_set_parameters_callback(note)
    node.set_parameters([Parameter("p", value=3)])
    assert seen == [2]


def test_a_callback_has_to_be_one_and_to_answer_properly(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    for add in (node.add_on_set_parameters_callback, node.add_post_set_parameters_callback):
        with pytest.raises(TypeError, match="Callback must be callable, got"):
            add(5)
    node.add_on_set_parameters_callback(lambda _: None)
    with pytest.warns(UserWarning, match=r"Callback returned an invalid type, it should return SetParameterResult."):
        result = node.set_parameters([Parameter("p", value=2)])[0]
    assert (result.successful, result.reason) == (False, "Callback returned an invalid type")


def test_a_declaration_asks_the_callbacks_too(world: Any) -> None:
    node = world.node("n")
    node.add_on_set_parameters_callback(lambda _: SetParametersResult(successful=False, reason="no"))
    with pytest.raises(
        InvalidParameterValueException, match=r"Invalid parameter value \(1\) for parameter. Reason: no"
    ):
        node.declare_parameter("p", 1)


def test_every_change_is_an_event(world: Any) -> None:
    node, listener = world.node("n", namespace="lab"), world.node("listener")
    events: list[Any] = []
    listener.create_subscription(ParameterEvent, "/parameter_events", events.append, 10)
    world.settle()
    events.clear()
    node.declare_parameter("p", 1, ParameterDescriptor(dynamic_typing=True))
    node.set_parameters([Parameter("p", value=2)])
    node.set_parameters([Parameter("p", Type.NOT_SET)])
    world.settle()
    kinds = [(each.new_parameters, each.changed_parameters, each.deleted_parameters) for each in events]
    assert [[[(one.name, one.value.integer_value) for one in part] for part in kind] for kind in kinds] == [
        [[("p", 1)], [], []],
        [[], [("p", 2)], []],
        [[], [], [("p", 0)]],
    ]
    assert {each.node for each in events} == {"/lab/n"}
    assert all(each.stamp.sec > 1_000_000_000 for each in events)


def test_undeclaring_is_no_event(world: Any) -> None:
    """As in rclpy 9.1.2 (node.py) and rclcpp (node_parameters.cpp): only setting publishes."""
    node, listener = world.node("n"), world.node("listener")
    events: list[Any] = []
    listener.create_subscription(ParameterEvent, "/parameter_events", events.append, 10)
    node.declare_parameter("p", 1, ParameterDescriptor(dynamic_typing=True))
    world.settle()
    events.clear()
    node.undeclare_parameter("p")
    world.settle()
    assert not events and not node.has_parameter("p")


def test_a_number_that_no_message_can_hold_is_refused(world: Any) -> None:
    node = world.node("n")
    for value in (2**63 - 1, -(2**63)):
        assert node.declare_parameter(f"p{value < 0}", value).value == value
    for value in (2**63, -(2**63) - 1, [1, 2**63]):
        with pytest.raises(AssertionError):
            node.declare_parameter("q", value)


# files, by the function for programs

FILE = """
/**:
  ros__parameters: {everywhere: 1, speed: 5}
/lab/robot:
  ros__parameters: {speed: 7, arm: {length: 0.5, names: [a, b]}}
robot:
  ros__parameters: {speed: 8}
/lab:
  other:
    ros__parameters: {speed: 9, ready: true}
/broken: [1]
"""


@pytest.fixture
def file(tmp_path: Path) -> str:
    path = tmp_path / "parameters.yaml"
    path.write_text(FILE, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize(
    ("wildcard", "nodes", "namespace", "expected"),
    [
        (True, None, "", {"everywhere": 1, "speed": 5}),
        (False, ["/lab/robot"], "", {"speed": 7, "arm.length": 0.5, "arm.names": ["a", "b"]}),
        (True, ["lab/robot"], "", {"everywhere": 1, "speed": 7, "arm.length": 0.5, "arm.names": ["a", "b"]}),
        (False, ["robot"], "", {"speed": 8}),
        (False, ["/lab/other"], "", {"speed": 9, "ready": True}),
        (False, ["robot"], "x.", {"x.speed": 8}),
        (False, ["", "robot", "/lab/other"], "", {"speed": 9, "ready": True}),
    ],
)
def test_a_parameter_file_gives_the_parameters_of_some_nodes(
    file: str, wildcard: bool, nodes: list[str] | None, namespace: str, expected: dict[str, Any]
) -> None:
    found = parameter_dict_from_yaml_file(file, wildcard, nodes, namespace)
    assert all(isinstance(each, ParameterMessage) and each.name == name for name, each in found.items())
    assert {name: parameter_value_to_python(each.value) for name, each in found.items()} == expected


@pytest.mark.parametrize(
    ("wildcard", "nodes", "message"),
    [
        (False, None, "Param file does not contain any valid parameters"),
        (False, ["/nobody"], "Param file does not contain any valid parameters"),
        (False, ["/broken"], "YAML file is not a valid ROS parameter file for node /broken"),
    ],
)
def test_a_parameter_file_without_anything_is_told(
    file: str, wildcard: bool, nodes: list[str] | None, message: str
) -> None:
    with pytest.raises(RuntimeError, match=message):
        parameter_dict_from_yaml_file(file, wildcard, nodes)
