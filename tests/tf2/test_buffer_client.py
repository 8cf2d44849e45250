"""BufferClient against an action server that answers from a buffer."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from typing import Any

import pytest
import tf2_ros
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error

import rclpy
from rclpy.action import ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from tests.support.waiting import PATIENCE
from tests.tf2.conftest import stamped

CODES = {
    tf2_ros.LookupException: TF2Error.LOOKUP_ERROR,
    tf2_ros.ConnectivityException: TF2Error.CONNECTIVITY_ERROR,
    tf2_ros.ExtrapolationException: TF2Error.EXTRAPOLATION_ERROR,
    tf2_ros.InvalidArgumentException: TF2Error.INVALID_ARGUMENT_ERROR,
}


def answer(buffer: tf2_ros.Buffer, goal_handle: Any) -> Any:
    goal, result = goal_handle.request, LookupTransform.Result()
    try:
        if goal.advanced:
            result.transform = buffer.lookup_transform_full(
                goal.target_frame, goal.target_time, goal.source_frame, goal.source_time, goal.fixed_frame
            )
        else:
            result.transform = buffer.lookup_transform(goal.target_frame, goal.source_frame, goal.source_time)
    except tf2_ros.TransformException as error:
        result.error.error = CODES[type(error)]
        result.error.error_string = str(error)
    goal_handle.succeed()
    return result


@pytest.fixture
def client(ros: None) -> Iterator[tf2_ros.BufferClient]:
    node = Node("server_and_client")
    buffer = tf2_ros.Buffer()
    for second in (1, 3):
        buffer.set_transform(stamped("world", "car", second, (second, 0, 0)), "test")
    buffer.set_transform_static(stamped("island", "palm"), "test")
    group = ReentrantCallbackGroup()
    server = ActionServer(node, LookupTransform, "lookup", lambda goal: answer(buffer, goal), callback_group=group)
    client = tf2_ros.BufferClient(node, "lookup", check_frequency=100.0, timeout_padding=Duration(seconds=PATIENCE))
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    yield client
    executor.shutdown()
    thread.join(5)
    client.destroy()
    server.destroy()
    node.destroy_node()


@pytest.mark.process
def test_a_client_gets_the_servers_transform(client: tf2_ros.BufferClient) -> None:
    assert client.lookup_transform("world", "car", Time(seconds=2)).transform.translation.x == 2.0
    full = client.lookup_transform_full("car", Time(seconds=3), "car", Time(seconds=1), "world", Duration(seconds=1))
    assert full.transform.translation.x == -2.0
    assert client.can_transform("world", "car", Time()) is True
    assert client.can_transform("world", "palm", Time()) is False


@pytest.mark.process
@pytest.mark.parametrize(
    ("target", "source", "seconds", "kind"),
    [
        ("world", "nowhere", 0, tf2_ros.LookupException),
        ("world", "palm", 0, tf2_ros.ConnectivityException),
        ("world", "car", 9, tf2_ros.ExtrapolationException),
        ("/world", "car", 0, tf2_ros.InvalidArgumentException),
    ],
)
def test_the_servers_errors_are_raised_by_the_client(
    client: tf2_ros.BufferClient, target: str, source: str, seconds: int, kind: type[Exception]
) -> None:
    with pytest.raises(kind) as caught:
        client.lookup_transform(target, source, Time(seconds=seconds))
    assert type(caught.value) is kind and str(caught.value)


def test_without_a_server_a_client_gives_up_at_once(node: Node) -> None:
    lonely = tf2_ros.BufferClient(node, "nobody")
    with pytest.raises(tf2_ros.TimeoutException, match=r"^The BufferServer is not ready\.$"):
        lonely.lookup_transform("a", "b", Time())
    with pytest.raises(TypeError, match=r"^Must pass a rclpy\.time\.Time object\.$"):
        lonely.lookup_transform("a", "b", 0.0)  # type: ignore[arg-type]
    lonely.destroy()


def test_actions_are_an_attribute_of_rclpy_once_the_client_is_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(rclpy, "action", raising=False)
    assert rclpy.action.ActionServer.__name__ == "ActionServer"
    monkeypatch.delitem(sys.modules, "tf2_ros.buffer_client")
    with pytest.raises(AttributeError, match="action"):
        rclpy.action  # noqa: B018
