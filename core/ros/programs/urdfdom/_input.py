"""What both tools do first: read the description and say what the parser says."""

from __future__ import annotations

from day6_tui.core.session.session import Session
from day6_tui.urdf import Robot, check_file, check_text

FAILED = 255
"""exit(-1)"""


async def read_robot(session: Session, path: str) -> Robot | None:
    """Parse a file (`-`: standard input) and write the parser's messages to stderr; None if it is refused."""
    report = check_text(await session.stdin.read_all()) if path == "-" else check_file(session.cwd / path)
    session.stderr.write(report.text)
    if report.robot is None:
        session.print_error("ERROR: Model Parsing the xml failed")
    return report.robot
