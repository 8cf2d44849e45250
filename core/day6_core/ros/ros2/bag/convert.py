"""`ros2 bag convert`."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.ros2.bag._options import console

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Given an input bag, write out a new bag with different settings"


def add_arguments(parser: ArgumentParser) -> None:
    inputs = parser.add_mutually_exclusive_group(required=True)
    inputs.add_argument(
        "-i",
        "--input",
        action="append",
        nargs="+",
        metavar=("uri", "storage_id"),
        help="URI (and optional storage ID) of an input bag. May be provided more than once",
    )
    inputs.add_argument(
        "--input-options",
        help='YAML file with options for input bags. Must have one top-level key "input_bags", which contains a sequence of '
        "StorageOptions objects.",
    )
    parser.add_argument(
        "-o",
        "--output-options",
        required=True,
        help='YAML file with options for output bags. Must have one top-level key "output_bags", which contains a sequence '
        "of StorageOptions/RecordOptions objects. See README.md for some examples.",
    )


async def main(session: Session, args: Namespace) -> None:
    from rosbag2_py._rewrite import input_options, rewrite
    from rosbag2_py._storage import StorageOptions

    inputs = []
    for bag in args.input or ():
        if len(bag) > 2:
            raise RuntimeError(f"--input expects 1 or 2 arguments, {len(bag)} provided")
        inputs.append(StorageOptions(bag[0], storage_id=bag[1] if len(bag) > 1 else ""))
    if args.input_options:
        inputs = input_options(os.path.join(session.cwd, args.input_options), session.cwd)
    log = console(session, *(each.uri for each in inputs))
    for each in inputs:
        each.uri = str(Path(session.cwd, each.uri))
    for _ in rewrite(inputs, os.path.join(session.cwd, args.output_options), session.cwd, log):
        await session.sleep(0)  # a large bag must not hold up other programs
