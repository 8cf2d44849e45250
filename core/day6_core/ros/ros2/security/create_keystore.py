"""`ros2 security create_keystore`."""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.security._unavailable import add_root_argument, refuse

SUMMARY = "Create keystore"


def add_arguments(parser: ArgumentParser) -> None:
    add_root_argument(parser)


main = refuse
