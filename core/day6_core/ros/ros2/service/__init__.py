"""`ros2 service …`.

Each public module is a verb, imported by the command tree only (see `ros2`).
"""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.cli.options import add_hidden_option

SUMMARY = "Various service related sub-commands"


def add_arguments(parser: ArgumentParser) -> None:
    add_hidden_option(parser, "services")
