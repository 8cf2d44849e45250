"""`ros2 security generate_policy`."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from day6_core.ros.ros2.cli.options import add_strategy_options
from day6_core.ros.ros2.security._unavailable import refuse

SUMMARY = "Generate XML policy file from ROS graph data"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("POLICY_FILE_PATH", type=Path, help="path of the policy xml file")
    add_strategy_options(parser)


main = refuse
