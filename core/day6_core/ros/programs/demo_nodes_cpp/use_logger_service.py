"""use_logger_service: one node sets the logger level of another one by its services, and shows what is logged then."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_py.use_logger_service import change_levels

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await change_levels(session, 0.2)
