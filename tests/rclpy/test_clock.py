"""Clocks: kinds, jumps and who is told of them, sleeping, simulated time."""

from __future__ import annotations

import gc
from typing import Any

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rosgraph_msgs.msg import Clock as ClockMessage

from rclpy.clock import Clock, ClockChange, JumpThreshold, ROSClock, TimeJump
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import InvalidParameterValueException, NotInitializedException
from rclpy.logging import LoggingSeverity
from rclpy.parameter import Parameter
from rclpy.qos import ReliabilityPolicy
from rclpy.time import Time
from rclpy.time_source import TimeSource

SECOND = 1_000_000_000


def at(seconds: float) -> Time:
    return Time(seconds=seconds, clock_type=ClockType.ROS_TIME)


def simulated(seconds: float = 0.0) -> ROSClock:
    """Return a clock on simulated time."""
    clock = ROSClock()
    clock.set_ros_time_override(at(seconds))
    clock._set_ros_time_is_active(True)
    return clock


@pytest.mark.parametrize("kind", [ClockType.SYSTEM_TIME, ClockType.STEADY_TIME, ClockType.ROS_TIME])
def test_a_clock_tells_the_time_of_its_kind(kind: ClockType) -> None:
    clock = Clock(clock_type=kind)
    assert clock.clock_type == kind
    assert clock.now().clock_type == kind
    assert clock.now() <= clock.now()
    assert isinstance(clock, ROSClock) == (kind is ClockType.ROS_TIME)
    assert repr(clock) == f"Clock(clock_type={kind.name})"


def test_a_clock_shows_the_systems_time_unless_told_otherwise() -> None:
    assert Clock().clock_type == ClockType.SYSTEM_TIME
    with pytest.raises(TypeError, match="Clock type must be a ClockType enum"):
        Clock(clock_type="STEADY_TIME")  # type: ignore[arg-type]


def test_simulated_time_counts_while_it_is_active() -> None:
    clock = ROSClock()
    clock.set_ros_time_override(at(42))
    assert not clock.ros_time_is_active
    assert clock.now() > at(1_000_000)
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert clock.now() == at(42)
    clock.set_ros_time_override(at(43))
    assert clock.now() == at(43)
    clock._set_ros_time_is_active(False)
    assert clock.now() > at(1_000_000)
    with pytest.raises(TypeError, match=r"Time must be specified as rclpy.time.Time. Received type: <class 'int'>"):
        clock.set_ros_time_override(5)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("forward", "backward", "on_change", "message"),
    [
        (0, None, True, "min_forward must be a positive non-zero duration"),
        (-1, None, True, "min_forward must be a positive non-zero duration"),
        (None, 0, True, "min_backward must be a negative non-zero duration"),
        (None, 1, True, "min_backward must be a negative non-zero duration"),
        (None, None, False, "At least one jump threshold must be enabled"),
    ],
)
def test_a_threshold_needs_a_direction(
    forward: int | None, backward: int | None, on_change: bool, message: str
) -> None:
    def span(nanoseconds: int | None) -> Duration | None:
        return None if nanoseconds is None else Duration(nanoseconds=nanoseconds)

    with pytest.raises(ValueError, match=message):
        JumpThreshold(min_forward=span(forward), min_backward=span(backward), on_clock_change=on_change)


def test_a_threshold_for_changes_of_the_clock_alone_is_enough() -> None:
    threshold = JumpThreshold(min_forward=None, min_backward=None)
    assert threshold.on_clock_change is True
    assert JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None, on_clock_change=False)
    assert JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=False)


@pytest.mark.parametrize(
    ("start", "end", "told"),
    [(10, 12, True), (10, 11.999, False), (10, 9, True), (10, 9.001, False), (10, 10, False), (10, 30, True)],
)
def test_a_jump_is_told_when_it_reaches_the_threshold(start: float, end: float, told: bool) -> None:
    clock = simulated(start)
    heard: list[Any] = []
    threshold = JumpThreshold(min_forward=Duration(seconds=2), min_backward=Duration(seconds=-1), on_clock_change=False)
    handle = clock.create_jump_callback(
        threshold, pre_callback=lambda: heard.append(clock.now()), post_callback=heard.append
    )
    clock.set_ros_time_override(at(end))
    assert clock.now() == at(end)
    if told:
        before, jump = heard
        assert before == at(start), "the first callback still sees the old time"
        assert jump.clock_change == ClockChange.ROS_TIME_NO_CHANGE
        assert jump.delta == at(end) - at(start)
    else:
        assert heard == []
    handle.unregister()


@pytest.mark.parametrize(
    ("threshold", "jump", "told"),
    [
        (JumpThreshold(min_forward=Duration(seconds=1), min_backward=None), -5, False),
        (JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1)), 5, False),
        (JumpThreshold(min_forward=None, min_backward=None), 5, False),
        (JumpThreshold(min_forward=Duration(seconds=1), min_backward=None), 1, True),
        (JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1)), -1, True),
    ],
)
def test_a_threshold_for_one_direction_says_nothing_of_the_other(
    threshold: JumpThreshold, jump: int, told: bool
) -> None:
    clock = simulated(10)
    heard: list[TimeJump] = []
    handle = clock.create_jump_callback(threshold, post_callback=heard.append)
    clock.set_ros_time_override(at(10 + jump))
    assert [each.delta.nanoseconds for each in heard] == ([jump * SECOND] if told else [])
    handle.unregister()


@pytest.mark.parametrize("wanted", [True, False])
def test_switching_to_simulated_time_and_back_is_a_change_of_the_clock(wanted: bool) -> None:
    clock = ROSClock()
    clock.set_ros_time_override(at(10))
    heard: list[tuple[ClockChange, int]] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None, on_clock_change=wanted)
    with clock.create_jump_callback(
        threshold, post_callback=lambda jump: heard.append((jump.clock_change, jump.delta.nanoseconds))
    ):
        clock._set_ros_time_is_active(True)
        clock._set_ros_time_is_active(True)
        clock._set_ros_time_is_active(False)
    expected = [(ClockChange.ROS_TIME_ACTIVATED, 0), (ClockChange.ROS_TIME_DEACTIVATED, 0)]
    assert heard == (expected if wanted else [])


def test_nobody_is_told_after_the_handle_was_given_back() -> None:
    clock = simulated(10)
    heard: list[int] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    first = clock.create_jump_callback(threshold, pre_callback=lambda: heard.append(1))
    with clock.create_jump_callback(threshold, pre_callback=lambda: heard.append(2)):
        clock.set_ros_time_override(at(11))
    clock.set_ros_time_override(at(12))
    first.unregister()
    first.unregister()
    clock.set_ros_time_override(at(13))
    assert sorted(heard) == [1, 1, 2]


def test_a_jump_callback_must_be_one() -> None:
    clock = ROSClock()
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    with pytest.raises(ValueError, match="One of pre_callback or post_callback must be callable"):
        clock.create_jump_callback(threshold)
    with pytest.raises(ValueError, match="pre_callback must be callable if given"):
        clock.create_jump_callback(threshold, pre_callback=5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"clock_change must be an instance of rclpy.clock.ClockChange"):
        TimeJump("ROS_TIME_ACTIVATED", Duration())  # type: ignore[arg-type]


def test_sleeping_until_a_time_that_is_over_ends_at_once() -> None:
    context = Context()
    clock = Clock(clock_type=ClockType.STEADY_TIME)
    with pytest.raises(NotInitializedException):
        clock.sleep_until(clock.now(), context)
    context.init([])
    assert clock.sleep_until(clock.now(), context)
    assert clock.sleep_for(Duration(nanoseconds=1000), context)
    before = clock.now()
    assert clock.sleep_for(Duration(seconds=0.02), context)
    assert clock.now() - before >= Duration(seconds=0.02)
    with pytest.raises(ValueError, match="until's clock type does not match this clock's type"):
        clock.sleep_until(Time(), context)
    context.shutdown()
    with pytest.raises(NotInitializedException):
        clock.sleep_for(Duration(seconds=1), context)


def test_a_sleep_on_simulated_time_ends_when_that_time_comes(world: Any) -> None:
    from threading import Thread

    clock = simulated(10)
    outcome: list[bool] = []
    thread = Thread(target=lambda: outcome.append(clock.sleep_for(Duration(seconds=5), world.context)), daemon=True)
    thread.start()
    second = 10
    while thread.is_alive() and second < 1000:
        second += 1
        clock.set_ros_time_override(at(second))
        thread.join(0.01)
    assert outcome == [True]
    assert second >= 15


def test_a_sleep_fails_when_the_source_of_the_time_changes_or_the_context_ends(world: Any) -> None:
    from threading import Thread

    for end in (lambda clock: clock._set_ros_time_is_active(False), lambda _clock: world.context.shutdown()):
        clock = simulated(10)
        outcome: list[bool] = []
        thread = Thread(target=lambda: outcome.append(clock.sleep_for(Duration(seconds=5), world.context)), daemon=True)  # noqa: B023
        thread.start()
        thread.join(0.05)
        end(clock)
        thread.join(5)
        assert outcome == [False]


def test_a_node_with_use_sim_time_follows_the_topic_clock(world: Any) -> None:
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
    other = world.node("other")
    publisher = other.create_publisher(ClockMessage, "/clock", 1)
    assert node.get_clock().ros_time_is_active
    assert node.get_clock().now() == at(0)
    assert not other.get_clock().ros_time_is_active
    publisher.publish(ClockMessage(clock=at(33.5).to_msg()))
    world.settle()
    assert node.get_clock().now() == at(33.5)
    assert other.get_clock().now() > at(1_000_000)


def test_use_sim_time_is_switched_on_and_off(world: Any) -> None:
    node = world.node("n")
    assert node.get_parameter("use_sim_time").value is False
    assert node.count_subscribers("/clock") == 0
    assert node.set_parameters([Parameter("use_sim_time", value=True)])[0].successful
    assert node.get_clock().ros_time_is_active
    assert node.count_subscribers("/clock") == 1
    assert node.set_parameters([Parameter("use_sim_time", value=False)])[0].successful
    assert not node.get_clock().ros_time_is_active
    assert node.count_subscribers("/clock") == 0
    result = node.set_parameters([Parameter("use_sim_time", value=5)])[0]
    assert (result.successful, result.reason) == (False, "Wrong parameter type, expected '1' got '2'")


def test_a_time_source_feeds_the_clocks_attached_to_it(world: Any) -> None:
    source = TimeSource(node=world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)]))
    clock, late = ROSClock(), ROSClock()
    source.attach_clock(clock)
    assert source.ros_time_is_active
    source.clock_callback(ClockMessage(clock=at(7).to_msg()))
    assert clock.now() == at(7)
    source.attach_clock(late)
    assert late.now() == at(7)
    assert late.ros_time_is_active
    source.ros_time_is_active = False
    assert not clock.ros_time_is_active
    source.detach_node()
    for wrong in (Clock(clock_type=ClockType.STEADY_TIME), Clock()):
        with pytest.raises(ValueError, match=r"Only clocks with type ROS_TIME can be attached."):
            source.attach_clock(wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"Node must be of type rclpy.node.Node"):
        source.attach_node("n")  # type: ignore[arg-type]


def test_a_time_source_without_a_node_shows_the_systems_time() -> None:
    source = TimeSource()
    clock = ROSClock()
    source.attach_clock(clock)
    assert not source.ros_time_is_active
    assert clock.now() > at(1_000_000)


def test_a_use_sim_time_that_is_no_truth_value_is_refused(world: Any) -> None:
    node = world.node("n")
    node.undeclare_parameter("use_sim_time")
    with pytest.raises(InvalidParameterValueException, match="use_sim_time parameter set to something besides a bool"):
        node.declare_parameter("use_sim_time", 5)


def test_a_source_moves_to_another_node(world: Any) -> None:
    one, two = world.node("one", parameter_overrides=[Parameter("use_sim_time", value=True)]), world.node("two")
    source = TimeSource(node=one)
    assert one.count_subscribers("/clock") == 2
    source.attach_node(two)
    assert one.count_subscribers("/clock") == 1
    assert not source.ros_time_is_active


@pytest.mark.parametrize("given", [True, False])
def test_a_source_without_a_node_subscribes_once_it_has_one(world: Any, given: bool) -> None:
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=given)])
    own = node.count_subscribers("/clock")
    source = TimeSource()
    clock = ROSClock()
    source.attach_clock(clock)
    source.ros_time_is_active = True
    source.ros_time_is_active = False
    source.detach_node()
    assert node.count_subscribers("/clock") == own == given
    source.attach_node(node)
    assert source.ros_time_is_active is given
    assert clock.ros_time_is_active is given
    assert node.count_subscribers("/clock") == 2 * given
    node.set_parameters([Parameter("use_sim_time", value=not given)])
    assert clock.ros_time_is_active is not given
    assert node.count_subscribers("/clock") == 2 * (not given)
    source.ros_time_is_active = not given
    assert node.count_subscribers("/clock") == 2 * (not given), "nothing changes twice"
    source.attach_clock(clock)
    source.detach_node()
    assert node.count_subscribers("/clock") == (not given)


def test_a_source_hears_the_latest_time_of_its_topic(world: Any) -> None:
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
    clock = ROSClock()
    source = TimeSource(node=node)
    source.attach_clock(clock)
    (info, *_) = node.get_subscriptions_info_by_topic("/clock")
    assert info.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    publisher = node.create_publisher(ClockMessage, "/clock", 10)
    for second in (3, 4, 5):
        publisher.publish(ClockMessage(clock=at(second).to_msg()))
    heard: list[Any] = []
    handle = clock.create_jump_callback(
        JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None), post_callback=heard.append
    )
    world.settle()
    assert clock.now() == at(5)
    assert len(heard) == 1, "one message is kept"
    handle.unregister()


def test_a_source_whose_node_is_gone_cannot_give_its_subscription_back(world: Any) -> None:
    from rclpy.node import Node

    node = Node("n", context=world.context, parameter_overrides=[Parameter("use_sim_time", value=True)])
    source = TimeSource(node=node)
    node.destroy_node()
    del node
    gc.collect()
    with pytest.raises(RuntimeError, match="Unable to destroy previously created clock subscription"):
        source.detach_node()
    source.ros_time_is_active = False
    with pytest.raises(RuntimeError, match="Unable to destroy previously created clock subscription"):
        source.detach_node()


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (None, "'use_sim_time' parameter not set, using wall time by default"),
        ("yes", "Invalid type for parameter 'use_sim_time' <Type.STRING: 4> should be bool"),
    ],
)
def test_a_source_tells_of_a_parameter_that_is_no_truth_value(world: Any, value: Any, told: str) -> None:
    from rclpy.node import Node

    class Heedless(Node):
        """Asks nobody whether its parameters may be set until it is made: not its own clock's source either."""

        made = False

        def add_on_set_parameters_callback(self, callback: Any) -> None:
            if self.made:
                super().add_on_set_parameters_callback(callback)

    node = Heedless("n", context=world.context, allow_undeclared_parameters=True)
    node.made = True
    node.get_logger().set_level(LoggingSeverity.DEBUG)
    node.undeclare_parameter("use_sim_time")
    node.declare_parameter("use_sim_time", value, ParameterDescriptor(dynamic_typing=True))
    world.log.clear()
    source = TimeSource(node=node)
    assert any(told in line for line in world.log), world.log
    assert not source.ros_time_is_active
    result = node.set_parameters([Parameter("use_sim_time", value=5)])[0]
    assert (result.successful, result.reason) == (False, "use_sim_time parameter set to something besides a bool")
    assert "[ERROR]" in world.log[-1]
    assert "use_sim_time parameter set to something besides a bool" in world.log[-1]
    assert node.set_parameters([Parameter("other", value=5)])[0].successful
    assert node.set_parameters([Parameter("use_sim_time", value=True)])[0].successful
    assert source.ros_time_is_active
