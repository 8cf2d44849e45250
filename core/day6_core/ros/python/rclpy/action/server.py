"""Action servers."""

from __future__ import annotations

import threading
import traceback
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, cast

from day6_core.ros.differences import value
from rclpy._day6.entity import NOTHING
from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import GoalEvent as GoalEvent
from rclpy._rclpy_pybind11 import RCLError as RCLError
from rclpy.action._protocol import (
    UNKNOWN,
    ActionEndpoints,
)
from rclpy.action._server_goal import CancelResponse as CancelResponse
from rclpy.action._server_goal import GoalResponse as GoalResponse
from rclpy.action._server_goal import ServerGoalHandle as ServerGoalHandle
from rclpy.action._server_goal import default_cancel_callback as default_cancel_callback
from rclpy.action._server_goal import default_goal_callback as default_goal_callback
from rclpy.action._server_goal import default_handle_accepted_callback as default_handle_accepted_callback
from rclpy.constants import S_TO_NS
from rclpy.executors import await_or_execute
from rclpy.logging import LoggingSeverity
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.timer import Timer
from rclpy.type_support import FeedbackT, GoalT, ResultT, check_for_type_support
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from unique_identifier_msgs.msg import UUID

    from day6_core.graph import RequestId
    from rclpy._day6.entity import Scope
    from rclpy._day6.typing_names import ActionType, ServerTaken
    from rclpy._day6.wait_set import WaitSet
    from rclpy.action._server_goal import AcceptedCallback, CancelCallback, ExecuteCallback, GoalCallback
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.node import Node
    from rclpy.service_introspection import ServiceIntrospectionState


# action_msgs/srv/CancelGoal
_ERROR_UNKNOWN_GOAL_ID = 2
_ERROR_GOAL_TERMINATED = 3

_NEGATIVE_TIMEOUT = "Failed to create action server: timer period must be non-negative, at /project/src/rcl/timer.c:144"
_INVALID = "feedback publisher is invalid, at /project/src/rcl_action/action_server.c:1040"

_MESSAGES = {"CancelGoal": "action_msgs.srv", "GoalInfo": "action_msgs.msg", "GoalStatus": "action_msgs.msg"}


_also = also(
    __name__,
    "Action Clock FeedbackMessage GetResultServiceRequest GetResultServiceResponse SendGoalServiceRequest "
    "ServiceIntrospectionState Task UUID",
)


def __getattr__(name: str) -> Any:
    if name in _MESSAGES:
        from importlib import import_module

        return getattr(import_module(_MESSAGES[name]), name)
    return _also(name)


_OPTIONAL = "action.execute_callback_is_optional"


class ActionServer(Waitable["ServerTaken[GoalT]"], Generic[GoalT, ResultT, FeedbackT]):
    """Serves an action.

    `execute_callback(goal_handle)` runs as a task of the executor and returns the result, after calling `succeed`, `abort` or
    `canceled` of the handle. Without it (since Lyrical), one of those is called later, from anywhere, and given the result.
    `goal_callback(goal)` accepts or rejects goals, `handle_accepted_callback(goal_handle)` decides when they are executed,
    `cancel_callback(goal_handle)` accepts or rejects requests to cancel. Results are kept `result_timeout` seconds.

    Raises:
        TypeError: for a callback that isn't callable.
        ValueError: for a bad name or a negative `result_timeout`.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[ActionType[GoalT, ResultT, FeedbackT]],
        action_name: str,
        execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] | None = None,
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: GoalCallback[GoalT] | None = default_goal_callback,
        handle_accepted_callback: (
            AcceptedCallback[GoalT, ResultT, FeedbackT] | None
        ) = default_handle_accepted_callback,
        cancel_callback: CancelCallback[GoalT, ResultT, FeedbackT] | None = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = QoSProfile(depth=10),  # noqa: B008
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: int = 10,
    ) -> None:
        if execute_callback is None and not value(_OPTIONAL):
            raise TypeError("ActionServer.__init__() missing 1 required positional argument: 'execute_callback'")
        super().__init__(node.default_callback_group if callback_group is None else callback_group)
        self._lock = threading.Lock()
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self.register_execute_callback(execute_callback)
        check_for_type_support(action_type)
        if result_timeout < 0:
            raise ValueError(_NEGATIVE_TIMEOUT)
        self._node = node
        self._action_type = action_type
        failed = "Failed to create action server due to invalid topic name '{}' : :"
        self._handle = handle = ActionEndpoints(node.handle, action_type, action_name, failed)
        parts = handle.implementation
        self._goal_service = handle.service("send_goal", parts.SendGoalService, goal_service_qos_profile)
        self._cancel_service = handle.service("cancel_goal", parts.CancelGoalService, cancel_service_qos_profile)
        self._result_service = handle.service("get_result", parts.GetResultService, result_service_qos_profile)
        self._feedback_pub = handle.publisher("feedback", parts.FeedbackMessage, feedback_pub_qos_profile)
        self._status_pub = handle.publisher("status", parts.GoalStatusMessage, status_pub_qos_profile)
        self._status_pub.keep = lambda message: message  # see `_publish_status`
        self._unsettled: ExecuteCallback[GoalT, ResultT, FeedbackT] | None = None
        """The function that returned and left its goal as it was, for the inspector."""
        self._goal_handles: dict[bytes, ServerGoalHandle[GoalT, ResultT, FeedbackT]] = {}
        self._result_futures: dict[bytes, Future[Any]] = {}
        self._result_timeout_ns = int(float(result_timeout) * S_TO_NS)
        self._expiry = Timer(
            self._expire_goals,
            self.callback_group,
            0,
            node.get_clock(),
            context=node.context,
            autostart=False,
        )
        self._logger = node.get_logger().get_child("action_server")
        if execute_callback is None and handle_accepted_callback is default_handle_accepted_callback:
            self._logger.warning("Not handling nor executing the goal, this server will do nothing")
        for service in (self._goal_service, self._cancel_service, self._result_service):
            service.on_ready = self._notify
        node.add_waitable(self)
        # Not one of the node's own `timers`.
        node.handle.scope.timed.append(self._expiry)

    def _enter(self, scope: Scope) -> None:
        super()._enter(scope)
        self._expiry._enter(scope)

    # -- running -------------------------------------------------------------------------------------------------------

    def _pending(self) -> bool:
        services = (self._goal_service, self._cancel_service, self._result_service)
        return not self._handle.destroyed and any(service.queue for service in services)

    def _process(self) -> Any:
        self._queued = False
        data = self.take_data()
        if not data:
            return NOTHING
        if self._pending():
            self._notify()
        return self.execute(data)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Return whether a request has arrived."""
        return self._pending()

    def take_data(self) -> ServerTaken[GoalT]:
        """Take one request of each kind that has arrived."""
        if self._handle.destroyed:
            return {}
        taken = {
            "goal": self._handle.take(self._goal_service),
            "cancel": self._handle.take(self._cancel_service),
            "result": self._handle.take(self._result_service),
        }
        found = {kind: data for kind, data in taken.items() if data is not None}
        return cast("ServerTaken[GoalT]", found)

    async def execute(self, taken_data: ServerTaken[GoalT]) -> None:
        """Process the taken requests."""
        if "goal" in taken_data:
            await self._execute_goal_request(*taken_data["goal"])
        if "cancel" in taken_data:
            await self._execute_cancel_request(*taken_data["cancel"])
        if "result" in taken_data:
            self._execute_get_result_request(*taken_data["result"])

    async def _execute_goal_request(self, request: Any, request_id: RequestId) -> None:
        from action_msgs.msg import GoalInfo

        goal_uuid = request.goal_id
        key = bytes(goal_uuid.uuid)
        self._debug(lambda: f"New goal request with ID: {goal_uuid.uuid}")
        accepted = False
        if key not in self._goal_handles:
            decision = await await_or_execute(self._goal_callback, request.goal)
            if isinstance(decision, GoalResponse):
                accepted = decision is GoalResponse.ACCEPT
            else:
                self._logger.warning("Goal request callback did not return a GoalResponse type. Rejecting goal.")
        response = self._handle.implementation.SendGoalService.Response(accepted=accepted)
        goal_info = GoalInfo(goal_id=goal_uuid)
        goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT] | None = None
        if accepted:
            goal_info.stamp = response.stamp = self._node.get_clock().now().to_msg()
            goal_handle = ServerGoalHandle(self, goal_info, request.goal)
            self._goal_handles[key] = goal_handle
            future: Future[Any] = Future()
            self._result_futures[key] = future
            self.add_future(future)
        self._handle.send_response(self._goal_service, request_id, response)
        if goal_handle is None:
            self._debug(lambda: f"New goal rejected: {goal_uuid.uuid}")
            return
        self._debug(lambda: f"New goal accepted: {goal_uuid.uuid}")
        self._publish_status()
        await await_or_execute(self._handle_accepted_callback, goal_handle)

    async def _execute_goal(
        self,
        execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT],
        goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT],
    ) -> None:
        goal_uuid = goal_handle.goal_id.uuid
        self._debug(lambda: f"Executing goal with ID {goal_uuid}")
        try:
            result = await await_or_execute(execute_callback, goal_handle)
            if goal_handle.is_active:
                self._unsettled = execute_callback
        except Exception as error:
            result = self._action_type.Result()
            self._logger.error(f"Error raised in execute callback: {error}")
            traceback.print_exc()
        if goal_handle.is_active:
            self._logger.warning(f"Goal state not set, assuming aborted. Goal ID: {goal_uuid}")
            goal_handle.abort()
        self._debug(lambda: f"Goal with ID {goal_uuid} finished with state {goal_handle.status}")
        self._set_result(goal_handle, result)

    def _set_result(self, goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT], result: object) -> None:
        """Answer, now and later, who asks for the result of a goal; only the first result counts."""
        future = self._result_futures.get(bytes(goal_handle.goal_id.uuid))
        if future is not None and not future.done():
            scope = self._scope
            future._set_executor(None if scope is None else scope.executor)
            future.set_result((goal_handle.status, result))

    async def _execute_cancel_request(self, request: Any, request_id: RequestId) -> None:
        self._debug(lambda: f"Cancel request received: {request}")
        code, candidates = self._cancelable(request)
        response = self._handle.implementation.CancelGoalService.Response(return_code=code)
        for goal_handle in candidates:
            decision = await await_or_execute(self._cancel_callback, goal_handle)
            if decision is not CancelResponse.ACCEPT:
                continue
            try:
                goal_handle._update_state(GoalEvent.CANCEL_GOAL)
            except RCLError as error:
                self._logger.debug(f"Failed to cancel goal in cancel callback: {error}")
                continue
            response.goals_canceling.append(goal_handle._goal_info)
        self._handle.send_response(self._cancel_service, request_id, response)

    def _cancelable(self, request: Any) -> tuple[int, list[ServerGoalHandle[GoalT, ResultT, FeedbackT]]]:
        """Return error code and goals of a cancel request: one by id, all until a time, both, or (neither given) all."""
        key = bytes(request.goal_info.goal_id.uuid)
        stamp = (request.goal_info.stamp.sec, request.goal_info.stamp.nanosec)
        handles = list(self._goal_handles.items())
        if any(key) and stamp == (0, 0):
            wanted = self._goal_handles.get(key)
            if wanted is None:
                return _ERROR_UNKNOWN_GOAL_ID, []
            if not wanted.is_active or wanted.is_cancel_requested:
                return _ERROR_GOAL_TERMINATED, []
            return 0, [wanted]
        everything = stamp == (0, 0)

        def meant(own_key: bytes, goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]) -> bool:
            own = goal_handle._goal_info.stamp
            return everything or own_key == key or (own.sec, own.nanosec) <= stamp

        return 0, [
            goal_handle
            for own_key, goal_handle in handles
            if goal_handle.is_active and not goal_handle.is_cancel_requested and meant(own_key, goal_handle)
        ]

    def _execute_get_result_request(self, request: Any, request_id: RequestId) -> None:
        goal_uuid = request.goal_id.uuid
        self._debug(lambda: f"Result request received for goal with ID: {goal_uuid}")
        future = self._result_futures.get(bytes(goal_uuid))
        if future is None:
            self._logger.warning(f"Sending result response for unknown or expired goal ID: {goal_uuid}")
            response = self._handle.implementation.GetResultService.Response(status=UNKNOWN)
            self._handle.send_response(self._result_service, request_id, response)
            return
        future.add_done_callback(partial(self._send_result_response, request_id))

    def _send_result_response(self, request_id: RequestId, future: Future[Any]) -> None:
        outcome = future.result()
        if outcome is None or self._handle.destroyed:
            return
        status, result = outcome
        if not isinstance(result, self._action_type.Result):
            # Raises rosidl's AttributeError for the first field that something other than a result lacks.
            for name in self._action_type.Result.get_fields_and_field_types():
                getattr(result, name)
        response = self._handle.implementation.GetResultService.Response(status=status, result=result)
        self._handle.send_response(self._result_service, request_id, response)

    def _debug(self, text: Callable[[], str]) -> None:
        """Log what takes longer to write than all the rest of a goal, if anybody wants it."""
        if self._logger.is_enabled_for(LoggingSeverity.DEBUG):
            self._logger.debug(text())

    # -- goals ---------------------------------------------------------------------------------------------------------

    def _check_context(self, failed: str) -> None:
        # This is what ends a goal that is still being executed after Ctrl-C.
        if not self._node.context._valid:
            raise RCLError(f"{failed}: {_INVALID}")

    def _publish_status(self) -> None:
        """Publish the states of all goals whose results are kept. Neither the message nor the states in it change afterwards."""
        self._check_context("Failed get goal status array")
        message = self._handle.implementation.GoalStatusMessage()
        message.status_list = [goal_handle._as_status() for goal_handle in list(self._goal_handles.values())]
        if not self._handle.destroyed:
            self._status_pub.publish(message)

    def _publish_feedback(self, goal_id: UUID, feedback: FeedbackT) -> None:
        self._check_context("Failed to publish feedback with an action server")
        if not self._handle.destroyed:
            message = self._handle.implementation.FeedbackMessage(goal_id=goal_id, feedback=feedback)
            self._feedback_pub.publish(message)

    def _goal_ended(self, goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]) -> None:
        goal_handle._ended_ns = self._node.get_clock()._now_ns()
        self.notify_goal_done()

    def notify_goal_done(self) -> None:
        """Schedule the removal of ended goals whose results have been kept long enough."""
        if self._handle.destroyed:
            return
        now = self._node.get_clock()._now_ns()
        ends = [handle._ended_ns for handle in list(self._goal_handles.values()) if handle._ended_ns is not None]
        if ends:
            self._expiry.timer_period_ns = max(0, min(ends) + self._result_timeout_ns - now)
            self._expiry.reset()

    def _expire_goals(self) -> None:
        self._expiry.cancel()
        now = self._node.get_clock()._now_ns()
        for key, goal_handle in list(self._goal_handles.items()):
            ended = goal_handle._ended_ns
            if ended is not None and ended + self._result_timeout_ns <= now:
                goal_handle.destroy()
                del self._goal_handles[key]
                self.remove_future(self._result_futures.pop(key))
        self.notify_goal_done()

    @property
    def action_type(self) -> type[ActionType[GoalT, ResultT, FeedbackT]]:
        """The action's class."""
        return self._action_type

    def notify_execute(
        self,
        goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT],
        execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] | None,
    ) -> None:
        """Execute a goal as a task of the node's executor."""
        executor, callback = self._node.executor, execute_callback or self._execute_callback
        if executor is not None and callback is not None:
            goal_handle._returns_result = True
            executor.create_task(self._execute_goal, callback, goal_handle)

    # -- callbacks -----------------------------------------------------------------------------------------------------

    def register_handle_accepted_callback(
        self, handle_accepted_callback: AcceptedCallback[GoalT, ResultT, FeedbackT] | None
    ) -> None:
        """Set the function called for every accepted goal; None: execute it at once."""
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_goal_callback(self, goal_callback: GoalCallback[GoalT] | None) -> None:
        """Set the function that accepts or rejects goals; None: accept all."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_cancel_callback(self, cancel_callback: CancelCallback[GoalT, ResultT, FeedbackT] | None) -> None:
        """Set the function that accepts or rejects requests to cancel; None: reject all."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] | None) -> None:
        """Set the function that executes goals; None: none does.

        Raises:
            TypeError: if it isn't callable.
        """
        if not callable(execute_callback) and not (execute_callback is None and value(_OPTIONAL)):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    # -- end -----------------------------------------------------------------------------------------------------------

    def get_num_entities(self) -> NumberOfEntities:
        """Return one timer and three services."""
        return NumberOfEntities(0, 0, 1, 0, 3)

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Do nothing: requests announce themselves."""

    def __enter__(self) -> None:
        self._handle.check()

    def __exit__(self, t: object, v: object, tb: object) -> None:
        pass

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish requests and responses of the action's services on `…/_service_event`."""
        self._handle.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Take the server out of the graph.

        Raises:
            ValueError: the second time.
        """
        for goal_handle in self._goal_handles.values():
            goal_handle.destroy()
        self._handle.destroy()
        self._expiry.destroy()
        timed = self._node.handle.scope.timed
        if self._expiry in timed:
            timed.remove(self._expiry)
        self._node.remove_waitable(self)
