"""list_parameters: a node lists its own parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp._own_parameters import list_own

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await list_own(session, "list_parameters")
