"""The services by which other programs control a recorder: `/rosbag2_recorder/pause` and so on."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import rosbag2_interfaces.srv

from day6_core.reason import reason
from day6_core.ros.differences import value
from rclpy.exceptions import InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name

if TYPE_CHECKING:
    from rclpy.node import Node
    from rosbag2_py._recording import Recording

Answer = dict[str, Any]

_MODES = {0: "node", 1: "publish", 2: "receive"}
_INVALID_MODE = {"resume": 1, "split": 2}
_INVALID_TOPIC = {"resume": 2, "split": 3}
_SPLIT_FAILED = 4
SECOND = 1_000_000_000


class _Pending(NamedTuple):
    """What is done once a message has come whose time is this."""

    topic: str
    by_sent: bool
    moment_ns: int


class RecordServices:
    """Offers the services of a distribution on the recorder's node. `note` is called with each message that comes."""

    def __init__(self, node: Node, recording: Recording, *, snapshot: bool) -> None:
        self._node = node
        self._recording = recording
        self._log = node.get_logger()
        self._pending: dict[str, _Pending] = {}
        self._seen: dict[str, tuple[int, int]] = {}
        """When the last message of each topic, and of all (''), was sent and received."""
        newer = value("bag.recorder_starts_again")
        table: dict[str, tuple[str, Callable[[Any], Answer]]] = {}
        if snapshot:
            table["snapshot"] = "Snapshot", self._snapshot
        if value("bag.recorder_can_pause"):
            table |= {
                "split_bagfile": ("SplitBagfile", self._split if newer else _silent(recording.split)),
                "pause": ("Pause", _silent(recording.pause)),
                "resume": ("Resume", self._resume if newer else _silent(recording.resume)),
                "is_paused": ("IsPaused", lambda request: {"paused": recording.paused}),
            }
        if newer:
            table |= {
                "record": ("Record", self._record),
                "stop": ("Stop", self._stop),
                "start_discovery": ("StartDiscovery", self._start_discovery),
                "stop_discovery": ("StopDiscovery", self._stop_discovery),
                "is_discovery_running": ("IsDiscoveryRunning", lambda request: {"running": recording.discovering}),
            }
        for name, (kind, serve) in table.items():
            node.create_service(getattr(rosbag2_interfaces.srv, kind), f"~/{name}", _callback(serve))

    # -- at once -------------------------------------------------------------------------------------------------------

    def _snapshot(self, request: Any) -> Answer:
        if not self._recording.recording:
            self._ignore("Snapshot")
            return {"success": False}
        return {"success": self._recording.snapshot()}

    def _stop(self, request: Any) -> Answer:
        if not self._recording.recording:
            self._ignore("Stop")
            return _answer(1, "Recorder is already stopped.")
        return self._trying("Stop", self._recording.stop)

    def _start_discovery(self, request: Any) -> Answer:
        if not self._recording.recording:
            self._ignore("StartDiscovery")
            return _answer(1, "Recorder is not currently recording.")
        if self._recording.discovering:
            self._ignore("StartDiscovery", "discovery is already running")
            return _answer(1, "Discovery is already running.")
        return self._trying("StartDiscovery", self._recording.start_discovery)

    def _stop_discovery(self, request: Any) -> Answer:
        if not self._recording.discovering:
            self._ignore("StopDiscovery", "discovery is not running")
            return _answer(1, "Discovery is not running.")
        return self._trying("StopDiscovery", self._recording.stop_discovery)

    def _ignore(self, kind: str, state: str = "not in recording") -> None:
        self._log.warning(f"Received {kind} request while {state}. Ignoring request.")

    def _trying(self, kind: str, action: Callable[[], object], failed: int = 1) -> Answer:
        try:
            action()
        except (RuntimeError, OSError) as error:
            self._log.error(f"Error during '{kind}' request: {reason(error)}")
            return _answer(failed, reason(error))
        return _answer()

    # -- now or later --------------------------------------------------------------------------------------------------

    def _record(self, request: Any) -> Answer:
        recording = self._recording

        def start() -> Answer:
            if recording.recording:
                self._log.warning("Called Recorder::record(uri) while already in recording, dismissing request.")
                return _answer(1, "Called record(uri) while already in recording.")
            return self._trying("Record", lambda: recording.start(request.uri))

        return self._now_or_later(_nanoseconds(request.start_time), start)

    def _resume(self, request: Any) -> Answer:
        def resume() -> Answer:
            self._recording.resume()
            return _answer()

        return self._timed("resume", request, request.resume_time, request.resume_mode, resume)

    def _split(self, request: Any) -> Answer:
        return self._timed("split", request, request.split_time, request.split_mode, self._split_now)

    def _split_now(self) -> Answer:
        if not self._recording.recording:
            self._ignore("SplitBagfile")
            return _answer(1, "Called 'SplitBagfile' request while not in recording. Request ignored.")
        return self._trying("SplitBagfile", self._recording.split, _SPLIT_FAILED)

    def _timed(self, what: str, request: Any, time: Any, mode: int, act: Callable[[], Answer]) -> Answer:
        kind = {"resume": "Resume", "split": "SplitBagfile"}[what]
        if mode not in _MODES:
            self._log.error(f"Invalid {what}_mode {mode} for {kind} request.")
            return _answer(_INVALID_MODE[what], f"Invalid {what}_mode for {kind} request.")
        moment = _nanoseconds(time)
        if mode == 0:
            return self._now_or_later(moment, act)
        topic = request.tracking_topic_name
        try:
            topic = topic and expand_topic_name(topic, self._node.get_name(), self._node.get_namespace())
        except (InvalidTopicNameException, ValueError) as error:
            self._log.error(f"Invalid tracking topic name '{topic}' for {kind} request: {reason(error)}")
            return _answer(_INVALID_TOPIC[what], f"Invalid tracking_topic_name for {kind} request.")
        by_sent = mode == 1
        if not moment or self._seen.get(topic, (0, 0))[not by_sent] >= moment:
            return act()
        self._pending[what] = _Pending(topic, by_sent, moment)
        place = f" on '{topic}' topic" if topic else ""
        self._log.info(
            f"Scheduled timestamp-based {what} at {moment / SECOND:.9f} seconds using {_MODES[mode]} timestamps{place}."
        )
        return _answer()

    def _now_or_later(self, moment: int, act: Callable[[], Answer]) -> Answer:
        clock = self._node.get_clock()
        wait = moment - clock.now().nanoseconds if moment else 0
        if wait <= 0:
            return act()

        def run() -> None:
            timer.cancel()
            self._node.destroy_timer(timer)
            act()

        timer = self._node.create_timer(wait / SECOND, run, clock=clock)
        return _answer()

    def before(self, topic: str, sent_ns: int, received_ns: int) -> None:
        """A message has come, which may be the one that a resumption waits for."""
        self._seen[topic] = self._seen[""] = sent_ns, received_ns
        if self._pending and self._is_due("resume", topic):
            self._recording.resume()

    def after(self, topic: str) -> None:
        """The message is written; it may be the one that a split waits for."""
        if self._pending and self._is_due("split", topic):
            self._split_now()

    def _is_due(self, what: str, topic: str) -> bool:
        pending = self._pending.get(what)
        if pending is None or pending.topic not in ("", topic):
            return False
        if self._seen[topic][not pending.by_sent] < pending.moment_ns:
            return False
        del self._pending[what]
        return True

    def forget(self) -> None:
        """The recording has stopped: nothing is pending any more."""
        self._pending.clear()
        self._seen.clear()


def _nanoseconds(time: Any) -> int:
    moment: int = time.sec * SECOND + time.nanosec
    return moment


def _answer(code: int = 0, text: str = "") -> Answer:
    return {"return_code": code, "error_string": text}


def _silent(action: Callable[[], object]) -> Callable[[Any], Answer]:
    def serve(request: Any) -> Answer:
        action()
        return {}

    return serve


def _callback(serve: Callable[[Any], Answer]) -> Callable[[Any, Any], Any]:
    def callback(request: Any, response: Any) -> Any:
        for field, value_ in serve(request).items():
            setattr(response, field, value_)
        return response

    return callback
