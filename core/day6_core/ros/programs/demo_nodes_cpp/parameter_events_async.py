"""parameter_events_async: a node receives the events of its own parameters; ends soon after the last change."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp._own_events import hear_all

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await hear_all(session, "parameter_events")
