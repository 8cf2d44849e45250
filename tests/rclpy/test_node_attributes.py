"""A program's own attributes on its node, and a node whose `__init__` was not called, as with real rclpy."""

from __future__ import annotations

from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import SetBool

from rclpy.node import Node
from rclpy.parameter import Parameter


class _Uninitialized(Node):
    def __init__(self) -> None:
        """Forget `super().__init__`, as students do."""


def _uses(node: Any) -> dict[str, tuple[Any, str]]:
    """Each way to use a node, and the attribute that real rclpy finds missing."""
    group, parameters = "_default_callback_group", "_parameters"
    return {
        "create_publisher": (lambda: node.create_publisher(String, "c", 10), group),
        "create_subscription": (lambda: node.create_subscription(String, "c", print, 10), group),
        "create_client": (lambda: node.create_client(SetBool, "c"), group),
        "create_service": (lambda: node.create_service(SetBool, "c", print), group),
        "create_timer": (lambda: node.create_timer(1.0, print), group),
        "create_guard_condition": (lambda: node.create_guard_condition(print), group),
        "create_rate": (lambda: node.create_rate(1.0), "_rate_group"),
        "declare_parameter": (lambda: node.declare_parameter("a", 1), "_parameter_overrides"),
        "get_parameter": (lambda: node.get_parameter("a"), parameters),
        "get_parameter_or": (lambda: node.get_parameter_or("a"), parameters),
        "has_parameter": (lambda: node.has_parameter("a"), parameters),
        "set_parameters": (
            lambda: node.set_parameters([Parameter("a", value=1)]),
            "_pre_set_parameters_callbacks",
        ),
        "describe_parameter": (lambda: node.describe_parameter("a"), "_descriptors"),
        "add_on_set_parameters_callback": (
            lambda: node.add_on_set_parameters_callback(print),
            "_on_set_parameters_callbacks",
        ),
        "publishers": (lambda: list(node.publishers), "_publishers"),
        "waitables": (lambda: list(node.waitables), "_Node__waitables"),
        "destroy_timer": (lambda: node.destroy_timer(None), "_timers"),
        "get_name": (node.get_name, "_Node__node"),
        "get_node_names": (node.get_node_names, "_Node__node"),
        "get_logger": (node.get_logger, "_logger"),
        "destroy_node": (node.destroy_node, "_context"),
    }


def test_a_node_whose_init_was_not_called_fails_with_real_rclpys_words() -> None:
    said = {}
    for name, (use, _) in _uses(_Uninitialized()).items():
        with pytest.raises(AttributeError) as caught:
            use()
        said[name] = str(caught.value)
    assert said == {
        name: f"'_Uninitialized' object has no attribute '{attribute}'"
        for name, (_, attribute) in _uses(_Uninitialized()).items()
    }


@pytest.mark.parametrize(
    "name",
    [
        "_add",
        "_descriptors_",
        "_entities",
        "_graph",
        "_handle",
        "_infos",
        "_nodes",
        "_remove",
        "_scope",
        "_store",
        "_waitables",
    ],
)
def test_an_attribute_of_a_program_hides_nothing_that_its_node_needs(world: Any, name: str) -> None:
    node = world.node("n")
    setattr(node, name, {})
    node.declare_parameter("q", 1)
    heard: list[Any] = []
    node.create_subscription(String, "c", heard.append, 1)
    publisher = node.create_publisher(String, "c", 1)
    publisher.publish(String(data="x"))
    world.settle()
    assert [message.data for message in heard] == ["x"]
    assert node.get_publishers_info_by_topic("c")[0].node_name == "n"
    assert node.set_parameters([Parameter("q", value=2)])[0].successful
    assert node.destroy_publisher(publisher)
    assert getattr(node, name) == {}


@pytest.mark.parametrize("name", ["_publishers", "_subscriptions", "_clients", "_services", "_timers", "_guards"])
def test_an_attribute_that_real_rclpy_has_too_is_spoilt_as_there(world: Any, name: str) -> None:
    node = world.node("n")
    setattr(node, name, {})
    create = {
        "_publishers": lambda: node.create_publisher(String, "c", 10),
        "_subscriptions": lambda: node.create_subscription(String, "c", print, 10),
        "_clients": lambda: node.create_client(SetBool, "c"),
        "_services": lambda: node.create_service(SetBool, "c", print),
        "_timers": lambda: node.create_timer(1.0, print),
        "_guards": lambda: node.create_guard_condition(print),
    }[name]
    with pytest.raises(AttributeError, match="'dict' object has no attribute 'append'"):
        create()


def test_node_is_one_class_and_a_publisher_is_nothing_an_executor_runs() -> None:
    from rclpy._day6.entity import Entity
    from rclpy.publisher import Publisher

    assert Node.__bases__ == (object,)
    assert not issubclass(Publisher, Entity)


def test_wrong_arguments_are_told_in_the_name_of_node() -> None:
    with pytest.raises(TypeError, match=r"^Node\.create_publisher\(\) missing 1 required positional argument"):
        Node.create_publisher(object(), String, "c")  # type: ignore[arg-type,call-arg]
