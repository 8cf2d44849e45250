"""set_and_get_parameters: a node sets and gets its own parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp._own_parameters import set_and_get_own

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await set_and_get_own(session, "set_and_get_parameters")
