"""Callbacks when the time jumps."""

import rclpy
from rclpy.clock import Clock, ClockType, JumpThreshold, ROSClock
from rclpy.duration import Duration
from rclpy.time import Time

clock = ROSClock()
print(type(clock).__name__, clock.clock_type, clock.ros_time_is_active)
threshold = JumpThreshold(min_forward=Duration(seconds=1), min_backward=Duration(seconds=-1), on_clock_change=True)
handle = clock.create_jump_callback(
    threshold,
    pre_callback=lambda: print("before"),
    post_callback=lambda jump: print("after", jump.clock_change, jump.delta.nanoseconds),
)
clock._set_ros_time_is_active(True)
for seconds in (10, 10.5, 12, 3):
    print("set", seconds)
    clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
    print(clock.now())
handle.unregister()
clock.set_ros_time_override(Time(seconds=100, clock_type=ClockType.ROS_TIME))
print("no callback any more")
for wrong in (
    dict(min_forward=None, min_backward=None, on_clock_change=False),
    dict(min_forward=Duration(seconds=-1), min_backward=None),
    dict(min_forward=None, min_backward=Duration(seconds=1)),
):
    try:
        JumpThreshold(**wrong)
    except ValueError as error:
        print("ValueError", error)
steady = Clock(clock_type=ClockType.STEADY_TIME)
first = steady.now()
print(steady.now() >= first, first.clock_type)
print(steady.sleep_for(Duration(seconds=0.01), context=None) if rclpy.ok() else "not initialised")
