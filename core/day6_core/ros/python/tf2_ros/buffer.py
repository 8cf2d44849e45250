"""The transform buffer of nodes."""

from __future__ import annotations

import threading
from collections.abc import Callable
from time import sleep
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import TransformStamped
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

import rclpy.logging
from rclpy.clock import Clock, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.task import Future
from rclpy.time import Time
from tf2_ros.buffer_interface import NO_WAIT, BufferInterface

if TYPE_CHECKING:
    from rclpy.node import Node

_PERIOD_S = 0.02
"""Seconds between two tries of a waiting lookup (tf2_ros/buffer.py)."""


class Buffer(BufferCore, BufferInterface):
    """Stores the transforms of a `TransformListener`; with a `node` it offers the service `tf2_frames` (YAML).

    A lookup with a timeout blocks. In a callback of a single-threaded executor it waits in vain, because the listener's
    callback can't run meanwhile.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self._new_data_callbacks: list[Callable[[], None]] = []
        self._callbacks_to_remove: list[Callable[[], None]] = []
        self._callbacks_lock = threading.RLock()
        self.clock: Clock
        if node is not None:
            self.srv = node.create_service(FrameGraph, "tf2_frames", self._serve_frames)
            self.clock = node.get_clock()
        else:
            self.clock = Clock()
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True)
        self.jump_handle = self.clock.create_jump_callback(threshold, post_callback=self.time_jump_callback)

    def _serve_frames(self, _request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def time_jump_callback(self, time_jump: TimeJump) -> None:
        """Clear the buffer, because simulated time jumped back, started or ended."""
        rclpy.logging.get_logger("tf2_buffer").warning("Detected jump back in time. Clearing tf buffer.")
        self.clear()

    # -- storing -------------------------------------------------------------------------------------------------------

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform and notify waiting lookups; see BufferCore."""
        super().set_transform(transform, authority)
        self._call_new_data_callbacks()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Store a static transform and notify waiting lookups; see BufferCore."""
        super().set_transform_static(transform, authority)
        self._call_new_data_callbacks()

    def _call_new_data_callbacks(self) -> None:
        with self._callbacks_lock:
            for callback in self._new_data_callbacks:
                callback()
            # Only now, because a finished callback must not change the list during the loop above.
            for callback in self._callbacks_to_remove:
                self._new_data_callbacks.remove(callback)
            self._callbacks_to_remove.clear()

    def _remove_callback(self, callback: Callable[[], None]) -> None:
        with self._callbacks_lock:
            self._callbacks_to_remove.append(callback)

    # -- looking up ----------------------------------------------------------------------------------------------------

    def lookup_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform from the source to the target frame at `time` (0: the latest common time).

        Blocks up to `timeout` until there is one. Raises LookupException, ConnectivityException, ExtrapolationException or
        InvalidArgumentException, all of them TransformExceptions.
        """
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> TransformStamped:
        """Return the transform as soon as there is one; see `lookup_transform`."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform between two frames at two times through `fixed_frame`; see `lookup_transform`."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> TransformStamped:
        """Return the transform as soon as there is one; see `lookup_transform_full`."""
        await self.wait_for_transform_full_async(target_frame, target_time, source_frame, source_time, fixed_frame)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Return 1 if there is a transform within `timeout`, else 0; or a tuple of that and the reason."""
        return _waited_for(
            lambda: self.can_transform_core(target_frame, source_frame, time), timeout, return_debug_tuple
        )

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Like `can_transform`, for `lookup_transform_full`."""
        return _waited_for(
            lambda: self.can_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame),
            timeout,
            return_debug_tuple,
        )

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future[TransformStamped]:
        """Return a future that gets the transform once there is one."""
        return self._wait_for(
            lambda: self.can_transform_core(target_frame, source_frame, time)[0],
            lambda: self.lookup_transform(target_frame, source_frame, time),
        )

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Future[TransformStamped]:
        """Like `wait_for_transform_async`, for `lookup_transform_full`."""
        arguments = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._wait_for(
            lambda: self.can_transform_full_core(*arguments)[0], lambda: self.lookup_transform_full_core(*arguments)
        )

    def _wait_for(
        self, is_possible: Callable[[], int], lookup: Callable[[], TransformStamped]
    ) -> Future[TransformStamped]:
        future: Future[TransformStamped] = Future()
        if is_possible():
            future.set_result(lookup())
            return future

        def on_new_data() -> None:
            try:
                if not future.done() and is_possible():
                    future.set_result(lookup())
            except Exception as error:
                future.set_exception(error)

        with self._callbacks_lock:
            self._new_data_callbacks.append(on_new_data)
        future.add_done_callback(lambda _: self._remove_callback(on_new_data))
        return future


def _waited_for(check: Callable[[], tuple[int, str]], timeout: Duration, with_reason: bool) -> Any:
    """Repeat `check` until it succeeds or `timeout` has passed; returns its last result."""
    if timeout != Duration():
        clock = Clock()
        start = clock.now()
        # A clock that jumps far back (a bag that plays in a loop) ends the wait too.
        while clock.now() < start + timeout and not check()[0] and clock.now() + Duration(seconds=3.0) >= start:
            sleep(_PERIOD_S)
    result = check()
    return result if with_reason else result[0]
