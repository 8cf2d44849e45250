"""Where packages are installed: the prefixes of AMENT_PREFIX_PATH, then the packages that came with day6-tui."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from ament_index_python.constants import AMENT_PREFIX_PATH_ENV_VAR

BUILT_IN_PREFIX = str(Path(__file__).resolve().parents[2])
"""The prefix of our own packages: `share/<package>/package.xml` below it."""


def get_search_paths(environment: Mapping[str, str] | None = None) -> list[str]:
    """Return the prefixes, first found first; `environment` stands for `os.environ` where a program has its own."""
    given = (os.environ if environment is None else environment).get(AMENT_PREFIX_PATH_ENV_VAR, "")
    paths = [path for path in given.split(os.pathsep) if path and os.path.isdir(path)]
    return [*(path for path in paths if path != BUILT_IN_PREFIX), BUILT_IN_PREFIX]
