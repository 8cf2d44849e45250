"""Prints the arguments of a launch."""

from __future__ import annotations

from launch import LaunchDescription


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments that a launch description takes, as `ros2 launch --show-args` does."""
    print("Arguments (pass arguments as '<name>:=<value>'):")
    arguments = launch_description.get_launch_arguments()
    for argument in arguments:
        asterisk = "*" if argument._conditionally_included else ""
        print(f"\n    '{argument.name}':{asterisk}\n        {argument.description}")
        if argument.default_value is not None:
            print(f"        (default: {' + '.join(each.describe() for each in argument.default_value)})")
    if not arguments:
        print("\n  No arguments.")
    elif any(argument._conditionally_included for argument in arguments):
        print("\n* argument(s) which are only used if specific conditions occur")
