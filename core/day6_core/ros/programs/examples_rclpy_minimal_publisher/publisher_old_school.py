"""publisher_old_school: Hello World twice a second, in the original written with a loop that sleeps."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_publisher._publish import publish

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await publish(session, at_once=True)
