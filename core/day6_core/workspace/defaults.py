"""Default values of colcon's options from files (colcon-defaults): `~/.colcon/defaults.yaml` and the workspace's own."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from day6_core.workspace.option import Option
from day6_core.workspace.options import options_of

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


def colcon_home(environment: Mapping[str, str]) -> Path:
    """Return the folder of colcon's settings."""
    home = environment.get("COLCON_HOME") or os.path.join(environment.get("HOME", "~"), ".colcon")
    return Path(os.path.expanduser(home))


def content_of(path: Path, warn: Callable[[str], None]) -> dict[str, Any]:
    """Return what a YAML file contains, nothing where there is none; `warn` is told of one that is no such file."""
    try:
        if not path.is_file():
            return {}
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        warn(f"Skipping metadata file '{path}' since it failed to parse: {error}")
        return {}
    import yaml  # for the few who have such a file

    try:
        content = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        warn(f"Skipping metadata file '{path}' since it failed to parse: {error}")
        return {}
    if content is None or isinstance(content, dict):
        return content or {}
    warn(f"Skipping metadata file '{path}' since it doesn't contain a dict")
    return {}


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
