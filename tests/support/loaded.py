"""Scripts of the repository as modules: those of .ci are on no path, and most have no suffix."""

from __future__ import annotations

import importlib.util
from importlib.machinery import SourceFileLoader
from types import ModuleType

from tests.support.source_files import ROOT


def loaded(script: str) -> ModuleType:
    """Return a script, named as from the repository on, as a module."""
    path = ROOT / script
    spec = importlib.util.spec_from_file_location(path.stem, path, loader=SourceFileLoader(path.stem, str(path)))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
