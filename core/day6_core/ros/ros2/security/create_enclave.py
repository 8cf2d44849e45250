"""`ros2 security create_enclave`."""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.security._unavailable import add_root_argument, refuse

SUMMARY = "Create enclave"


def add_arguments(parser: ArgumentParser) -> None:
    add_root_argument(parser)
    parser.add_argument("NAME", help="enclave name")


main = refuse
