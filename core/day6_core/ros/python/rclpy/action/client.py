"""Action clients."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from rclpy._day6.entity import NOTHING
from rclpy._day6.handles import INVALID_NODE
from rclpy._day6.incidental import also
from rclpy._day6.time_base import wait_interruptibly
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action._protocol import ABORTED, CANCELED, SUCCEEDED, UNKNOWN, ActionEndpoints
from rclpy.executors import await_or_execute
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import FeedbackT, GoalT, ResultT, check_for_type_support
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from action_msgs.srv import CancelGoal
    from builtin_interfaces.msg import Time
    from typing_extensions import Unpack
    from unique_identifier_msgs.msg import UUID

    from rclpy._day6.typing_names import ActionType, ClientTaken, FeedbackCallback, SendGoalKWargs
    from rclpy._day6.wait_set import WaitSet
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.node import Node
    from rclpy.service_introspection import ServiceIntrospectionState
    from rclpy.type_support import GetResultServiceResponse, SendGoalServiceResponse

T = TypeVar("T")

# Programs import these messages from here too; they are made on first use.
_MESSAGES = {"CancelGoal": "action_msgs.srv", "GoalStatus": "action_msgs.msg", "UUID": "unique_identifier_msgs.msg"}


_also = also(
    __name__,
    "Action Clock FeedbackMessage GetResultServiceResponse GoalStatusArray SendGoalKWargs SendGoalServiceResponse "
    "ServiceIntrospectionState",
)


def __getattr__(name: str) -> Any:
    if name in _MESSAGES:
        from importlib import import_module

        return getattr(import_module(_MESSAGES[name]), name)
    return _also(name)


class ClientGoalHandle(Generic[GoalT, ResultT, FeedbackT]):
    """The client's handle of a goal."""

    def __init__(
        self,
        action_client: ActionClient[GoalT, ResultT, FeedbackT],
        goal_id: UUID,
        goal_response: SendGoalServiceResponse,
    ) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self._status = UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bool(self._goal_id == other.goal_id)

    def __ne__(self, other: object) -> bool:
        return not self.__eq__(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    @property
    def goal_id(self) -> UUID:
        """The goal's UUID."""
        return self._goal_id

    @property
    def stamp(self) -> Time:
        """When the server accepted the goal."""
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        """Whether the server accepted the goal."""
        return self._goal_response.accepted

    @property
    def status(self) -> int:
        """The state of the goal, as last received on the status topic (action_msgs/msg/GoalStatus)."""
        return self._status

    def cancel_goal(self) -> CancelGoal.Response | None:
        """Request to cancel and block for the response; another thread has to spin."""
        return self._action_client._cancel_goal(self)

    def cancel_goal_async(self) -> Future[CancelGoal.Response]:
        """Request to cancel; the future's result is a CancelGoal.Response."""
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> GetResultServiceResponse[ResultT] | None:
        """Block for the result; another thread has to spin."""
        return self._action_client._get_result(self)

    def get_result_async(self) -> Future[GetResultServiceResponse[ResultT]]:
        """Request the result; the future's result has `status` and `result`."""
        return self._action_client._get_result_async(self)


class ActionClient(Waitable["ClientTaken[ResultT, FeedbackT]"], Generic[GoalT, ResultT, FeedbackT]):
    """Sends goals to an action server.

    Raises:
        ValueError: for a bad name.
        AttributeError: for a type that isn't an action.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[ActionType[GoalT, ResultT, FeedbackT]],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = QoSProfile(depth=10),  # noqa: B008
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        super().__init__(node.default_callback_group if callback_group is None else callback_group)
        check_for_type_support(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        failed = "Failed to create action client due to invalid topic name '{}' :"
        self._handle = handle = ActionEndpoints(node.handle, action_type, action_name, failed)
        parts = handle.implementation
        self._goal_client = handle.client("send_goal", parts.SendGoalService, goal_service_qos_profile)
        self._cancel_client = handle.client("cancel_goal", parts.CancelGoalService, cancel_service_qos_profile)
        self._result_client = handle.client("get_result", parts.GetResultService, result_service_qos_profile)
        self._feedback_sub = handle.subscription("feedback", parts.FeedbackMessage, feedback_sub_qos_profile)
        self._status_sub = handle.subscription("status", parts.GoalStatusMessage, status_sub_qos_profile)
        self._status_sub.copies = (
            False  # with each message comes every goal of the last seconds, and they are only read
        )
        self._goal_handles: dict[bytes, weakref.ReferenceType[ClientGoalHandle[GoalT, ResultT, FeedbackT]]] = {}
        self._pending_goals: dict[int, tuple[Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]], UUID]] = {}
        self._pending_cancels: dict[int, Future[CancelGoal.Response]] = {}
        self._pending_results: dict[int, tuple[Future[GetResultServiceResponse[ResultT]], bytes]] = {}
        self._feedback_callbacks: dict[bytes, FeedbackCallback[FeedbackT]] = {}
        self._lock = threading.Lock()
        self._logger = node.get_logger().get_child("action_client")
        for endpoint in handle.endpoints:
            endpoint.on_ready = self._notify
        node.add_waitable(self)

    # -- running -------------------------------------------------------------------------------------------------------

    def _pending(self) -> bool:
        return not self._handle.destroyed and any(endpoint.queue for endpoint in self._handle.endpoints)

    def _process(self) -> Any:
        self._queued = False
        data = self.take_data()
        if not data:
            return NOTHING
        if self._pending():
            self._notify()
        return self.execute(data)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Return whether a response or message has arrived."""
        return self._pending()

    def take_data(self) -> ClientTaken[ResultT, FeedbackT]:
        """Take one response or message of each kind that has arrived."""
        if self._handle.destroyed:
            return {}
        taken = {
            "goal": self._handle.take(self._goal_client),
            "cancel": self._handle.take(self._cancel_client),
            "result": self._handle.take(self._result_client),
            "feedback": self._feedback_sub.take(),
            "status": self._status_sub.take(),
        }
        found = {kind: data for kind, data in taken.items() if data is not None}
        return cast("ClientTaken[ResultT, FeedbackT]", found)

    async def execute(self, taken_data: ClientTaken[ResultT, FeedbackT]) -> None:
        """Process the taken responses and messages."""
        if "goal" in taken_data:
            self._on_goal_response(*taken_data["goal"])
        if "cancel" in taken_data:
            response, number = taken_data["cancel"]
            self._finish(self._pending_cancels.get(number), response, "cancel")
        if "result" in taken_data:
            response, number = taken_data["result"]
            with self._lock:
                future, _ = self._pending_results.get(number, (None, b""))
            self._finish(future, response, "result")
        if "feedback" in taken_data:
            message = taken_data["feedback"][0]
            callback = self._feedback_callbacks.get(bytes(message.goal_id.uuid))
            if callback is not None:
                await await_or_execute(callback, message)
        if "status" in taken_data:
            for each in taken_data["status"][0].status_list:
                self._on_status(bytes(each.goal_info.goal_id.uuid), each.status)

    def _finish(self, future: Future[T] | None, result: T, what: str) -> None:
        if future is None:
            self._logger.warning(
                f"Ignoring unexpected {what} response. There may be more than one action server for the action "
                f"'{self._action_name}'"
            )
            return
        scope = self._scope
        future._set_executor(None if scope is None else scope.executor)
        future.set_result(result)

    def _remove_pending_goal_request(self, future: Future[Any]) -> None:
        self._remove_pending(future, self._pending_goals, lambda pending: pending[0])

    def _remove_pending_cancel_request(self, future: Future[Any]) -> None:
        self._remove_pending(future, self._pending_cancels, lambda pending: pending)

    def _remove_pending_result_request(self, future: Future[Any]) -> None:
        pending = self._remove_pending(future, self._pending_results, lambda pending: pending[0])
        if pending is not None:
            self._feedback_callbacks.pop(pending[1], None)

    def _remove_pending(
        self, future: Future[Any], requests: dict[int, Any], future_of: Callable[[Any], Future[Any]]
    ) -> Any:
        with self._lock:
            for number, pending in requests.items():
                if future_of(pending) is future:
                    self.remove_future(future)
                    return requests.pop(number)
        return None

    def _on_goal_response(self, response: Any, number: int) -> None:
        with self._lock:
            future, goal_id = self._pending_goals.get(number, (None, None))
        if future is None or goal_id is None:
            self._finish(None, None, "goal")
            return
        goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT] = ClientGoalHandle(self, goal_id, response)
        if goal_handle.accepted:
            key = bytes(goal_id.uuid)
            if key in self._goal_handles:
                raise RuntimeError(f"Two goals were accepted with the same ID ({goal_handle})")
            self._goal_handles[key] = weakref.ref(goal_handle)
        self._finish(future, goal_handle, "goal")

    def _on_status(self, key: bytes, status: int) -> None:
        reference = self._goal_handles.get(key)
        if reference is None:
            return
        goal_handle = reference()
        if goal_handle is not None:
            goal_handle._status = status
        if goal_handle is None or status in (SUCCEEDED, CANCELED, ABORTED):
            del self._goal_handles[key]

    def get_num_entities(self) -> NumberOfEntities:
        """Return two subscriptions and three clients."""
        return NumberOfEntities(2, 0, 0, 3, 0)

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Do nothing: responses and messages announce themselves."""

    def __enter__(self) -> None:
        self._handle.check()

    def __exit__(self, t: object, v: object, tb: object) -> None:
        pass

    # -- goals ---------------------------------------------------------------------------------------------------------

    def _check_goal(self, goal: Any) -> None:
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError(f"Expected goal type ({type(self._action_type.Goal)}) but received ({type(goal)})")

    def _generate_random_uuid(self) -> UUID:
        import os

        from unique_identifier_msgs.msg import UUID

        random = bytearray(os.urandom(16))
        random[6] = random[6] & 0x0F | 0x40
        random[8] = random[8] & 0x3F | 0x80
        return UUID(uuid=list(random))

    def send_goal(
        self, goal: GoalT, **kwargs: Unpack[SendGoalKWargs[FeedbackT]]
    ) -> GetResultServiceResponse[ResultT] | None:
        """Send a goal and block for its result; another thread has to spin.

        Raises:
            TypeError: for anything that isn't a goal.
        """
        self._check_goal(goal)
        goal_handle = _wait_for(self.send_goal_async(goal, **kwargs))
        if not isinstance(goal_handle, ClientGoalHandle):
            raise TypeError(f"Expected type ClientGoalHandle but received {type(goal_handle)}")
        return self._get_result(goal_handle)

    def send_goal_async(
        self,
        goal: GoalT,
        feedback_callback: FeedbackCallback[FeedbackT] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]]:
        """Send a goal; the future's result is a ClientGoalHandle.

        `feedback_callback(message)` is called for each feedback message until the result is there.

        Raises:
            TypeError: for anything that isn't a goal.
        """
        self._check_goal(goal)
        if self._handle.destroyed:
            reason = "action client pointer is invalid, at /project/src/rcl_action/action_client.c:493"
            raise RCLError(f"Failed to send goal request: {reason}")
        goal_id = self._generate_random_uuid() if goal_uuid is None else goal_uuid
        request = self._handle.implementation.SendGoalService.Request(goal_id=goal_id, goal=goal)
        key = bytes(goal_id.uuid)
        if feedback_callback is not None:
            self._feedback_callbacks[key] = feedback_callback
        future: Future[ClientGoalHandle[GoalT, ResultT, FeedbackT]] = Future()
        with self._lock:
            self.add_future(future)
            self._pending_goals[self._handle.send_request(self._goal_client, request)] = (future, goal_id)
        future.add_done_callback(self._remove_pending_goal_request)
        return future

    def _check_goal_handle(self, goal_handle: Any) -> None:
        if not isinstance(goal_handle, ClientGoalHandle):
            raise TypeError(f"Expected type ClientGoalHandle but received {type(goal_handle)}")
        self._handle.check()

    def _cancel_goal(self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]) -> CancelGoal.Response | None:
        return _wait_for(self._cancel_goal_async(goal_handle))

    def _cancel_goal_async(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> Future[CancelGoal.Response]:
        self._check_goal_handle(goal_handle)
        request = self._handle.implementation.CancelGoalService.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        future: Future[CancelGoal.Response] = Future()
        with self._lock:
            self.add_future(future)
            self._pending_cancels[self._handle.send_request(self._cancel_client, request)] = future
        future.add_done_callback(self._remove_pending_cancel_request)
        return future

    def _get_result(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> GetResultServiceResponse[ResultT] | None:
        return _wait_for(self._get_result_async(goal_handle))

    def _get_result_async(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT]
    ) -> Future[GetResultServiceResponse[ResultT]]:
        self._check_goal_handle(goal_handle)
        request = self._handle.implementation.GetResultService.Request(goal_id=goal_handle.goal_id)
        future: Future[GetResultServiceResponse[ResultT]] = Future()
        with self._lock:
            self.add_future(future)
            number = self._handle.send_request(self._result_client, request)
            self._pending_results[number] = (future, bytes(goal_handle.goal_id.uuid))
        future.add_done_callback(self._remove_pending_result_request)
        return future

    # -- the server ----------------------------------------------------------------------------------------------------

    def _has_server(self) -> bool:
        clients = (self._goal_client, self._cancel_client, self._result_client)
        topics = (self._feedback_sub, self._status_sub)
        return all(client.matched for client in clients) and all(topic.matched for topic in topics)

    def server_is_ready(self) -> bool:
        """Return whether a server of the action exists."""
        self._node.handle.check()
        failed = "Failed to check if action server is available"
        if self._handle.destroyed:
            raise RCLError(f"{failed}: rcl node pointer is invalid, at /project/src/rcl/node.c:386")
        if not self._node.context._valid:
            raise RCLError(f"{failed}: {INVALID_NODE}")
        return self._has_server()

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Block until a server exists, at most `timeout_sec` seconds (None: no limit); returns whether one does."""
        if not self.server_is_ready():
            self._node.context._wait_for_graph(self._has_server, timeout_sec)
        return self.server_is_ready()

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish requests and responses of the action's services on `…/_service_event`."""
        self._handle.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        """Take the client out of the graph.

        Raises:
            ValueError: the second time.
        """
        self._handle.destroy()
        self._node.remove_waitable(self)


def _wait_for(future: Future[T]) -> T | None:
    """Block until a future is done; returns its result or raises its exception."""
    done = threading.Event()
    future._watch(done.set)
    wait_interruptibly(done, None)
    return future.result()
