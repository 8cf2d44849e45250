"""parameter_events: a node receives the events of its own parameters; ends after ten events."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp._own_events import hear_ten

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await hear_ten(session, "parameter_events")
