"""A command line with its working directory and environment."""

from __future__ import annotations

import itertools
import os
import shlex
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.launch_configuration import LaunchConfiguration
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.action import Action
    from launch.launch_context import LaunchContext

_counter = itertools.count(1)
_Pairs = list[tuple[list[Substitution], list[Substitution]]]


class Executable:
    """An executable with its arguments. `final_…` are set once `prepare` has performed the substitutions.

    - `prefix`: words to put before the command, by default the launch configuration 'launch-prefix' (for the executables that
      match 'launch-prefix-filter').
        - `name`: shown before its output, with a running number; by default the file's name.
    - `env` replaces the environment of the launch, `additional_env` adds to it.
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        additional_env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ) -> None:
        self.__cmd = [normalize_to_list_of_substitutions(part) for part in [*cmd, *(arguments or ())]]
        self.__prefix_given = prefix is not None
        self.__prefix = normalize_to_list_of_substitutions(
            LaunchConfiguration("launch-prefix", default="") if prefix is None else prefix
        )
        self.__name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__cwd = None if cwd is None else normalize_to_list_of_substitutions(cwd)
        self.__env = _pairs(env)
        self.__additional_env = _pairs(additional_env)
        self.__arguments = arguments
        self.__final_cmd: list[str] | None = None
        self.__final_cwd: str | None = None
        self.__final_env: dict[str, str] | None = None
        self.__final_name: str | None = None

    @property
    def name(self) -> list[Substitution] | None:
        return self.__name

    @property
    def prefix(self) -> list[Substitution]:
        return self.__prefix

    @property
    def cmd(self) -> list[list[Substitution]]:
        return self.__cmd

    @property
    def cwd(self) -> list[Substitution] | None:
        return self.__cwd

    @property
    def env(self) -> _Pairs | None:
        return self.__env

    @property
    def additional_env(self) -> _Pairs | None:
        return self.__additional_env

    @property
    def arguments(self) -> Iterable[SomeSubstitutionsType] | None:
        return self.__arguments

    @property
    def final_name(self) -> str | None:
        return self.__final_name

    @property
    def final_cmd(self) -> list[str] | None:
        return self.__final_cmd

    @property
    def final_cwd(self) -> str | None:
        return self.__final_cwd

    @property
    def final_env(self) -> dict[str, str] | None:
        return self.__final_env

    def prepare(self, context: LaunchContext, action: Action) -> None:
        """Perform the substitutions and number the process."""
        cmd = [perform_substitutions(context, part) for part in self.__cmd]
        if self.__wants_prefix(context, cmd[0]):
            cmd = shlex.split(perform_substitutions(context, self.__prefix)) + cmd
        name = os.path.basename(cmd[0]) if self.__name is None else perform_substitutions(context, self.__name)
        env = dict(context.environment) if self.__env is None else _performed(context, self.__env)
        env.update(_performed(context, self.__additional_env or []))
        self.__final_cmd = cmd
        self.__final_name = f"{name}-{next(_counter)}"
        self.__final_cwd = None if self.__cwd is None else perform_substitutions(context, self.__cwd)
        self.__final_env = env

    def __wants_prefix(self, context: LaunchContext, executable: str) -> bool:
        if self.__prefix_given:
            return True
        pattern = LaunchConfiguration("launch-prefix-filter", default="").perform(context)
        from day6_core.user_pattern import user_pattern

        return user_pattern(pattern).match(os.path.basename(executable)) is not None


def _pairs(mapping: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None) -> _Pairs | None:
    if mapping is None:
        return None
    return [
        (normalize_to_list_of_substitutions(key), normalize_to_list_of_substitutions(value))
        for key, value in mapping.items()
    ]


def _performed(context: LaunchContext, pairs: _Pairs) -> dict[str, str]:
    return {perform_substitutions(context, key): perform_substitutions(context, value) for key, value in pairs}
