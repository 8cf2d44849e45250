"""The prefixes of installed packages: those in AMENT_PREFIX_PATH, then that of day6-tui's packages."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from ament_index_python.constants import AMENT_PREFIX_PATH_ENV_VAR

BUILT_IN_PREFIX = str(Path(__file__).resolve().parents[2])
"""The prefix of our own packages: `share/<package>/package.xml` below it."""


def get_search_paths(environment: Mapping[str, str] | None = None) -> list[str]:
    """Return the prefixes in search order. `environment` replaces `os.environ`."""
    given = (os.environ if environment is None else environment).get(AMENT_PREFIX_PATH_ENV_VAR, "")
    paths = [path for path in given.split(os.pathsep) if path and os.path.isdir(path)]
    return [*(path for path in paths if path != BUILT_IN_PREFIX), BUILT_IN_PREFIX]
