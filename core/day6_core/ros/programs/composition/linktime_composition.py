"""linktime_composition: four nodes of libraries that the linker bound (in C++; here the same nodes)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.composition._together import run_together

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await run_together(session)
