"""add_two_ints_client_async: requests the sum of 2 and 3 once; in C++ with a callback, which is invisible from outside."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp._sum import ask

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await ask(session)
