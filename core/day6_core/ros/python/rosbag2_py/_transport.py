"""`Recorder` and `Player` for users' programs: they block until the end or Ctrl-C. Since Lyrical they are `_controlled`'s."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from rosbag2_py import also
from rosbag2_py._options import PlayOptions as PlayOptions
from rosbag2_py._options import RecordOptions as RecordOptions
from rosbag2_py._options import ServiceRequestsSource as ServiceRequestsSource
from rosbag2_py._storage import StorageOptions

if TYPE_CHECKING:
    from rclpy.node import Node

_LONGEST_WAIT = 0.1

_find = also("_transport")


def __getattr__(name: str) -> Any:
    if name not in ("Player", "Recorder"):
        return _find(name)
    if value("bag.controlled_classes"):
        from rosbag2_py import _controlled

        return getattr(_controlled, name)
    return BlockingPlayer if name == "Player" else BlockingRecorder


class _Transport:
    """A separate context and node, spun until the work is done or `cancel` is called."""

    _cancelled = False

    def __init__(self, log_level: str = "info") -> None:
        """Raise RuntimeError for a log level that doesn't exist."""
        from rclpy.context import Context

        self._log_level = log_level
        context = Context()
        context.init(args=["--ros-args", "--log-level", log_level])
        context.try_shutdown()

    @classmethod
    def cancel(cls) -> None:
        """End the recording or playback (from another thread)."""
        cls._cancelled = True

    def _run(
        self, name: str, arguments: list[str], begin: Callable[[Node], Callable[[], float | None]], **node: Any
    ) -> None:
        """Create the node, call `begin(node)`, then call its result repeatedly, each time after the seconds it returned."""
        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.node import Node

        type(self)._cancelled = False
        context = Context()
        context.init(args=["--ros-args", "--log-level", self._log_level])
        try:
            new_node = Node(name, context=context, cli_args=arguments, **node)
            executor = SingleThreadedExecutor(context=context)
            executor.add_node(new_node)
            step = begin(new_node)
            while context.ok() and not type(self)._cancelled and (pause := step()) is not None:
                executor.spin_once(timeout_sec=min(max(pause, 0.0), _LONGEST_WAIT))
        finally:
            context.try_shutdown()


class BlockingRecorder(_Transport):
    """Records bags: `Recorder().record(storage_options, record_options)`."""

    def record(
        self, storage_options: StorageOptions, record_options: RecordOptions, node_name: str = "rosbag2_recorder"
    ) -> None:
        """Record until `cancel` or Ctrl-C (KeyboardInterrupt)."""
        from rclpy.parameter import Parameter
        from rosbag2_py._recording import Recording

        recordings: list[Recording] = []
        interval = record_options.topic_polling_interval.total_seconds()

        def begin(node: Node) -> Callable[[], float | None]:
            recording = Recording(node, storage_options, record_options, keyboard=False)
            recordings.append(recording)
            recording.start()
            last = time.monotonic()

            def step() -> float | None:
                nonlocal last
                if time.monotonic() - last >= interval:
                    last = time.monotonic()
                    recording.poll()
                return last + interval - time.monotonic()

            return step

        simulated: list[Parameter[bool]] = [Parameter("use_sim_time", value=record_options.use_sim_time)]
        try:
            self._run(node_name, [], begin, parameter_overrides=simulated)
        finally:
            for recording in recordings:
                recording.stop()


class BlockingPlayer(_Transport):
    """Plays bags: `Player().play(storage_options, play_options)`."""

    def play(self, storage_options: StorageOptions, play_options: PlayOptions) -> None:
        """Play to the end, until `cancel`, or Ctrl-C (KeyboardInterrupt)."""
        self._play(storage_options, play_options, None)

    def burst(self, storage_options: StorageOptions, play_options: PlayOptions, num_messages: int) -> None:
        """Publish `num_messages` messages at once (0: all), then stay paused."""
        play_options.start_paused = True
        self._play(storage_options, play_options, num_messages)

    def _play(self, storage: StorageOptions, options: PlayOptions, burst: int | None) -> None:
        from rosbag2_py._play_services import offer_services
        from rosbag2_py._playing import NODE_NAME, Playing
        from rosbag2_py._reader import SequentialReader

        reader = SequentialReader()
        reader.open(storage)

        def begin(node: Node) -> Callable[[], float | None]:
            playing = Playing(
                node, [reader], options, keyboard=False, steady_ns=time.monotonic_ns, on_wake=lambda: None
            )
            offer_services(node, playing)
            playing.begin()
            if burst is not None:
                playing.burst(burst)

            def step() -> float | None:
                due = playing.advance()
                if playing.finished:
                    return None
                return _LONGEST_WAIT if due is None else (due - time.monotonic_ns()) / 1e9

            return step

        try:
            self._run(NODE_NAME, options.topic_remapping_options, begin)
        finally:
            reader.close()


BlockingPlayer.__name__ = BlockingPlayer.__qualname__ = "Player"
BlockingRecorder.__name__ = BlockingRecorder.__qualname__ = "Recorder"
