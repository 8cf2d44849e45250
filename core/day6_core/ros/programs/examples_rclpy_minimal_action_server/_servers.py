"""Four ways to treat goals that come while others are being worked on."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

from example_interfaces.action import Fibonacci

from day6_core.ros.programs._waiting import pause
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup

if TYPE_CHECKING:
    from typing import TypeAlias

    from rclpy.action.server import ServerGoalHandle
    from rclpy.node import Node

    Handle: TypeAlias = ServerGoalHandle[Any, Any, Any]


class PlainServer:
    """The action `fibonacci`: every goal is accepted and worked on at once. `quiet`: a new goal is not logged."""

    def __init__(self, node: Node, *, quiet: bool = False) -> None:
        self.node = node
        self.quiet = quiet
        self.info = node.get_logger().info
        self.server: ActionServer[Any, Any, Any] = ActionServer(
            node,
            Fibonacci,
            "fibonacci",
            self._execute,
            callback_group=ReentrantCallbackGroup(),
            goal_callback=self._accept,
            handle_accepted_callback=self._accepted,
            cancel_callback=self._cancel,
        )

    def _accept(self, goal: Any) -> GoalResponse:
        if not self.quiet:
            self.info("Received goal request")
        return GoalResponse.ACCEPT

    def _accepted(self, handle: Handle) -> None:
        handle.execute()

    def _cancel(self, handle: Handle) -> CancelResponse:
        self.info("Received cancel request")
        return CancelResponse.ACCEPT

    def _is_over(self, handle: Handle) -> bool:
        """Whether execution of a goal must stop; if so, set the goal's state."""
        if handle.is_cancel_requested:
            handle.canceled()
            self.info("Goal canceled")
            return True
        return False

    async def _execute(self, handle: Handle) -> Any:
        self.info("Executing goal...")
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for number in range(1, handle.request.order):
            if self._is_over(handle):
                return Fibonacci.Result()
            feedback.sequence.append(feedback.sequence[number] + feedback.sequence[number - 1])
            self.info(f"Publishing feedback: {feedback.sequence}")
            handle.publish_feedback(feedback)
            await pause(self.node, 1.0)
        if not handle.is_active:
            self._is_over(handle)
            return Fibonacci.Result()
        handle.succeed()
        self.info(f"Returning result: {feedback.sequence}")
        return Fibonacci.Result(sequence=feedback.sequence)


class DeferringServer(PlainServer):
    """Starts a goal three seconds after it accepted it."""

    def _accepted(self, handle: Handle) -> None:
        self.info("Deferring execution...")

        def start() -> None:
            self.node.destroy_timer(timer)
            handle.execute()

        timer = self.node.create_timer(3.0, start)


class QueueingServer(PlainServer):
    """Works on one goal at a time, the others wait in a queue."""

    def __init__(self, node: Node) -> None:
        self._waiting: deque[Handle] = deque()
        self._current: Handle | None = None
        super().__init__(node)

    def _accepted(self, handle: Handle) -> None:
        if self._current is not None:
            self._waiting.append(handle)
            self.info("Goal put in the queue")
        else:
            self._current = handle
            handle.execute()

    async def _execute(self, handle: Handle) -> Any:
        try:
            return await super()._execute(handle)
        finally:
            self._current = self._waiting.popleft() if self._waiting else None
            if self._current is not None:
                self.info("Next goal pulled from the queue")
                self._current.execute()


class SingleGoalServer(PlainServer):
    """Works on the newest goal only."""

    def __init__(self, node: Node) -> None:
        self._current: Handle | None = None
        super().__init__(node)

    def _accepted(self, handle: Handle) -> None:
        if self._current is not None and self._current.is_active:
            self.info("Aborting previous goal")
            self._current.abort()
        self._current = handle
        handle.execute()

    def _is_over(self, handle: Handle) -> bool:
        if not handle.is_active:
            self.info("Goal aborted")
            return True
        return super()._is_over(handle)
