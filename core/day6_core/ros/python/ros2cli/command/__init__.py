"""What a command's extension is derived from."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.made_modules import install
from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, instantiate_extensions, satisfies_version

install()


class CommandExtension:
    """A command of `ros2`. A subclass has `main`, and `add_arguments` if it takes any."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")

    def add_arguments(self, parser: ArgumentParser, cli_name: str, *, argv: list[str] | None = None) -> None:
        """Add the command's arguments."""

    def main(self, *, parser: ArgumentParser, args: Namespace) -> Any:
        """Run the command."""
        raise NotImplementedError


def get_command_extensions(group_name: str, *, exclude_names: Any = None) -> dict[str, Any]:
    """Return the extensions of a group that installed packages bring, by name."""
    return instantiate_extensions(group_name, exclude_names=exclude_names)


def add_subparsers(
    parser: ArgumentParser,
    cli_name: str,
    dest: str,
    command_extensions: dict[str, Any],
    hide_extensions: Any = None,
    required: bool = True,
) -> Any:
    """Add a sub-parser for each extension; the chosen one becomes `dest` of the parsed arguments."""
    choices = parser.add_subparsers(
        title="Commands", metavar=f"Call `{cli_name} <command> -h` for more detailed usage.", required=required
    )
    choices.dest = f" {dest.lstrip('_')}"
    for name, extension in sorted(command_extensions.items()):
        text = (extension.__doc__ or "").strip().partition("\n")[0].rstrip(".")
        chosen = choices.add_parser(name, description=text)
        chosen.set_defaults(**{dest: extension})
        if hasattr(extension, "add_arguments"):
            extension.add_arguments(chosen, f"{cli_name} {name}")
    return choices


def add_subparsers_on_demand(
    parser: ArgumentParser,
    cli_name: str,
    dest: str,
    group_name: str,
    hide_extensions: Any = None,
    required: bool = True,
    argv: list[str] | None = None,
) -> Any:
    """Add a sub-parser for each extension of a group."""
    return add_subparsers(parser, cli_name, dest, get_command_extensions(group_name), hide_extensions, required)
