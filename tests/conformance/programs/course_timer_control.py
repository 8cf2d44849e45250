"""Timers: cancelling, resetting, changing the period, asking for the time."""

import time

import rclpy

rclpy.init()
node = rclpy.create_node("timers")
calls = []
timer = node.create_timer(0.1, lambda: calls.append("tick"))
print(timer.timer_period_ns, timer.is_canceled(), timer.is_ready(), 0 < timer.time_until_next_call() <= 100_000_000)


def spin(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.01)


def spin_for(count):
    while len(calls) < count:
        rclpy.spin_once(node, timeout_sec=1.0)


start = time.monotonic()
spin_for(3)
print(len(calls), 0.25 < time.monotonic() - start)
timer.cancel()
spin(0.25)
print(len(calls), timer.is_canceled(), timer.time_until_next_call())
timer.timer_period_ns = 50_000_000
timer.reset()
spin_for(6)
timer.cancel()
print(len(calls), timer.timer_period_ns)
late = node.create_timer(0.05, lambda: calls.append("late"), autostart=False)
spin(0.12)
print("late" in calls)
late.reset()
spin_for(7)
print("late" in calls)
late.cancel()
print(node.destroy_timer(timer), node.destroy_timer(timer), len(list(node.timers)))
rclpy.shutdown()
