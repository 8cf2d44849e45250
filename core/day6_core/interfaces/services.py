"""Builds the classes of services and actions. Their parts (Request, Goal, …) are generated on first access."""

from __future__ import annotations

from day6_core.interfaces.generate import InterfaceType, module_name
from day6_core.ros import differences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_SERVICE_PARTS = {"Request": "_Request", "Response": "_Response", "Event": "_Event"}
_ACTION_PARTS = {"Goal": "_Goal", "Result": "_Result", "Feedback": "_Feedback"}
_IMPLEMENTATION_PARTS = {
    "SendGoalService": "_SendGoal",
    "GetResultService": "_GetResult",
    "FeedbackMessage": "_FeedbackMessage",
    "CancelGoalService": "action_msgs/srv/CancelGoal",
    "GoalStatusMessage": "action_msgs/msg/GoalStatusArray",
}


class _LazyPart:
    """A class attribute that is looked up on first access, then replaced with the class found."""

    def __init__(self, attribute: str, full_name: str, find_class: Callable[[str], type]) -> None:
        self.attribute = attribute
        self.full_name = full_name
        self.find_class = find_class

    def __get__(self, instance: object, owner: Any) -> Any:
        found = self.find_class(self.full_name)
        for cls in owner.__mro__:
            if vars(cls).get(self.attribute) is self:
                setattr(cls, self.attribute, found)
        return found


def build_service(package: str, kind: str, name: str, find_class: Callable[[str], type]) -> type:
    """Return a service class with Request, Response and Event; calling it raises NotImplementedError as in real ROS."""
    parts = _parts(_SERVICE_PARTS, f"{package}/{kind}/{name}", find_class)
    if not differences.value("services.have_events"):
        del parts["Event"]
    return _build(package, kind, name, "service", parts)


def build_action(package: str, name: str, find_class: Callable[[str], type]) -> type:
    """Return an action class with Goal, Result, Feedback and Impl, which has the protocol's services and messages."""
    full_name = f"{package}/action/{name}"
    module = module_name(package, "action", name)
    implementation = type("Impl", (), {
        "__module__": module,
        "__qualname__": f"{name}.Impl",
        **_parts(_IMPLEMENTATION_PARTS, full_name, find_class),
    })  # fmt: skip
    parts = _parts(_ACTION_PARTS, full_name, find_class)
    return _build(package, "action", name, "action", {**parts, "Impl": implementation})


def _parts(table: dict[str, str], full_name: str, find_class: Callable[[str], type]) -> dict[str, Any]:
    return {
        attribute: _LazyPart(attribute, full_name + part if part.startswith("_") else part, find_class)
        for attribute, part in table.items()
    }


def _build(package: str, kind: str, name: str, word: str, namespace: dict[str, Any]) -> type:
    module = module_name(package, kind, name)

    def refuse(self: object) -> None:
        raise NotImplementedError(f"{word.capitalize()} classes can not be instantiated")

    refuse.__name__ = "__init__"
    refuse.__qualname__ = f"{name}.__init__"
    metaclass = type(f"Metaclass_{name}", (InterfaceType,), {
        "__module__": module,
        "__doc__": f"Metaclass of {word} '{name}'.",
        "_interface_name": f"{package}/{kind}/{name}",
    })  # fmt: skip
    made = metaclass(name, (), {"__module__": module, "__init__": refuse, **namespace})
    assert isinstance(made, type)
    return made
