"""The client's side of actions: send a goal, hear of its progress, fetch the result, cancel."""

from __future__ import annotations

import threading
import uuid
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic

from action_msgs.msg import GoalStatus
from action_msgs.srv import CancelGoal
from unique_identifier_msgs.msg import UUID

from rclpy.action._protocol import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, STATUS, ActionEntity, GoalKey, key_of
from rclpy.executors import await_or_execute
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import FeedbackT, GoalT, ResultT

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time

    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

_TERMINAL = (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED)

_WAIT_STEP_SECONDS = 0.25
"""`wait_for_server` looks again at least this often; it is woken by changes of the graph before that."""


class ClientGoalHandle(Generic[GoalT, ResultT, FeedbackT]):
    """A goal that was answered by a server; made by the action client."""

    def __init__(self, action_client: ActionClient[Any, Any, Any], goal_id: UUID, goal_response: Any) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self._status: int = GoalStatus.STATUS_UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bool(self._goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    @property
    def goal_id(self) -> UUID:
        """The goal's UUID message."""
        return self._goal_id

    @property
    def stamp(self) -> Time:
        """When the server accepted the goal."""
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        """Whether the server accepted the goal."""
        return bool(self._goal_response.accepted)

    @property
    def status(self) -> int:
        """The goal's last known status, a constant of GoalStatus."""
        return self._status

    def cancel_goal(self) -> Any:
        """Ask for cancellation and wait for the answer. Deadlocks in a callback."""
        return _wait(self._action_client._cancel_goal_async(self))

    def cancel_goal_async(self) -> Future[Any]:
        """Ask for cancellation; the future's result is a CancelGoal response."""
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        """Wait for the result. Deadlocks in a callback."""
        return _wait(self._action_client._get_result_async(self))

    def get_result_async(self) -> Future[Any]:
        """Ask for the result; the future's result has `status` and `result`."""
        return self._action_client._get_result_async(self)


def _wait(future: Future[Any]) -> Any:
    """Block this thread until an executor in another one has completed the future."""
    done = threading.Event()
    future.add_done_callback(lambda _: done.set())
    done.wait()
    return future.result()


class ActionClient(ActionEntity, Generic[GoalT, ResultT, FeedbackT]):
    """Sends goals of one type to the servers of one action."""

    def __init__(
        self,
        node: Node,
        action_type: Any,
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = QoSProfile(depth=10),  # noqa: B008 (the real default, never changed)
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        super().__init__(node, action_type, action_name, callback_group)
        self._check_name("client", action_name)
        self._lock = threading.Lock()
        self._goal_handles: dict[GoalKey, weakref.ReferenceType[ClientGoalHandle[Any, Any, Any]]] = {}
        self._goals: dict[int, tuple[Future[Any], UUID]] = {}
        self._cancels: dict[int, Future[Any]] = {}
        self._results: dict[int, tuple[Future[Any], GoalKey]] = {}
        self._feedback_callbacks: dict[GoalKey, Callable[[Any], Any]] = {}
        kind = action_type.Impl
        self._goal_client = self._make_client(
            SEND_GOAL, kind.SendGoalService, goal_service_qos_profile, self._on_goal_response
        )
        self._cancel_client = self._make_client(
            CANCEL_GOAL, kind.CancelGoalService, cancel_service_qos_profile, self._on_cancel_response
        )
        self._result_client = self._make_client(
            GET_RESULT, kind.GetResultService, result_service_qos_profile, self._on_result_response
        )
        self._make_subscription(FEEDBACK, kind.FeedbackMessage, feedback_sub_qos_profile, self._on_feedback)
        self._make_subscription(STATUS, kind.GoalStatusMessage, status_sub_qos_profile, self._on_status)
        node.add_waitable(self)
        self._logger = node.get_logger().get_child("action_client")

    # requests

    def send_goal(self, goal: GoalT, **kwargs: Any) -> Any:
        """Send a goal and wait for its result. Deadlocks in a callback. Takes the keywords of `send_goal_async`."""
        handle = _wait(self.send_goal_async(goal, **kwargs))
        if not isinstance(handle, ClientGoalHandle):
            raise TypeError(f"Expected type ClientGoalHandle but received {type(handle)}")
        return handle.get_result()

    def send_goal_async(
        self,
        goal: GoalT,
        feedback_callback: Callable[[Any], Any] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Future[ClientGoalHandle[Any, Any, Any]]:
        """Send a goal; the future's result is a ClientGoalHandle as soon as a server accepted or rejected it.

        TypeError if `goal` is no Goal of the action's type.
        """
        expected = self._action_type.Goal
        if not isinstance(goal, expected):
            raise TypeError(f"Expected goal type ({type(expected)}) but received ({type(goal)})")
        self._check()
        request = self._action_type.Impl.SendGoalService.Request()
        request.goal_id = UUID(uuid=list(uuid.uuid4().bytes)) if goal_uuid is None else goal_uuid
        request.goal = goal
        if feedback_callback is not None:
            self._feedback_callbacks[key_of(request.goal_id)] = feedback_callback
        future: Future[ClientGoalHandle[Any, Any, Any]] = self._new_future()
        with self._lock:
            self._goals[self._goal_client.send_request(request)] = (future, request.goal_id)
        return future

    def _cancel_goal_async(self, goal_handle: ClientGoalHandle[Any, Any, Any]) -> Future[Any]:
        _require_goal_handle(goal_handle)
        self._check()
        request = CancelGoal.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        future = self._new_future()
        with self._lock:
            self._cancels[self._cancel_client.send_request(request)] = future
        return future

    def _get_result_async(self, goal_handle: ClientGoalHandle[Any, Any, Any]) -> Future[Any]:
        _require_goal_handle(goal_handle)
        self._check()
        request = self._action_type.Impl.GetResultService.Request()
        request.goal_id = goal_handle.goal_id
        future = self._new_future()
        with self._lock:
            self._results[self._result_client.send_request(request)] = (future, key_of(goal_handle.goal_id))
        return future

    def _new_future(self) -> Future[Any]:
        """Return a future whose callbacks run in the node's executor, as those of a real waitable."""
        future: Future[Any] = Future()
        executor = self._node.executor
        if executor is not None:
            future._set_executor(executor)
        return future

    # answers

    async def _on_goal_response(self, taken: tuple[Any, int]) -> None:
        response, number = taken
        with self._lock:
            pending = self._goals.pop(number, None)
        if pending is None:
            self._unexpected("goal")
            return
        future, goal_id = pending
        handle: ClientGoalHandle[Any, Any, Any] = ClientGoalHandle(self, goal_id, response)
        if handle.accepted:
            key = key_of(goal_id)
            if key in self._goal_handles:
                raise RuntimeError(f"Two goals were accepted with the same ID ({handle})")
            self._goal_handles[key] = weakref.ref(handle)
        future.set_result(handle)

    async def _on_cancel_response(self, taken: tuple[Any, int]) -> None:
        response, number = taken
        with self._lock:
            future = self._cancels.pop(number, None)
        if future is None:
            self._unexpected("cancel")
        else:
            future.set_result(response)

    async def _on_result_response(self, taken: tuple[Any, int]) -> None:
        response, number = taken
        with self._lock:
            pending = self._results.pop(number, None)
        if pending is None:
            self._unexpected("result")
            return
        future, key = pending
        self._feedback_callbacks.pop(key, None)
        future.set_result(response)

    async def _on_feedback(self, sample: Any) -> None:
        callback = self._feedback_callbacks.get(key_of(sample[0].goal_id))
        if callback is not None:
            await await_or_execute(callback, sample[0])

    async def _on_status(self, sample: Any) -> None:
        for entry in sample[0].status_list:
            key = key_of(entry.goal_info.goal_id)
            reference = self._goal_handles.get(key)
            if reference is None:
                continue
            handle = reference()
            if handle is not None:
                handle._status = entry.status
            if handle is None or entry.status in _TERMINAL:
                del self._goal_handles[key]

    def _unexpected(self, kind: str) -> None:
        self._logger.warning(
            f"Ignoring unexpected {kind} response. There may be more than "
            f"one action server for the action '{self._action_name}'"
        )

    # the server

    def server_is_ready(self) -> bool:
        """Say whether a server of the action is there, with all its services and topics."""
        self._check()
        clients = (self._goal_client, self._cancel_client, self._result_client)
        listeners = [endpoint for endpoint, _ in self._receivers if endpoint not in clients]
        return all(each.service_is_ready() for each in clients) and all(each.matched for each in listeners)

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Block until a server is there; False when `timeout_sec` passed first (None or negative: no limit)."""
        changed = threading.Event()
        context = self._node.context
        remove = self._node._graph_node.graph.add_listener(lambda _: changed.set())
        try:
            time = context._time.steady_ns
            end = None if timeout_sec is None or timeout_sec < 0 else time() + int(timeout_sec * 1e9)
            while context.ok() and not self.server_is_ready():
                left = _WAIT_STEP_SECONDS if end is None else min(_WAIT_STEP_SECONDS, (end - time()) / 1e9)
                if left <= 0:
                    return False
                changed.wait(left)
                changed.clear()
            return self.server_is_ready()
        finally:
            remove()


def _require_goal_handle(goal_handle: object) -> None:
    if not isinstance(goal_handle, ClientGoalHandle):
        raise TypeError(f"Expected type ClientGoalHandle but received {type(goal_handle)}")
