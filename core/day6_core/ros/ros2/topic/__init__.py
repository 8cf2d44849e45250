"""`ros2 topic …`.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.cli.options import add_hidden_option

SUMMARY = "Various topic related sub-commands"


def add_arguments(parser: ArgumentParser) -> None:
    add_hidden_option(parser, "topics")
