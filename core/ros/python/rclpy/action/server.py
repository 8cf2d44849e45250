"""The server's side of actions: accept goals, run them, tell how they go, keep their results for a while."""

from __future__ import annotations

import sys
import threading
import traceback
from collections.abc import Callable
from enum import Enum
from functools import partial
from typing import TYPE_CHECKING, Any, Generic

from action_msgs.msg import GoalInfo, GoalStatus, GoalStatusArray

from rclpy._rclpy_pybind11 import GoalEvent, RCLError
from rclpy.action._protocol import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, STATUS, ActionEntity, GoalKey, key_of
from rclpy.executors import await_or_execute
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import FeedbackT, GoalT, ResultT

if TYPE_CHECKING:
    from unique_identifier_msgs.msg import UUID

    from day6_tui.core.graph import RequestId
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

_S = GoalStatus
_TRANSITIONS: dict[tuple[int, GoalEvent], int] = {
    (_S.STATUS_ACCEPTED, GoalEvent.EXECUTE): _S.STATUS_EXECUTING,
    (_S.STATUS_ACCEPTED, GoalEvent.CANCEL_GOAL): _S.STATUS_CANCELING,
    (_S.STATUS_EXECUTING, GoalEvent.CANCEL_GOAL): _S.STATUS_CANCELING,
    (_S.STATUS_EXECUTING, GoalEvent.SUCCEED): _S.STATUS_SUCCEEDED,
    (_S.STATUS_EXECUTING, GoalEvent.ABORT): _S.STATUS_ABORTED,
    (_S.STATUS_CANCELING, GoalEvent.SUCCEED): _S.STATUS_SUCCEEDED,
    (_S.STATUS_CANCELING, GoalEvent.ABORT): _S.STATUS_ABORTED,
    (_S.STATUS_CANCELING, GoalEvent.CANCELED): _S.STATUS_CANCELED,
}
"""The goal state machine (rcl_action/goal_state_machine.c)."""

_ACTIVE = (_S.STATUS_ACCEPTED, _S.STATUS_EXECUTING, _S.STATUS_CANCELING)
_STATE_NAMES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")

# Return codes of action_msgs/srv/CancelGoal.
_ERROR_NONE, _ERROR_UNKNOWN_GOAL_ID, _ERROR_GOAL_TERMINATED = 0, 2, 3


class GoalResponse(Enum):
    """What a goal callback answers."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """What a cancel callback answers."""

    REJECT = 1
    ACCEPT = 2


class ServerGoalHandle(Generic[GoalT, ResultT, FeedbackT]):
    """An accepted goal; made by the action server and given to its callbacks."""

    def __init__(self, action_server: ActionServer[Any, Any, Any], goal_info: GoalInfo, goal_request: Any) -> None:
        self._action_server = action_server
        self._goal_info = goal_info
        self._goal_request = goal_request
        self._status: int = GoalStatus.STATUS_ACCEPTED
        self._destroyed = False
        self._ended_ns: int | None = None
        self._lock = threading.Lock()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bool(self.goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    @property
    def request(self) -> Any:
        """The goal message."""
        return self._goal_request

    @property
    def goal_id(self) -> UUID:
        """The goal's UUID message."""
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        """Whether the goal has not come to an end yet."""
        return not self._destroyed and self._status in _ACTIVE

    @property
    def is_cancel_requested(self) -> bool:
        """Whether a cancel request was accepted."""
        return self.status == GoalStatus.STATUS_CANCELING

    @property
    def status(self) -> int:
        """A constant of GoalStatus; UNKNOWN after `destroy`."""
        return int(GoalStatus.STATUS_UNKNOWN if self._destroyed else self._status)

    def _update_state(self, event: GoalEvent) -> None:
        with self._lock:
            if self._destroyed:
                return
            following = _TRANSITIONS.get((self._status, event))
            if following is None:
                raise RCLError(
                    "Failed to update goal state: goal_handle attempted invalid transition from state "
                    f"{_STATE_NAMES[self._status]} with event {event.name}, "
                    "at /project/src/rcl_action/goal_handle.c:101"
                )
            self._status = following
            if following not in _ACTIVE:
                self._ended_ns = self._action_server._now_ns()
        self._action_server._publish_status()

    def execute(self, execute_callback: Callable[[Any], Any] | None = None) -> None:
        """Have the goal executed, by the server's execute callback if none is given."""
        # A goal that is being cancelled already keeps that state; its callback sees to the end.
        if not self.is_cancel_requested:
            self._update_state(GoalEvent.EXECUTE)
        self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Any) -> None:
        """Send a Feedback message of the action's type to whoever sent the goal; TypeError for another type."""
        server = self._action_server
        if not isinstance(feedback, server.action_type.Feedback):
            raise TypeError()
        if self._destroyed:
            return
        message = server.action_type.Impl.FeedbackMessage()
        message.goal_id = self.goal_id
        message.feedback = feedback
        server._feedback.publish(message)

    def succeed(self) -> None:
        """The goal was reached. RCLError if it is over already."""
        self._update_state(GoalEvent.SUCCEED)

    def abort(self) -> None:
        """The goal was given up. RCLError if it is over already."""
        self._update_state(GoalEvent.ABORT)

    def canceled(self) -> None:
        """The goal was cancelled on request. RCLError if nobody asked for that."""
        self._update_state(GoalEvent.CANCELED)

    def destroy(self) -> None:
        """Forget the goal: later updates have no effect."""
        self._destroyed = True


def default_handle_accepted_callback(goal_handle: ServerGoalHandle[Any, Any, Any]) -> None:
    """Execute the goal at once."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Cancel nothing."""
    return CancelResponse.REJECT


class ActionServer(ActionEntity, Generic[GoalT, ResultT, FeedbackT]):
    """Serves the goals of one action.

    `result_timeout` (s): how long a result can be fetched after its goal ended.
    """

    def __init__(
        self,
        node: Node,
        action_type: Any,
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle[Any, Any, Any]], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Any], Any] | None = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle[Any, Any, Any]], Any] | None = (
            default_handle_accepted_callback
        ),
        cancel_callback: Callable[[Any], Any] | None = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = QoSProfile(depth=10),  # noqa: B008 (the real default, never changed)
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: int = 10,
    ) -> None:
        super().__init__(node, action_type, action_name, callback_group)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self.register_execute_callback(execute_callback)
        self._check_name("server", action_name)
        self._lock = threading.RLock()
        self._result_timeout_ns = int(result_timeout * 1_000_000_000)
        self._goal_handles: dict[GoalKey, ServerGoalHandle[Any, Any, Any]] = {}
        self._result_futures: dict[GoalKey, Future[Any]] = {}
        kind = action_type.Impl
        self._goal_service = self._make_service(
            SEND_GOAL, kind.SendGoalService, goal_service_qos_profile, self._on_goal_request
        )
        self._cancel_service = self._make_service(
            CANCEL_GOAL, kind.CancelGoalService, cancel_service_qos_profile, self._on_cancel_request
        )
        self._result_service = self._make_service(
            GET_RESULT, kind.GetResultService, result_service_qos_profile, self._on_result_request
        )
        self._feedback = self._make_publisher(FEEDBACK, kind.FeedbackMessage, feedback_pub_qos_profile)
        self._status = self._make_publisher(STATUS, kind.GoalStatusMessage, status_pub_qos_profile)
        node.add_waitable(self)
        self._logger = node.get_logger().get_child("action_server")

    @property
    def action_type(self) -> Any:
        """The action's class."""
        return self._action_type

    # callbacks

    def register_handle_accepted_callback(self, handle_accepted_callback: Callable[[Any], Any] | None) -> None:
        """Set what is called with each newly accepted goal; None: execute it at once."""
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_goal_callback(self, goal_callback: Callable[[Any], Any] | None) -> None:
        """Set what decides about new goals by returning a GoalResponse; None: accept all."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_cancel_callback(self, cancel_callback: Callable[[Any], Any] | None) -> None:
        """Set what decides about cancel requests by returning a CancelResponse; None: reject all."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Callable[[Any], Any]) -> None:
        """Set what executes goals and returns a Result; TypeError if it cannot be called."""
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    # goals

    async def _on_goal_request(self, taken: tuple[Any, RequestId]) -> None:
        request, request_id = taken
        self._expire_goals()
        goal_info = GoalInfo(goal_id=request.goal_id)
        key = key_of(request.goal_id)
        uuid = request.goal_id.uuid
        self._logger.debug(f"New goal request with ID: {uuid}")
        accepted = False
        if key not in self._goal_handles:
            answer = await await_or_execute(self._goal_callback, request.goal)
            if isinstance(answer, GoalResponse):
                accepted = answer is GoalResponse.ACCEPT
            else:
                self._logger.warning("Goal request callback did not return a GoalResponse type. Rejecting goal.")
        if accepted:
            goal_info.stamp = self._node.get_clock().now().to_msg()
            goal_handle: ServerGoalHandle[Any, Any, Any] = ServerGoalHandle(self, goal_info, request.goal)
            with self._lock:
                self._goal_handles[key] = goal_handle
                self._result_futures[key] = Future()
        response = self._action_type.Impl.SendGoalService.Response()
        response.accepted = accepted
        response.stamp = goal_info.stamp
        self._goal_service.send_response(request_id, response)
        if not accepted:
            self._logger.debug(f"New goal rejected: {uuid}")
            return
        self._logger.debug(f"New goal accepted: {uuid}")
        self._publish_status()
        await await_or_execute(self._handle_accepted_callback, goal_handle)

    def notify_execute(
        self, goal_handle: ServerGoalHandle[Any, Any, Any], execute_callback: Callable[[Any], Any] | None
    ) -> None:
        """Have a goal executed by the node's executor."""
        if self._node.executor is not None:
            callback = execute_callback or self._execute_callback
            self._node.executor.create_task(self._execute_goal, callback, goal_handle)

    async def _execute_goal(
        self, execute_callback: Callable[[Any], Any], goal_handle: ServerGoalHandle[Any, Any, Any]
    ) -> None:
        uuid = goal_handle.goal_id.uuid
        self._logger.debug(f"Executing goal with ID {uuid}")
        try:
            result = await await_or_execute(execute_callback, goal_handle)
        except Exception as error:
            # A failing callback must not leave the client waiting: it gets an empty result and status ABORTED.
            result = self._action_type.Result()
            self._logger.error(f"Error raised in execute callback: {error}")
            write = self._node.context._log_write or sys.stderr.write
            write(traceback.format_exc())
        if goal_handle.is_active:
            self._logger.warning(f"Goal state not set, assuming aborted. Goal ID: {uuid}")
            goal_handle.abort()
        self._logger.debug(f"Goal with ID {uuid} finished with state {goal_handle.status}")
        response = self._action_type.Impl.GetResultService.Response()
        response.status = goal_handle.status
        response.result = result
        self._result_futures[key_of(goal_handle.goal_id)].set_result(response)

    async def _on_cancel_request(self, taken: tuple[Any, RequestId]) -> None:
        request, request_id = taken
        self._logger.debug(f"Cancel request received: {request}")
        response = self._action_type.Impl.CancelGoalService.Response()
        response.return_code, candidates = self._goals_to_cancel(request.goal_info)
        canceling = []
        for goal_handle in candidates:
            if await await_or_execute(self._cancel_callback, goal_handle) != CancelResponse.ACCEPT:
                continue
            try:
                goal_handle._update_state(GoalEvent.CANCEL_GOAL)
            except RCLError as error:
                self._logger.debug(f"Failed to cancel goal in cancel callback: {error}")
            else:
                canceling.append(goal_handle._goal_info)
        response.goals_canceling = canceling
        self._cancel_service.send_response(request_id, response)

    def _goals_to_cancel(self, wanted: GoalInfo) -> tuple[int, list[ServerGoalHandle[Any, Any, Any]]]:
        """Return the return code and the goals a request means: by id, by "accepted until", both, or all."""
        key, until = key_of(wanted.goal_id), (wanted.stamp.sec, wanted.stamp.nanosec)
        handles = list(self._goal_handles.values())
        named = any(key)
        if named and until == (0, 0):
            handle = self._goal_handles.get(key)
            if handle is None:
                return _ERROR_UNKNOWN_GOAL_ID, []
            return (_ERROR_NONE, [handle]) if _cancelable(handle) else (_ERROR_GOAL_TERMINATED, [])
        if until != (0, 0):
            handles = [
                each
                for each in handles
                if (each._goal_info.stamp.sec, each._goal_info.stamp.nanosec) <= until
                or (named and key_of(each.goal_id) == key)
            ]
        return _ERROR_NONE, [each for each in handles if _cancelable(each)]

    async def _on_result_request(self, taken: tuple[Any, RequestId]) -> None:
        request, request_id = taken
        self._expire_goals()
        uuid = request.goal_id.uuid
        self._logger.debug(f"Result request received for goal with ID: {uuid}")
        future = self._result_futures.get(key_of(request.goal_id))
        if future is None:
            self._logger.warning(f"Sending result response for unknown or expired goal ID: {uuid}")
            response = self._action_type.Impl.GetResultService.Response()
            response.status = GoalStatus.STATUS_UNKNOWN
            self._result_service.send_response(request_id, response)
        else:
            future.add_done_callback(partial(self._send_result, request_id))

    def _send_result(self, request_id: RequestId, future: Future[Any]) -> None:
        result = future.result()
        if result is not None and not self._handle._destroyed:
            self._result_service.send_response(request_id, result)

    # status and age

    def _now_ns(self) -> int:
        return self._node.context._time.steady_ns()

    def _publish_status(self) -> None:
        """Publish the status of every goal that is remembered."""
        message = GoalStatusArray()
        with self._lock:
            message.status_list = [
                GoalStatus(goal_info=handle._goal_info, status=handle._status) for handle in self._goal_handles.values()
            ]
        self._status.publish(message)

    def _expire_goals(self) -> None:
        """Forget goals whose results were kept long enough; looked at whenever somebody asks for something."""
        oldest = self._now_ns() - self._result_timeout_ns
        with self._lock:
            for key, handle in list(self._goal_handles.items()):
                if handle._ended_ns is not None and handle._ended_ns < oldest:
                    handle.destroy()
                    del self._goal_handles[key], self._result_futures[key]

    def destroy(self) -> None:
        """Take the server out of the graph and forget its goals."""
        for handle in self._goal_handles.values():
            handle.destroy()
        super().destroy()


def _cancelable(handle: ServerGoalHandle[Any, Any, Any]) -> bool:
    return (handle._status, GoalEvent.CANCEL_GOAL) in _TRANSITIONS
