"""What a verb's extension is derived from."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.made_modules import install
from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, instantiate_extensions, satisfies_version

install()


class VerbExtension:
    """A verb of a command. A subclass has `main`, and `add_arguments` if it takes any."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")

    def add_arguments(self, parser: ArgumentParser, cli_name: str) -> None:
        """Add the verb's arguments."""

    def main(self, *, args: Namespace) -> Any:
        """Run the verb: None, a status, or the text of an error."""
        raise NotImplementedError


def get_verb_extensions(name: str) -> dict[str, Any]:
    """Return the verbs that installed packages bring for a command's group, by name."""
    return instantiate_extensions(name)
