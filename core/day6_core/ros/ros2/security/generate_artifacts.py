"""`ros2 security generate_artifacts`."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from day6_core.ros.ros2.security._unavailable import refuse

SUMMARY = "Generate keys and permission files from a list of identities and policy files"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("-k", "--keystore-root-path", type=Path, help="root path of keystore")
    parser.add_argument(
        "-e", "--enclaves", nargs="*", default=[], help="list of identities, aka ROS security enclave names"
    )
    parser.add_argument("-p", "--policy-files", nargs="*", type=Path, default=[], help="list of policy xml file paths")


main = refuse
