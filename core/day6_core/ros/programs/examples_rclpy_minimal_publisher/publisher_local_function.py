"""publisher_local_function: Hello World twice a second, in the original written with a function inside of main."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_publisher._publish import publish

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await publish(session, at_once=False)
