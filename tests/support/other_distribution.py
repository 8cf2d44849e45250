"""Making this process one of another distribution for a test."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from day6_core.interfaces import registry, type_hash
from day6_core.ros import distribution


@pytest.fixture
def in_distribution(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Return what makes this process one of a distribution until the test ends.

    A process has one distribution and keeps each class of an interface that it has made. The classes are made first,
    so that no test of this process, which may come in any order, meets one of the other distribution.
    """
    for package in registry.packages():
        for name in registry.interface_names(package):
            type_hash(registry.find_class(f"{package}/{name}"))

    def enter(name: str) -> None:
        monkeypatch.setattr(distribution, "_current", name)

    return enter
