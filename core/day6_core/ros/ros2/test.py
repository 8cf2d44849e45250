"""`ros2 test`: runs a launch test, in a domain that no other one uses at the same time."""

from __future__ import annotations

import random
import socket
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Run a ROS2 launch test"
_DOMAINS = range(1, 101)
_FIRST_PORT = 22119
"""The test that runs in a domain holds this port of the machine itself, plus the domain's number."""


def add_arguments(parser: ArgumentParser) -> None:
    from launch_testing.launch_test import add_arguments as add_those_of_launch_test

    add_those_of_launch_test(parser)
    parser.add_argument(
        "--disable-isolation",
        action="store_true",
        default=False,
        help="Disable automatic ROS_DOMAIN_ID isolation. A ROS_DOMAIN_ID that is set is respected; otherwise one is picked "
        "that no other ros2 test uses, unless isolation is disabled.",
    )


async def main(session: Session, args: Namespace) -> int:
    from day6_core.ros.environment import as_program

    if not (session.cwd / args.launch_test_file).is_file():
        args.help_of.error(f"Test file '{args.launch_test_file}' does not exist")
    if "ROS_DOMAIN_ID" not in session.env and not args.disable_isolation:
        session.env = {**session.env, "ROS_DOMAIN_ID": str(_free_domain(session))}
        session.print(f"Running with ROS_DOMAIN_ID {session.env['ROS_DOMAIN_ID']}")
    session.env = as_program(session.env)
    domain = session.env.get("ROS_DOMAIN_ID")
    session.print("No ROS_DOMAIN_ID" if domain is None else f"ROS_DOMAIN_ID {domain}")
    words = session.argv[session.argv.index("test") + 1 :]
    own = [word for word in words if word != "--disable-isolation"]
    return await session.run_python(["-m", "launch_testing.launch_test", *own])


def _free_domain(session: Session) -> int:
    """Return a domain that no other test of this machine has; it is held until the command ends."""
    for domain in random.sample(_DOMAINS, len(_DOMAINS)):
        held = socket.socket()
        try:
            held.bind(("127.0.0.1", _FIRST_PORT + domain))
        except OSError:
            held.close()
            continue
        session.defer(held.close)
        return domain
    raise RuntimeError("Failed to get a unique domain ID")
