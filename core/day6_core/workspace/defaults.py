"""Default values of colcon's options from files (colcon-defaults): `~/.colcon/defaults.yaml` and the workspace's own."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from day6_core.workspace.option import Option
from day6_core.workspace.options import options_of
from day6_core.workspace.yaml_files import colcon_home, content_of

_LOGGER = "colcon.colcon_defaults.argument_parser.defaults"
_WORKSPACE_FILE = "colcon_defaults.yaml"


def default_values(
    verb: str, cwd: Path, environment: Mapping[str, str], write: Callable[[str], object]
) -> dict[str, Any]:
    """Return the default values of a verb's options, by their attribute in the namespace; `write` gets lines of colcon's log."""

    def warn(text: str) -> None:
        write(f"WARNING:{_LOGGER}:{text}\n")  # without the time: it's before colcon's log begins

    path = environment.get("COLCON_DEFAULTS_FILE") or str(colcon_home(environment) / "defaults.yaml")
    values: dict[str, Any] = {}
    for file in (Path(os.path.expanduser(path)), cwd / _WORKSPACE_FILE):
        section = content_of(file, warn).get(verb) or {}
        if isinstance(section, dict):
            values |= section
        else:
            warn(f"Configuration option '{verb}' should be a dictionary")
    known = {option.name.lstrip("-"): option for option in options_of(verb)}
    found = {}
    for key, value in values.items():
        if key in known:
            if wanted := _not_fitting(known[key], value):
                warn(f"Default value '{key}' for parser '{verb}' should be {wanted}, not: {value}")
            else:
                found[known[key].destination] = value
    if unknown := ", ".join(sorted(values.keys() - known.keys())):
        warn(f"Skipping unknown keys from '{path}' for '{verb}': {unknown}")
    return found


def _not_fitting(option: Option, value: Any) -> str:
    """Return what the value of an option has to be, '' if it is that."""
    if option.keywords.get("nargs") in ("*", "+"):
        if not isinstance(value, list):
            return "a list"
        return "" if all(isinstance(each, str) for each in value) else "a list of strings"
    if option.keywords.get("action") == "store_true":
        return "" if isinstance(value, bool) else "a boolean"
    if option.keywords.get("type") not in (None, str.lstrip):
        return "" if isinstance(value, int) else "an integer"
    return "" if isinstance(value, str) else "a string"
