"""`Player` and `Recorder` since Lyrical: objects that are controlled while they play or record, in threads of their own.

They still are what they were before (`Player().play(storage_options, play_options)`), with a DeprecationWarning.
"""

from __future__ import annotations

import threading
import time
import warnings
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from rosbag2_py import _transport as before
from rosbag2_py._options import PlayOptions, RecordOptions
from rosbag2_py._storage import StorageOptions, nanoseconds_of

if TYPE_CHECKING:
    from rosbag2_py._playing import Playing

_LONGEST_WAIT = 0.1
"""Seconds between looks at what a thread waits for, so that Ctrl-C is heard."""


def _deprecated(what: str, instead: str, *, frames: int = 1) -> None:
    warnings.warn(f"{what} is deprecated. {instead}", DeprecationWarning, stacklevel=2 + frames)


class _Spun:
    """A node of a context of its own, and the thread that spins it."""

    def __init__(self, log_level: str, name: str, arguments: list[str], **node: Any) -> None:
        from rclpy.context import Context
        from rclpy.node import Node

        self.context = Context()
        self.context.init(args=["--ros-args", "--log-level", log_level])
        self.node = Node(name, context=self.context, cli_args=arguments, **node)
        self._executor: Any = None
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Spin in a thread; a second call does nothing."""
        if self._thread is not None:
            return
        from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

        executor = self._executor = SingleThreadedExecutor(context=self.context)
        executor.add_node(self.node)

        def spin() -> None:
            with suppress(ExternalShutdownException):  # by `end`
                executor.spin()

        self._thread = threading.Thread(target=spin, name="rosbag2_spin", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End the thread."""
        if self._thread is not None:
            self._executor.shutdown()
            self._thread.join()
            self._thread = None

    def end(self) -> None:
        """End the thread, and take the node out of the graph."""
        if self.context.ok():
            self.stop()
            self.context.try_shutdown()


class _Locked:
    """Something whose methods are called by one thread at a time."""

    def __init__(self, inner: Any, lock: threading.RLock) -> None:
        self._inner = inner
        self._lock = lock

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._inner, name)
        if not callable(found):
            return found

        def call(*words: Any, **more: Any) -> Any:
            with self._lock:
                return found(*words, **more)

        return call


class _Controlled:
    _spun: _Spun | None = None
    _what = ""
    _kind = ""
    _before: type[Any]
    """The class that does what it did before Lyrical."""

    def _open(self, storage_options: Any, log_level: str) -> Any:
        """Return the bags, None if it is used as before Lyrical: then its first argument is the log level, if any."""
        if storage_options is not None and not isinstance(storage_options, str):
            self._old = self._before(log_level)
            return storage_options
        how = f"{self._what}({'' if storage_options is None else 'log_level'})"
        _deprecated(how, "Use the constructor with full configuration parameters instead.", frames=2)
        self._old = self._before(storage_options or log_level)
        return None

    def _node(self) -> _Spun:
        if self._spun is None:
            raise RuntimeError(
                f"{self._what} is not initialized. Please use constructor with storage and {self._kind} options."
            )
        return self._spun

    def start_spin(self) -> None:
        """Spin the node in a thread, by which its services, messages and timers come to life."""
        self._node().start()

    def stop_spin(self) -> None:
        """End that thread; a second call does nothing."""
        if self._spun is not None:
            self._spun.stop()

    def __del__(self) -> None:
        if self._spun is not None:
            self._spun.end()


class Player(_Controlled):
    """Plays bags: `Player(storage_options, play_options)`, then `start_spin`, `play`, and what comes in between."""

    _what, _kind, _before = "Player", "play", before.BlockingPlayer

    def __init__(
        self,
        storage_options: StorageOptions | list[StorageOptions] | str | None = None,
        play_options: PlayOptions | None = None,
        log_level: str = "info",
        node_name: str = "rosbag2_player",
    ) -> None:
        """Raise RuntimeError for a bag that can't be read."""
        given = self._open(storage_options, log_level)
        if given is None:
            return
        options = play_options or PlayOptions()
        bags = given if isinstance(given, list) else [given]
        self._lock = threading.RLock()
        self._woken = threading.Event()
        self._started = threading.Event()
        self._ended = threading.Event()
        self._ended.set()
        self._player: threading.Thread | None = None
        self._readers = [self._opened(each) for each in bags]
        self._spun = _Spun(log_level, node_name, options.topic_remapping_options)
        self._options = options
        self._playing = self._make()
        from rosbag2_py._play_services import offer_services

        offer_services(self._spun.node, _Locked(_Current(self), self._lock))  # type: ignore[arg-type]

    @staticmethod
    def _opened(options: StorageOptions) -> Any:
        from rosbag2_py._reader import SequentialReader

        reader = SequentialReader()
        reader.open(options)
        return reader

    def _make(self) -> Playing:
        from rosbag2_py._playing import Playing

        return Playing(
            self._node().node,
            self._readers,
            self._options,
            keyboard=False,
            steady_ns=time.monotonic_ns,
            on_wake=self._woken.set,
        )

    # -- playing -------------------------------------------------------------------------------------------------------

    def play(self, storage_options: Any = None, play_options: PlayOptions | None = None) -> None:
        """Begin to play in a thread, or, as before Lyrical, play bags to their end."""
        if storage_options is not None:
            _deprecated("Player.play(storage_options, play_options)", "Use the parameterless play() instead.")
            self._old.play(storage_options, play_options or PlayOptions())
            return
        log = self._node().node.get_logger()
        with self._lock:
            if not self._ended.is_set():
                log.warning("Trying to play() while in playback, dismissing request.")
                return
            if self._playing.finished:
                self._playing = self._make()
            self._ended.clear()
            self._playing.begin()
            self._started.set()
        self._player = threading.Thread(target=self._run, name="rosbag2_play", daemon=True)
        self._player.start()

    def _run(self) -> None:
        try:
            while self._node().context.ok():
                self._woken.clear()
                with self._lock:
                    due = self._playing.advance()
                    if self._playing.finished:
                        break
                wait = None if due is None else max((due - time.monotonic_ns()) / 1e9, 0.0)
                self._woken.wait(_LONGEST_WAIT if wait is None else min(wait, _LONGEST_WAIT))
        finally:
            self._started.clear()
            self._ended.set()

    def _wait(self, event: threading.Event, timeout: float) -> bool:
        self._node()
        end = None if timeout < 0 else time.monotonic() + timeout
        while not event.wait(_LONGEST_WAIT if end is None else min(max(end - time.monotonic(), 0.0), _LONGEST_WAIT)):
            if end is not None and time.monotonic() >= end:
                return False
        return True

    def wait_for_playback_to_start(self, timeout: float = -1.0) -> bool:
        """Return True once it plays, False after `timeout` seconds; a negative one means as long as it takes."""
        return self._wait(self._started, timeout)

    def wait_for_playback_to_finish(self, timeout: float = -1.0) -> bool:
        """Return True once it plays no more, False after `timeout` seconds; a negative one means as long as it takes."""
        return self._wait(self._ended, timeout)

    wait_for_playback_to_start_exclusively = wait_for_playback_to_start
    wait_for_playback_to_finish_exclusively = wait_for_playback_to_finish

    # -- control -------------------------------------------------------------------------------------------------------

    def _control(self, name: str, *words: Any) -> Any:
        self._node()
        with self._lock:
            return getattr(self._playing, name)(*words)

    def stop(self) -> None:
        """End the playback."""
        self._control("stop")
        self._wait(self._ended, -1.0)

    def pause(self) -> None:
        """Stop the recording's time."""
        self._control("pause")

    def resume(self) -> None:
        """Let the recording's time run again."""
        self._control("resume")

    def is_paused(self) -> bool:
        """Return whether the recording's time stands still."""
        self._node()
        return self._playing.clock.paused

    def play_next(self) -> bool:
        """While paused: publish one message. Returns False if there is none."""
        played: bool = self._control("play_next")
        return played

    def burst(self, *words: Any) -> int | None:
        """While paused: publish so many messages at once, 0 for all; return how many there were."""
        if len(words) == 3:
            _deprecated(
                "Player.burst(storage_options, play_options, num_messages)",
                "Use burst(num_messages) with preconfigured options instead.",
            )
            self._old.burst(*words)
            return None
        played: int = self._control("burst", *words)
        return played

    def seek(self, time_point: int) -> None:
        """Continue at this time of the recording, nanoseconds since 1970."""
        self._control("seek", time_point)

    def get_starting_time(self) -> int:
        """Return when the first message is, nanoseconds since 1970."""
        self._node()
        return self._playing.start_ns

    def get_playback_duration(self) -> int:
        """Return the nanoseconds from the first message to the last."""
        self._node()
        return self._playing.bag_end - self._playing.start_ns

    @staticmethod
    def cancel() -> None:
        """End all that play as before Lyrical."""
        _deprecated("Player.cancel()", "Please use Player.stop() instead.")
        before.BlockingPlayer.cancel()


class _Current:
    """The playback that a player has at present."""

    def __init__(self, player: Player) -> None:
        self._player = player

    def __getattr__(self, name: str) -> Any:
        return getattr(self._player._playing, name)


class Recorder(_Controlled):
    """Records bags: `Recorder(storage_options, record_options)`, then `start_spin`, `record`, `stop`, `stop_spin`."""

    _what, _kind, _before = "Recorder", "record", before.BlockingRecorder

    def __init__(
        self,
        storage_options: StorageOptions | str | None = None,
        record_options: RecordOptions | None = None,
        log_level: str = "info",
        node_name: str = "rosbag2_recorder",
    ) -> None:
        """Raise RuntimeError for options that contradict each other."""
        bag = self._open(storage_options, log_level)
        if bag is None:
            return
        from rclpy.parameter import Parameter
        from rosbag2_py._recording import Recording

        options = record_options or RecordOptions()
        simulated: list[Parameter[bool]] = [Parameter("use_sim_time", value=options.use_sim_time)]
        self._spun = _Spun(log_level, node_name, [], parameter_overrides=simulated)
        self._recording = Recording(self._spun.node, bag, options, keyboard=False)
        self._recording.offer()
        seconds = max(nanoseconds_of(options.topic_polling_interval) / 1e9, 0.001)
        self._spun.node.create_timer(seconds, self._recording.poll)

    def record(
        self,
        storage_options: StorageOptions | None = None,
        record_options: RecordOptions | None = None,
        node_name: str = "rosbag2_recorder",
    ) -> None:
        """Begin to record, or, as before Lyrical, record until Ctrl-C. Raises RuntimeError if the bag can't be created."""
        if storage_options is not None:
            _deprecated(
                "Recorder.record(storage_options, record_options, node_name)", "Use the parameterless record() instead."
            )
            self._old.record(storage_options, record_options or RecordOptions(), node_name)
            return
        log = self._node().node.get_logger()
        if self._recording.recording:
            log.warning("Called Recorder::record(uri) while already in recording, dismissing request.")
        else:
            self._recording.start()

    def stop(self) -> None:
        """Finish the bag; `record` may begin another one."""
        self._node()
        self._recording.stop()

    def pause(self) -> None:
        """Write nothing until `resume`."""
        self._node()
        self._recording.pause()

    def resume(self) -> None:
        """Continue to write."""
        self._node()
        self._recording.resume()

    def is_paused(self) -> bool:
        """Return whether nothing is written."""
        self._node()
        return self._recording.paused

    @staticmethod
    def cancel() -> None:
        """End all that record as before Lyrical."""
        _deprecated("Recorder.cancel()", "Please use Recorder.stop() instead.")
        before.BlockingRecorder.cancel()

    def __del__(self) -> None:
        if self._spun is not None:
            self._recording.stop()
        super().__del__()
