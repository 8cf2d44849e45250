"""matched_event_detect: a node hears when others subscribe to its topic, or publish what it subscribes to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_py.matched_event_detect import detect

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await detect(session, "matched_event_detect_node", ".")
