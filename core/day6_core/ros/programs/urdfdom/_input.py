"""The first step of both tools: read the description and print the parser's messages."""

from __future__ import annotations

from day6_core.language import language_of
from day6_core.ros.robot_check import check_robot
from day6_core.session.session import Session
from day6_urdf import Robot
from day6_urdf.advice import advice_of
from day6_urdf.check import MAX_BYTES, read_description, too_large
from day6_urdf.explain import hint_of, hints_wanted

FAILED = 255
"""exit(-1)"""

NO_HINT = "--no-hint"
"""Our own option: the real tools take a file name and nothing else."""


def take_hint_option(session: Session) -> bool:
    """Take `--no-hint` off the command line; True if a hint is wanted."""
    wanted = hints_wanted(session.env)
    if NO_HINT in session.argv[1:]:
        session.argv.remove(NO_HINT)
        return False
    return wanted


async def read_robot(session: Session, path: str, hints: bool) -> Robot | None:
    """Parse a file (`-`: standard input) and write the parser's messages to stderr; None if it is refused.

    With `hints`, a line says where in the description the first mistake is and what it means, also a mistake that the
    parser does not mind.
    """
    text, size = await session.stdin.read_all() if path == "-" else "", 0
    if path != "-":
        try:
            text, size = read_description(session.cwd / path)
        except OSError:
            text = ""  # as the real ones: a file that is not there is an empty description
    report = too_large(size) if size > MAX_BYTES else check_robot(text)
    session.stderr.write(report.text)
    if report.robot is None:
        session.print_error("ERROR: Model Parsing the xml failed")
    language = language_of(session.env)
    hint = hint_of(report, text, language) if hints else None
    if hints and hint is None and report.robot is not None:
        hint = advice_of(report.robot, text, language)
    if hint is not None:
        session.print_error(hint.sentence(path if path != "-" else "stdin", language))
    return report.robot
