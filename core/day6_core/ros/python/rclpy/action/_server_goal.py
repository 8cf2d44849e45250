"""The server's handle of a goal, and the return values of a server's callbacks."""

from __future__ import annotations

import threading
from collections.abc import Awaitable, Callable
from enum import Enum
from typing import TYPE_CHECKING, Generic, Literal

from day6_core.ros.differences import value
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import GoalEvent
from rclpy.action._protocol import ABORTED, ACCEPTED, CANCELED, CANCELING, EXECUTING, SUCCEEDED, UNKNOWN, next_state
from rclpy.type_support import FeedbackT, GoalT, ResultT

if TYPE_CHECKING:
    from action_msgs.msg import GoalInfo, GoalStatus
    from unique_identifier_msgs.msg import UUID

    from rclpy.action.server import ActionServer

    ExecuteCallback = Callable[["ServerGoalHandle[GoalT, ResultT, FeedbackT]"], ResultT | Awaitable[ResultT]]
    AcceptedCallback = Callable[["ServerGoalHandle[GoalT, ResultT, FeedbackT]"], object]
    GoalCallback = Callable[[GoalT], "GoalResponse | Awaitable[GoalResponse]"]
    CancelCallback = Callable[
        ["ServerGoalHandle[GoalT, ResultT, FeedbackT]"], "CancelResponse | Awaitable[CancelResponse]"
    ]


_ENDS = {GoalEvent.SUCCEED: "succeed", GoalEvent.ABORT: "abort", GoalEvent.CANCELED: "canceled"}
_TERMINAL = (SUCCEEDED, CANCELED, ABORTED)


class GoalResponse(Enum):
    """Return values of a goal callback."""

    __module__ = "rclpy.action.server"

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """Return values of a cancel callback."""

    __module__ = "rclpy.action.server"

    REJECT = 1
    ACCEPT = 2


class ServerGoalHandle(Generic[GoalT, ResultT, FeedbackT]):
    """The server's handle of a goal."""

    __module__ = "rclpy.action.server"

    def __init__(
        self, action_server: ActionServer[GoalT, ResultT, FeedbackT], goal_info: GoalInfo, goal_request: GoalT
    ) -> None:
        self._action_server = action_server
        self._goal_info = goal_info
        self._goal_request = goal_request
        self._state = ACCEPTED
        self._destroyed = False
        self._ended_ns: int | None = None
        self._returns_result = False
        """Whether a callback executes the goal, which returns its result."""
        self._lock = threading.Lock()
        self._last_status: GoalStatus | None = None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bool(self.goal_id == other.goal_id)

    def __ne__(self, other: object) -> bool:
        return not self.__eq__(other)

    __hash__ = None  # type: ignore[assignment]

    @property
    def request(self) -> GoalT:
        """The goal."""
        return self._goal_request

    @property
    def goal_id(self) -> UUID:
        """The goal's UUID."""
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        """Whether the goal is accepted, executing or canceling."""
        return not self._destroyed and self._state not in _TERMINAL

    @property
    def is_cancel_requested(self) -> bool:
        """Whether a request to cancel was accepted."""
        return self.status == CANCELING

    @property
    def status(self) -> int:
        """The state of the goal (action_msgs/msg/GoalStatus)."""
        return UNKNOWN if self._destroyed else self._state

    def _as_status(self) -> GoalStatus:
        """Return the state for the status topic: a message that never changes, the same one until the state does."""
        status, last = self.status, self._last_status
        if last is None or last.status != status:
            from action_msgs.msg import GoalStatus

            self._last_status = last = GoalStatus(goal_info=self._goal_info, status=status)
        return last

    def _end(self, event: GoalEvent, response: ResultT | None) -> None:
        if response is not None and not value("action.execute_callback_is_optional"):
            raise TypeError(f"ServerGoalHandle.{_ENDS[event]}() takes 1 positional argument but 2 were given")
        self._update_state(event)
        if response is None and not self._returns_result:
            response = self._action_server.action_type.Result()
        if response is not None:
            self._action_server._set_result(self, response)

    def _update_state(self, event: GoalEvent) -> None:
        with self._lock:
            if self._destroyed:
                return
            self._state = next_state(self._state, event)
            ended = self._state in _TERMINAL
        self._action_server._publish_status()
        if ended:
            self._action_server._goal_ended(self)

    def execute(self, execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] | None = None) -> None:
        """Start to execute the goal with this function, by default the server's."""
        if not self.is_cancel_requested:
            self._update_state(GoalEvent.EXECUTE)
        self._action_server.notify_execute(self, execute_callback)

    def executing(self) -> None:
        """Set the goal to executing, without a callback that executes it. RCLError in a state where that is impossible."""
        self._update_state(GoalEvent.EXECUTE)

    def publish_feedback(self, feedback: FeedbackT) -> None:
        """Send feedback; in newer distributions only while the goal is executing, else warn.

        Raises:
            TypeError: for anything that isn't feedback of the action.
        """
        if not isinstance(feedback, self._action_server.action_type.Feedback):
            raise TypeError
        if self._destroyed:
            return
        if self._state != EXECUTING and value("action.feedback_only_while_executing"):
            self._action_server._logger.warning("publish_feedback() has no effect: the goal is not executing")
            return
        self._action_server._publish_feedback(self.goal_id, feedback)

    def succeed(self, response: ResultT | None = None) -> None:
        """Set the goal to succeeded, with a result unless a callback returns it. RCLError in a state where that is impossible."""
        self._end(GoalEvent.SUCCEED, response)

    def abort(self, response: ResultT | None = None) -> None:
        """Set the goal to aborted, with a result unless a callback returns it. RCLError in a state where that is impossible."""
        self._end(GoalEvent.ABORT, response)

    def canceled(self, response: ResultT | None = None) -> None:
        """Set the goal to canceled, with a result unless a callback returns it. RCLError unless canceling was accepted."""
        self._end(GoalEvent.CANCELED, response)

    def destroy(self) -> None:
        """Make the handle unusable."""
        self._destroyed = True


def default_handle_accepted_callback(goal_handle: ServerGoalHandle[GoalT, ResultT, FeedbackT]) -> None:
    """Execute the goal at once."""
    goal_handle.execute()


def default_goal_callback(goal_request: object) -> Literal[GoalResponse.ACCEPT]:
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: object) -> Literal[CancelResponse.REJECT]:
    """Reject every request to cancel."""
    return CancelResponse.REJECT


withdraw(__name__)
