"""Where warnings come from: as in real rclpy most name rclpy's own line, and those about a call's old name the caller's."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from std_msgs.msg import String

import rclpy
from rclpy.context import Context
from rclpy.event_handler import QoSEventHandler, QoSPublisherEventType
from rclpy.executors import MultiThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import HistoryPolicy, QoSProfile
from rclpy.task import Future


def one_thread(world: Any) -> None:
    MultiThreadedExecutor(1, context=world.context).shutdown()


def entered(_world: Any) -> None:
    with Context():
        pass


def failing_callback(_world: Any) -> None:
    future: Future[int] = Future()
    future.add_done_callback(lambda _: 1 / 0)
    future.set_result(1)


def wrong_answer(world: Any) -> None:
    node = world.node("n")
    node.declare_parameter("p", 1)
    node.add_on_set_parameters_callback(lambda _: None)
    node.set_parameters([Parameter("p", value=2)])


def old_handler(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(String, "t", 1)
    QoSEventHandler(
        callback_group=node.default_callback_group,
        callback=print,
        event_type=QoSPublisherEventType.RCL_PUBLISHER_MATCHED,
        parent_impl=publisher.handle,
    )


@pytest.mark.parametrize(
    ("cause", "told", "category", "own"),
    [
        (one_thread, "MultiThreadedExecutor is used with a single thread", UserWarning, True),
        (entered, "init() must be called on a Context", UserWarning, True),
        (failing_callback, "Unhandled exception in done callback: division by zero", UserWarning, True),
        (wrong_answer, "Callback returned an invalid type", UserWarning, True),
        (
            lambda world: world.node("n").declare_parameter("p"),
            "declaring a parameter only providing",
            UserWarning,
            True,
        ),
        (
            lambda _: QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=0),
            "A zero depth with KEEP_LAST",
            UserWarning,
            True,
        ),
        (
            lambda _: HistoryPolicy.RMW_QOS_POLICY_HISTORY_KEEP_ALL,
            "is deprecated. Use HistoryPolicy",
            UserWarning,
            True,
        ),
        (old_handler, "QoSEventHandler is deprecated, use EventHandler", DeprecationWarning, False),
        (lambda world: world.node("n").get_logger().warn("x"), "Deprecated in favor of", DeprecationWarning, False),
    ],
)
def test_a_warning_names_the_line_it_is_about(
    world: Any, cause: Callable[[Any], object], told: str, category: type[Warning], own: bool
) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        cause(world)
    places = [(each.category, Path(each.filename)) for each in caught if told in str(each.message)]
    assert len(places) == 1
    assert places[0][0] is category
    if own:
        assert Path(rclpy.__file__).parent in places[0][1].parents
    else:
        assert places[0][1] == Path(__file__)
