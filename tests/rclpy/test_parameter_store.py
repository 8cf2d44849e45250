"""A store of parameters without a node: declaring, rules, setting all or none, callbacks, whom it tells."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult

from rclpy._day6.parameter_store import ParameterStore
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import Parameter

_Type = Parameter.Type


class Heard:
    """Keeps what it is told: the names of new, changed and deleted parameters, one entry for each change."""

    def __init__(self) -> None:
        self.changes: list[tuple[list[str], list[str], list[str]]] = []
        self.listening = True
        self.gone = False

    def require(self) -> None:
        if self.gone:
            raise RuntimeError("gone")

    def has_subscribers(self) -> bool:
        return self.listening

    def changed(self, *lists: list[Parameter[Any]]) -> None:
        new, changed, deleted = ([parameter.name for parameter in each] for each in lists)
        self.changes.append((new, changed, deleted))


def _set(store: ParameterStore, **values: Any) -> SetParametersResult:
    return store.set_atomically([Parameter(name, value=value) for name, value in values.items()])


def _ranged(name: str, value: float, start: float, end: float, step: float = 0) -> ParameterStore:
    store = ParameterStore()
    if isinstance(value, float):
        limits: dict[str, Any] = {
            "floating_point_range": [FloatingPointRange(from_value=start, to_value=end, step=float(step))]
        }
    else:
        limits = {"integer_range": [IntegerRange(from_value=int(start), to_value=int(end), step=int(step))]}
    store.declare("", [(name, value, ParameterDescriptor(**limits))])
    return store


def test_an_override_wins_over_the_declared_value_unless_it_is_ignored() -> None:
    store = ParameterStore(overrides={"a.speed": Parameter("a.speed", value=7)})
    (parameter,) = store.declare("a", [("speed", 1)])
    assert (parameter.name, parameter.value) == ("a.speed", 7)
    store.undeclare("a.speed")
    assert store.declare("a", [("speed", 1)], ignore_override=True)[0].value == 1


def test_an_override_of_another_type_is_refused_and_nothing_is_declared() -> None:
    store = ParameterStore(overrides={"speed": Parameter("speed", value="fast")})
    with pytest.raises(InvalidParameterTypeException, match="speed"):
        store.declare("", [("speed", 1.0)])
    assert not store.has("speed")


def test_declaring_twice_is_refused_before_anything_is_declared() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1)])
    with pytest.raises(ParameterAlreadyDeclaredException):
        store.declare("", [("b", 2), ("a", 3)])
    assert list(store.parameters) == ["a"]
    assert store.get("a").value == 1


def test_what_was_declared_before_a_refused_one_stays() -> None:
    store = ParameterStore()
    bad = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=9)])
    with pytest.raises(InvalidParameterValueException, match="out of range"):
        store.declare("", [("a", 1), ("b", 10, bad), ("c", 3)])
    assert list(store.parameters) == ["a"]


def test_a_parameter_declared_by_its_type_has_no_value_until_it_is_set() -> None:
    store = ParameterStore()
    (parameter,) = store.declare("", [("speed", _Type.DOUBLE)])
    assert parameter.type_ == _Type.NOT_SET
    with pytest.raises(ParameterUninitializedException):
        store.get("speed")
    assert store.get_or("speed", Parameter("speed", value=2.0)).value == 2.0
    assert _set(store, speed=3).reason == "Wrong parameter type, expected '3' got '2'"
    assert _set(store, speed=3.0).successful
    assert store.get("speed").value == 3.0


def test_an_undeclared_parameter_can_be_read_and_set_only_where_that_is_allowed() -> None:
    strict, lenient = ParameterStore(), ParameterStore(allow_undeclared=True)
    for use in (strict.get, strict.type_of, strict.describe, strict.undeclare):
        with pytest.raises(ParameterNotDeclaredException):
            use("a")
    with pytest.raises(ParameterNotDeclaredException):
        _set(strict, a=1)
    assert lenient.get("a").type_ == _Type.NOT_SET
    assert lenient.type_of("a") == _Type.NOT_SET
    assert _set(lenient, a=1).successful
    assert _set(lenient, a="now a text").successful
    assert lenient.describe("a").dynamic_typing


def test_an_integer_obeys_its_range_and_its_steps_from_the_lower_end() -> None:
    store = _ranged("n", 1, 1, 10, 3)
    assert [value for value in range(12) if _set(store, n=value).successful] == [1, 4, 7, 10]
    assert _set(store, n=0).reason == "Parameter n out of range. Min: 1, Max: 10, value: 0"
    assert "is not a valid step" in _set(store, n=2).reason
    assert store.get("n").value == 10


def test_the_upper_end_of_a_range_is_allowed_though_no_step_meets_it() -> None:
    store = _ranged("n", 0, 0, 10, 4)
    assert [value for value in range(11) if _set(store, n=value).successful] == [0, 4, 8, 10]


def test_a_float_may_miss_an_end_or_a_step_by_a_millionth_of_itself() -> None:
    store = _ranged("x", 1.0, 1.0, 2.0, 0.25)
    assert _set(store, x=2.0 + 1.9e-6).successful
    assert not _set(store, x=2.0 + 2.1e-6).successful
    assert _set(store, x=1.25 + 1.2e-6).successful
    assert "is not close enough to a valid step" in _set(store, x=1.25 + 1.3e-6).reason
    coarse = ParameterStore(rel_tol=0.1)
    coarse.descriptors["x"] = store.descriptors["x"]
    coarse.parameters["x"] = Parameter("x", value=1.0)
    assert _set(coarse, x=2.1).successful


def test_of_several_parameters_all_are_set_or_none() -> None:
    store = _ranged("n", 1, 1, 10)
    store.declare("", [("a", 1)])
    assert not _set(store, a=2, n=11).successful
    assert store.get("a").value == 1
    assert [result.successful for result in store.set_each([Parameter("a", value=2), Parameter("n", value=11)])] == [
        True,
        False,
    ]
    assert store.get("a").value == 2


def test_a_read_only_parameter_is_neither_set_nor_undeclared_nor_described_anew() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1, ParameterDescriptor(read_only=True))])
    assert _set(store, a=2).reason == "Trying to set a read-only parameter: a."
    with pytest.raises(ParameterImmutableException):
        store.undeclare("a")
    with pytest.raises(ParameterImmutableException):
        store.set_descriptor("a", ParameterDescriptor())
    assert store.get("a").value == 1


def test_a_static_parameter_cannot_be_deleted_and_a_dynamic_one_can() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1), ("b", 1, ParameterDescriptor(dynamic_typing=True))])
    delete = [Parameter("a", _Type.NOT_SET)]
    assert store.set_atomically(delete).reason == "Static parameter cannot be undeclared"
    assert store.set_atomically([Parameter("b", _Type.NOT_SET)]).successful
    assert list(store.parameters) == ["a"]
    assert "b" not in store.descriptors


def test_a_new_descriptor_that_the_value_does_not_obey_needs_an_alternative_value() -> None:
    from rcl_interfaces.msg import ParameterValue

    store = ParameterStore()
    store.declare("", [("n", 5)])
    small = ParameterDescriptor(type=2, integer_range=[IntegerRange(from_value=0, to_value=3)])
    with pytest.raises(InvalidParameterValueException):
        store.set_descriptor("n", small, ParameterValue(type=2, integer_value=4))
    assert store.set_descriptor("n", small, ParameterValue(type=2, integer_value=3)).integer_value == 3
    assert store.get("n").value == 3
    assert not _set(store, n=5).successful


def test_callbacks_come_last_added_first_and_the_first_refusal_ends_it() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1)])
    calls: list[str] = []

    def answering(name: str, successful: bool) -> Any:
        def callback(parameters: list[Parameter[Any]]) -> SetParametersResult:
            calls.append(f"{name} {[parameter.value for parameter in parameters]} {store.get('a').value}")
            return SetParametersResult(successful=successful, reason=name)

        return callback

    store.add_on_set_callback(answering("first", True))
    store.add_on_set_callback(answering("second", True))
    store.add_post_set_callback(lambda parameters: calls.append(f"post {store.get('a').value}"))
    assert _set(store, a=2).successful
    assert calls == ["second [2] 1", "first [2] 1", "post 2"]
    calls.clear()
    store.add_on_set_callback(answering("third", False))
    assert _set(store, a=3).reason == "third"
    assert calls == ["third [3] 2"]
    assert store.get("a").value == 2


def test_what_a_callback_before_setting_returns_is_what_is_set() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1), ("b", 1)])
    store.add_pre_set_callback(lambda parameters: [*parameters, Parameter("b", value=parameters[0].value * 10)])
    assert _set(store, a=2).successful
    assert (store.get("a").value, store.get("b").value) == (2, 20)
    store.pre_set_callbacks.clear()
    store.add_pre_set_callback(lambda parameters: [])
    assert "parameter list cannot be empty" in _set(store, a=3).reason
    assert store.get("a").value == 2


def test_a_callback_that_returns_no_result_refuses_with_a_warning() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1)])
    wrong: Any = lambda parameters: True  # noqa: E731
    store.add_on_set_callback(wrong)
    with pytest.warns(UserWarning, match="Callback returned an invalid type"):
        result = _set(store, a=2)
    assert (result.successful, store.get("a").value) == (False, 1)
    with pytest.raises(TypeError):
        store.add_on_set_callback(wrong(None))


def test_a_listener_is_told_once_of_what_was_set_together() -> None:
    heard = Heard()
    store = ParameterStore(allow_undeclared=True, listener=heard)
    store.declare("", [("a", 1, ParameterDescriptor(dynamic_typing=True)), ("b", 1)])
    assert heard.changes == [(["a"], [], []), (["b"], [], [])]
    heard.changes.clear()
    store.set_atomically([Parameter("c", value=1), Parameter("b", value=2), Parameter("a", _Type.NOT_SET)])
    assert heard.changes == [(["c"], ["b"], ["a"])]


def test_a_listener_that_is_gone_keeps_the_values_as_they_are() -> None:
    heard = Heard()
    store = ParameterStore(listener=heard)
    store.declare("", [("a", 1)])
    heard.gone = True
    with pytest.raises(RuntimeError, match="gone"):
        _set(store, a=2)
    assert store.get("a").value == 1


def test_a_flag_of_every_node_is_declared_quietly_unless_somebody_listens() -> None:
    heard = Heard()
    store = ParameterStore(listener=heard)
    heard.listening = False
    store.declare_plain("quiet", False)
    assert heard.changes == []
    heard.listening = True
    store.declare_plain("loud", True, read_only=True)
    assert heard.changes == [(["loud"], [], [])]
    assert (store.get("quiet").value, store.describe("quiet").name, store.describe("quiet").type) == (False, "quiet", 1)
    assert store.describe("loud").read_only
    assert ParameterStore(overrides={"x": Parameter("x", value=True)}).overrides["x"].value
    overridden = ParameterStore(overrides={"x": Parameter("x", value=True)})
    overridden.declare_plain("x", False)
    assert overridden.get("x").value is True


def test_names_are_listed_by_prefix_and_depth() -> None:
    store = ParameterStore()
    store.declare("", [("a", 1), ("arm.left.speed", 1), ("arm.right", 1), ("armor", 1)])
    assert store.names_below([], 0).names == ["a", "arm.left.speed", "arm.right", "armor"]
    assert store.names_below([], 1).names == ["a", "armor"]
    assert store.names_below(["arm"], 0).names == ["arm.left.speed", "arm.right"]
    assert store.names_below(["arm"], 1).names == ["arm.right"]
    assert sorted(store.names_below(["arm"], 0).prefixes) == ["arm", "arm.left"]
    assert list(store.by_prefix("arm")) == ["left.speed", "right"]
    assert list(store.by_prefix("")) == ["a", "arm.left.speed", "arm.right", "armor"]
    with pytest.raises(ValueError, match="depth"):
        store.names_below([], -1)
