"""add_two_ints_server: adds the two numbers of each request."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_service.service import serve_sums

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await serve_sums(session, "add_two_ints_server")
