"""What the verbs of ros2bag share: profiles of QoS in YAML, values of options, lines of errors."""

from __future__ import annotations

import os
from argparse import ArgumentParser, ArgumentTypeError, HelpFormatter
from typing import Any

from rosbag2_py._options import duration_of as dict_to_duration
from rosbag2_py._options import qos_overrides as convert_yaml_to_qos_profile
from rosbag2_py._options import qos_profile_of as interpret_dict_as_qos_profile

from day6_core.ros.ros2.bag._options import add_storage
from day6_core.ros.ros2.bag._options import error as print_error
from day6_core.ros.ros2.bag._options import event_topics as convert_service_to_service_event_topic
from day6_core.ros.ros2.bag._options import not_negative_float as check_not_negative_float
from day6_core.ros.ros2.bag._options import not_negative_int as check_not_negative_int
from day6_core.ros.ros2.bag._options import positive_float as check_positive_float
from day6_core.ros.ros2.bag._options import warning as print_warn

__all__ = [
    "SplitLineFormatter",
    "add_standard_reader_args",
    "check_not_negative_float",
    "check_not_negative_int",
    "check_path_exists",
    "check_positive_float",
    "convert_service_to_service_event_topic",
    "convert_yaml_to_qos_profile",
    "create_bag_directory",
    "dict_to_duration",
    "interpret_dict_as_qos_profile",
    "print_error",
    "print_warn",
]


class SplitLineFormatter(HelpFormatter):
    """Help whose line breaks are those of its text."""

    def _split_lines(self, text: str, width: int) -> list[str]:
        return [line for part in text.splitlines() for line in HelpFormatter._split_lines(self, part, width)]


def create_bag_directory(uri: str) -> str | None:
    """Create a folder; return an error if that can't be."""
    try:
        os.makedirs(uri)
    except OSError:
        return print_error(f"Could not create bag folder '{uri}'.")
    return None


def check_path_exists(value: Any) -> str:
    """The argparse type of a bag's path."""
    if not os.path.exists(value):
        raise ArgumentTypeError(f"Bag path '{value}' does not exist!")
    return str(value)


def add_standard_reader_args(parser: ArgumentParser) -> None:
    """Add the bag to open and its storage."""
    parser.add_argument("bag_path", type=check_path_exists, help="Bag to open")
    add_storage(parser)
