"""Imports extension modules by name."""

from __future__ import annotations

import importlib
from types import ModuleType


def import_c_library(name: str, package: str | None = None) -> ModuleType:
    """Import an extension module, `name` relative to `package`. Raises ImportError with its name."""
    try:
        return importlib.import_module(name, package=package)
    except ImportError as error:
        if error.path is None:
            error.path = name
        error.msg = f"{error}\nThe C extension '{error.path}' failed to be imported while being present on the system."
        raise
