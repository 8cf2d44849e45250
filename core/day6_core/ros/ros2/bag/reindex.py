"""`ros2 bag reindex`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.ros2.bag._options import add_bag_path, console, error

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Reconstruct metadata file for a bag"


def add_arguments(parser: ArgumentParser) -> None:
    add_bag_path(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rosbag2_py._reindexer import Reindexer
    from rosbag2_py._storage import StorageOptions

    path = Path(session.cwd, args.bag_path)
    if not path.is_dir():
        return error("Must specify a bag directory")
    Reindexer(console(session, args.bag_path)).reindex(StorageOptions(str(path), storage_id=args.storage))
    return None
