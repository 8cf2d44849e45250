"""`ros2 security create_permission`."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from day6_core.ros.ros2.security._unavailable import add_root_argument, refuse

SUMMARY = "Create permission"


def add_arguments(parser: ArgumentParser) -> None:
    add_root_argument(parser)
    parser.add_argument("NAME", help="key name, aka ROS enclave name")
    parser.add_argument("POLICY_FILE_PATH", type=Path, help="path of the policy xml file")


main = refuse
