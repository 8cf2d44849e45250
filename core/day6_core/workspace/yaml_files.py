"""The files in which colcon keeps settings, and YAML that may be anything."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from day6_core.reason import reason


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
        warn(f"Skipping metadata file '{path}' since it failed to parse: {reason(error)}")
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
