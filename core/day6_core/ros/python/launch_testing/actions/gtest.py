"""Runs a C++ test."""

from __future__ import annotations

from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType

from launch_testing.actions.test import Test


class GTest(Test):
    """Runs the executable at `path`; the rest is as in `Test` and `launch.actions.ExecuteProcess`."""

    def __init__(self, *, path: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(cmd=[path], **kwargs)
        self.__path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        return self.__path
