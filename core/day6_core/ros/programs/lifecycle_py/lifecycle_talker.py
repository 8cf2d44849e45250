"""lifecycle_talker: a talker that others configure, activate, deactivate and shut down."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.demo_messages import String
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn

if TYPE_CHECKING:
    from day6_core.session.session import Session


class LifecycleTalker(LifecycleNode):
    """Like the C++ version in package lifecycle, but it counts from 0."""

    def __init__(self, name: str, **keywords: Any) -> None:
        self._count = 0
        self._chatter: Any = None
        self._clockwork: Any = None
        super().__init__(name, **keywords)

    def publish(self) -> None:
        message = String(data=f"Lifecycle HelloWorld #{self._count}")
        self._count += 1
        if self._chatter is None or not self._chatter.is_activated:
            self.get_logger().info("Lifecycle publisher is inactive. Messages are not published.")
        else:
            self.get_logger().info(f"Lifecycle publisher is active. Publishing: [{message.data}]")
        if self._chatter is not None:
            self._chatter.publish(message)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._chatter = self.create_lifecycle_publisher(String, "lifecycle_chatter", 10)
        self._clockwork = self.create_timer(1.0, self.publish)
        return self._log_call("on_configure")

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._log_call("on_activate")
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._log_call("on_deactivate")
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._release()
        return self._log_call("on_cleanup")

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._release()
        return self._log_call("on_shutdown")

    def _log_call(self, name: str) -> TransitionCallbackReturn:
        self.get_logger().info(f"{name}() is called.")
        return TransitionCallbackReturn.SUCCESS

    def _release(self) -> None:
        if self._clockwork is not None:
            self.destroy_timer(self._clockwork)
        if self._chatter is not None:
            self.destroy_lifecycle_publisher(self._chatter)
        self._clockwork = self._chatter = None


async def main(session: Session) -> int:
    node = LifecycleTalker("lc_talker", context=session.context)
    session.defer(node.destroy_node)
    return await spin(session, node)
