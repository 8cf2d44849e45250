"""A MultiThreadedExecutor and callbacks that fail: when spin says so, and what nobody is told."""

import sys
import threading
import time

import rclpy
from rclpy.executors import MultiThreadedExecutor


def play(title, callback, period=None, count=0):
    print("#", title, flush=True)
    rclpy.init()
    node = rclpy.create_node("pool")
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    calls = []

    def once():
        timer.cancel()
        callback()

    def again():
        calls.append(1)
        if len(calls) == count:
            callback()

    timer = node.create_timer(0.1, once if period is None else again)
    if period is not None and count == 0:
        node.create_timer(period, lambda: None)
        timer.callback = once
    threading.Timer(1.2, rclpy.try_shutdown).start()
    start = time.monotonic()
    try:
        executor.spin()
        print("spin returned")
    except BaseException as error:
        print("spin raised", repr(error))
    print("after", "1.2 s" if time.monotonic() - start > 1.1 else "0.6 s" if time.monotonic() - start > 0.55 else "less")
    executor.shutdown()
    for thread in threading.enumerate():
        if isinstance(thread, threading.Timer):
            thread.join()
    rclpy.try_shutdown()


def fail():
    raise ValueError("bad sensor")


def leave():
    sys.exit("enough")


play("nothing else to do", fail)
play("another timer later", fail, period=0.6)
play("a callback that exits", leave, period=0.6, count=3)
