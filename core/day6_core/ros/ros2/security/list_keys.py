"""`ros2 security list_keys`."""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.security._unavailable import add_root_argument, refuse

SUMMARY = "DEPRECATED: List enclaves in keystore. Use list_enclaves instead"


def add_arguments(parser: ArgumentParser) -> None:
    add_root_argument(parser)


main = refuse
