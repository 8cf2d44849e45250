"""The refusal of every verb, and the argument that several of them share."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session


def add_root_argument(parser: ArgumentParser) -> None:
    """Add ROOT, the path of the keystore."""
    parser.add_argument("ROOT", type=Path, help="root path of keystore")


async def refuse(session: Session, args: Namespace) -> str:
    """Return why the verb can't do anything; the exit status is 1."""
    return (
        f"{' '.join(session.argv[:3])}: there is no security in day6-tui: its programs communicate within this machine, "
        "without DDS and without keys.\nIn a real ROS 2 this command belongs to the package sros2, "
        "and ROS_SECURITY_ENABLE=true switches it on."
    )
