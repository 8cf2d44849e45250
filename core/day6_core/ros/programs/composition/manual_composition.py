"""manual_composition: four nodes made one after the other in one program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.composition._together import run_together

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await run_together(session)
