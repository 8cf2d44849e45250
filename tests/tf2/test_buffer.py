"""Buffer, listener and broadcasters on real nodes, and what it means to wait for a transform."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
import tf2_ros
from builtin_interfaces.msg import Time as TimeMsg
from geometry_msgs.msg import PointStamped, Pose, PoseStamped, TransformStamped
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph

import rclpy
from day6_core.ros.environment import program_environment
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy
from rclpy.time import Time
from tests.support.waiting import until
from tests.tf2.conftest import stamped


def spin_until(node: Node, condition: Callable[[], object]) -> None:
    until(condition, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))


def test_what_is_broadcast_can_be_looked_up(node: Node) -> None:
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    tf2_ros.TransformBroadcaster(node).sendTransform(
        [stamped("world", "a", 1, (1, 0, 0)), stamped("a", "b", 1, (0, 2, 0))]
    )
    tf2_ros.StaticTransformBroadcaster(node).sendTransform(stamped("b", "c", 0, (0, 0, 3)))
    spin_until(node, lambda: buffer.can_transform("world", "c", Time()))
    offset = buffer.lookup_transform("world", "c", Time()).transform.translation
    assert (offset.x, offset.y, offset.z) == (1.0, 2.0, 3.0)


def test_fixed_frames_reach_those_who_come_later_all_of_them(node: Node) -> None:
    broadcaster = tf2_ros.StaticTransformBroadcaster(node)
    broadcaster.sendTransform(stamped("world", "a"))
    broadcaster.sendTransform((stamped("world", "b"), stamped("world", "c")))
    heard: list[TFMessage] = []
    late = Node("late")
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, late)
    late.create_subscription(TFMessage, "/tf_static", heard.append, tf2_qos())
    spin_until(late, lambda: heard)
    assert [each.child_frame_id for each in heard[0].transforms] == ["a", "b", "c"]
    spin_until(late, lambda: buffer.can_transform("a", "c", Time()))
    late.destroy_node()


def tf2_qos() -> Any:
    return rclpy.qos.QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def test_the_first_fixed_transform_of_a_frame_stays_as_in_the_real_package(node: Node) -> None:
    broadcaster = tf2_ros.StaticTransformBroadcaster(node)
    broadcaster.sendTransform(stamped("world", "a", 0, (1, 0, 0)))
    broadcaster.sendTransform(stamped("world", "a", 0, (2, 0, 0)))
    assert [each.transform.translation.x for each in broadcaster.net_message.transforms] == [1.0]


def test_topics_and_qos_are_those_of_tf(node: Node) -> None:
    tf2_ros.TransformListener(tf2_ros.Buffer(), node)
    tf2_ros.TransformBroadcaster(node)
    tf2_ros.StaticTransformBroadcaster(node)
    (moving,) = node.get_publishers_info_by_topic("/tf")
    (fixed,) = node.get_publishers_info_by_topic("/tf_static")
    assert moving.qos_profile.durability is DurabilityPolicy.VOLATILE
    assert fixed.qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
    (listener,) = node.get_subscriptions_info_by_topic("/tf_static")
    assert listener.qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL


def test_a_listener_may_hear_other_topics_or_fixed_frames_only(node: Node) -> None:
    tf2_ros.TransformListener(tf2_ros.Buffer(), node, tf_topic="/my_tf", tf_static_topic="/my_static")
    assert node.count_subscribers("/my_tf") == node.count_subscribers("/my_static") == 1
    listener = tf2_ros.TransformListener(tf2_ros.Buffer(), node, static_only=True)
    assert (node.count_subscribers("/tf"), node.count_subscribers("/tf_static")) == (0, 1)
    listener.unregister()
    assert node.count_subscribers("/tf_static") == 0


@pytest.mark.process
def test_a_lookup_in_a_callback_waits_in_vain_with_one_thread(node: Node) -> None:
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    broadcaster = tf2_ros.TransformBroadcaster(node)
    outcome: list[object] = []

    def look() -> None:
        broadcaster.sendTransform(stamped("world", "car", 1))
        start = time.monotonic()
        try:
            outcome.append(buffer.lookup_transform("world", "car", Time(), Duration(seconds=0.2)))
        except tf2_ros.LookupException as error:
            outcome.append((str(error), time.monotonic() - start >= 0.2))

    timer = node.create_timer(0.001, look)
    spin_until(node, lambda: outcome)
    timer.cancel()
    assert outcome == [('"world" passed to lookupTransform argument target_frame does not exist. ', True)]
    spin_until(node, lambda: buffer.can_transform("world", "car", Time()))


def test_a_lookup_in_a_callback_succeeds_with_several_threads(node: Node) -> None:
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    broadcaster = tf2_ros.TransformBroadcaster(node)
    outcome: list[TransformStamped] = []

    def look() -> None:
        timer.cancel()
        broadcaster.sendTransform(stamped("world", "car", 1))
        outcome.append(buffer.lookup_transform("world", "car", Time(), Duration(seconds=5)))

    timer = node.create_timer(0.001, look, callback_group=MutuallyExclusiveCallbackGroup())
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(node)
    until(lambda: outcome, meanwhile=lambda: executor.spin_once(timeout_sec=0.05))
    executor.shutdown()
    assert outcome[0].child_frame_id == "car"


@pytest.mark.process
def test_a_listener_with_its_own_thread_hears_while_the_program_waits(ros: None) -> None:
    node = Node("own_thread")
    buffer = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
    tf2_ros.TransformBroadcaster(node).sendTransform(stamped("world", "car", 1))
    found = buffer.lookup_transform("world", "car", Time(), Duration(seconds=5))
    assert found.header.stamp.sec == 1
    listener.executor.shutdown()
    listener.dedicated_listener_thread.join(5)
    assert not listener.dedicated_listener_thread.is_alive()
    node.destroy_node()


def test_a_future_gets_the_transform_when_it_comes(node: Node) -> None:
    buffer = tf2_ros.Buffer()
    future = buffer.wait_for_transform_async("world", "car", Time(seconds=2))
    buffer.set_transform(stamped("world", "car", 1), "test")
    assert not future.done()
    buffer.set_transform(stamped("world", "car", 3, (2, 0, 0)), "test")
    assert future.done() and future.result().transform.translation.x == 1.0
    assert buffer._new_data_callbacks == []
    assert buffer.wait_for_transform_async("world", "car", Time()).done()
    full = buffer.wait_for_transform_full_async("car", Time(seconds=3), "car", Time(seconds=1), "world")
    assert full.result().transform.translation.x == -2.0


def test_a_coroutine_awaits_a_transform(node: Node) -> None:
    buffer = tf2_ros.Buffer()
    tf2_ros.TransformListener(buffer, node)
    executor = SingleThreadedExecutor()
    executor.add_node(node)

    async def look() -> TransformStamped:
        return await buffer.lookup_transform_async("world", "car", Time())

    task = executor.create_task(look)
    executor.spin_once(timeout_sec=0.01)
    assert not task.done()
    tf2_ros.TransformBroadcaster(node).sendTransform(stamped("world", "car", 7))
    executor.spin_until_future_complete(task, timeout_sec=5)
    assert task.result().header.stamp.sec == 7
    executor.shutdown()


def test_can_transform_answers_with_a_number_and_on_request_with_the_reason() -> None:
    buffer = tf2_ros.Buffer()
    reason = 'Invalid frame ID "a" passed to canTransform argument target_frame - frame does not exist'
    assert buffer.can_transform("a", "b", Time()) == 0
    assert buffer.can_transform("a", "b", Time(), return_debug_tuple=True) == (0, reason)
    assert buffer.can_transform_full("a", Time(), "b", Time(), "c", return_debug_tuple=True) == (0, reason)
    with pytest.raises(TypeError):
        buffer.lookup_transform("a", "b", Time(), 1.0)  # type: ignore[arg-type]


def test_the_service_tf2_frames_answers_with_yaml(node: Node) -> None:
    buffer = tf2_ros.Buffer(node=node)
    buffer.set_transform_static(stamped("world", "car"), "somebody")
    future = node.create_client(FrameGraph, "tf2_frames").call_async(FrameGraph.Request())
    spin_until(node, future.done)
    assert future.result().frame_yaml == buffer.all_frames_as_yaml()
    assert "broadcaster: 'somebody'" in future.result().frame_yaml


def test_a_jump_of_time_clears_the_buffer(capfd: pytest.CaptureFixture[str], node: Node) -> None:
    buffer = tf2_ros.Buffer(node=node)
    buffer.set_transform(stamped("world", "car", 1), "test")
    node.set_parameters([rclpy.Parameter("use_sim_time", value=True)])
    assert buffer.can_transform("world", "car", Time()) == 0
    assert capfd.readouterr().err.endswith("[tf2_buffer]: Detected jump back in time. Clearing tf buffer.\n")


def test_an_unregistered_type_cannot_be_transformed() -> None:
    buffer = tf2_ros.Buffer()
    with pytest.raises(tf2_ros.TypeException) as caught:
        buffer.transform(Pose(), "world")
    assert caught.value.errstr == "Type <class 'geometry_msgs.msg._pose.Pose'> is not loaded or supported"
    with pytest.raises(tf2_ros.NotImplementedException):
        tf2_ros.BufferInterface().lookup_transform("a", "b", Time())


def test_stamped_and_convert() -> None:
    import tf2_geometry_msgs  # noqa: F401

    point = tf2_ros.Stamped(PointStamped(), TimeMsg(sec=3), "world")
    assert (point.header.stamp.sec, point.header.frame_id) == (3, "world")
    twin = tf2_ros.convert(point, PointStamped)
    assert twin == point and twin is not point
    assert tf2_ros.convert(point, PoseStamped) is point  # as in the real package: both count as messages
    with pytest.raises(tf2_ros.TypeException):
        tf2_ros.convert(point, int)


def test_many_threads_may_use_one_buffer() -> None:
    buffer = tf2_ros.Buffer()
    buffer.set_transform(stamped("world", "car", 1), "test")
    problems: list[BaseException] = []

    def use(number: int) -> None:
        try:
            for tick in range(300):
                buffer.set_transform(stamped("world", f"f{number}", 1 + tick * 0.05), "test")
                buffer.lookup_transform(f"f{number}", "world", Time())
                buffer.all_frames_as_yaml()
        except BaseException as error:
            problems.append(error)

    threads = [threading.Thread(target=use, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert problems == []


@pytest.mark.process
@pytest.mark.parametrize(
    "statement",
    [
        "from tf2_ros.buffer import Buffer; import tf2_ros; assert Buffer is tf2_ros.Buffer",
        "from tf2_ros.transform_listener import TransformListener, DEFAULT_TF_TOPIC, DEFAULT_STATIC_TF_TOPIC",
        "from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster",
        "from tf2_ros.transform_broadcaster import TransformBroadcaster",
        "from tf2_ros.buffer_client import BufferClient",
        "from tf2_ros.buffer_interface import BufferInterface, Stamped, convert, TransformRegistration",
        "from tf2_ros import TransformStamped, TFMessage, Time, Duration, Node, QoSProfile, BufferClient, tf2, rclpy",
        "from tf2_ros import TransformException, LookupException, ConnectivityException, ExtrapolationException",
        "from tf2_py import BufferCore, TransformException, InvalidArgumentException, TimeoutException",
        "from tf2_geometry_msgs import do_transform_point, do_transform_pose, do_transform_pose_stamped, PointStamped",
        "import tf2_geometry_msgs.tf2_geometry_msgs as g; g.do_transform_vector3",
        "from message_filters import Subscriber, TimeSynchronizer, ApproximateTimeSynchronizer, Cache, SimpleFilter",
        "from tf_transformations import quaternion_from_euler, euler_from_quaternion; quaternion_from_euler(0, 0, 1)",
    ],
)
def test_import_paths_of_programs_work_without_heavy_modules(statement: str) -> None:
    check = "import sys; heavy = {'numpy', 'asyncio', 'yaml', 'zenoh'} & set(sys.modules); assert not heavy, heavy"
    subprocess.run([sys.executable, "-c", f"{statement}\n{check}"], env=program_environment(), check=True, timeout=60)
