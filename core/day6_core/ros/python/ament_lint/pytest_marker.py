"""The pytest plugin that knows the marks of ROS's linters, which ament_lint, ament_copyright … each declare there."""

from __future__ import annotations

from typing import Any

_MARKS = (
    "linter: marks tests as linter checks",
    "copyright: marks tests checking for a copyright statement in non-empty source files",
    "flake8: marks tests checking for flake8 compliance",
    "mypy: marks tests checking for static types",
    "pep257: marks tests checking for PEP 257 compliance",
    "xmllint: marks tests checking XML files being well formed and valid",
)


def pytest_configure(config: Any) -> None:
    for mark in _MARKS:
        config.addinivalue_line("markers", mark)
