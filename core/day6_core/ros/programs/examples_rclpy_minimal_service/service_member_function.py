"""service_member_function: adds two numbers, in the original written with a class that is a node."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_service.service import serve_sums

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await serve_sums(session, "minimal_service")
