"""lifecycle_talker: a talker that others configure, activate, deactivate and shut down."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.rclcpp.lifecycle import CppLifecycleNode
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUCCESS = TransitionCallbackReturn.SUCCESS


class LifecycleTalker(CppLifecycleNode):
    """Publishes on `lifecycle_chatter` once a second once configured; messages are sent only while it is active."""

    def __init__(self, name: str, **keywords: Any) -> None:
        self._count = 0
        self._chatter: Any = None
        self._clockwork: Any = None
        super().__init__(name, **keywords)

    def publish(self) -> None:
        self._count += 1
        message = String(data=f"Lifecycle HelloWorld #{self._count}")
        if self._chatter.is_activated:
            self.get_logger().info(f"Lifecycle publisher is active. Publishing: [{message.data}]")
        else:
            self.get_logger().info("Lifecycle publisher is currently inactive. Messages are not published.")
        self._chatter.publish(message)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._chatter = self.create_lifecycle_publisher(String, "lifecycle_chatter", 10)
        self._clockwork = self.create_timer(1.0, self.publish)
        self.get_logger().info("on_configure() is called.")
        return SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        # The original also sleeps two seconds here, as if there were much to do; that would hold up all other nodes.
        outcome = super().on_activate(state)
        self.get_logger().info("on_activate() is called.")
        return outcome

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        outcome = super().on_deactivate(state)
        self.get_logger().info("on_deactivate() is called.")
        return outcome

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._release()
        self.get_logger().info("on cleanup is called.")
        return SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._release()
        self.get_logger().info(f"on shutdown is called from state {state.label}.")
        return SUCCESS

    def _release(self) -> None:
        if self._clockwork is not None:
            self.destroy_timer(self._clockwork)
        if self._chatter is not None:
            self.destroy_lifecycle_publisher(self._chatter)
        self._clockwork = self._chatter = None


async def main(session: Session) -> int:
    node: Any = create_node(session, "lc_talker", LifecycleTalker)
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    node.warn_unless_finalized(session)
    return 0
