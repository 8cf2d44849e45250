"""Launch tests as plain pytest tests: a fixture returns what is launched, `@pytest.mark.launch(fixture=…)` tests it.

Every pytest that has day6-tui's packages on its path loads the plugin, so what needs launch is imported when it is asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch_pytest import actions, tools
    from launch_pytest._fixtures import fixture

__all__ = ["actions", "fixture", "tools"]


def __getattr__(name: str) -> Any:
    if name == "fixture":
        return import_module("launch_pytest._fixtures").fixture
    if name in __all__:
        return import_module(f"launch_pytest.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
