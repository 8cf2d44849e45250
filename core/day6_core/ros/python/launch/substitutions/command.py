"""The output of a command."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch._programs import run_captured
from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("command")
class Command(Substitution):
    """The standard output of a command; `on_stderr`, for output to stderr: 'fail', 'ignore', 'warn', 'capture'."""

    def __init__(self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = "fail") -> None:
        super().__init__()
        self.__command = normalize_to_list_of_substitutions(command)
        self.__on_stderr = normalize_to_list_of_substitutions(on_stderr)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if not 1 <= len(data) <= 2:
            raise ValueError("command substitution expects 1 or 2 arguments")
        return cls, dict(zip(("command", "on_stderr"), data, strict=False))

    @property
    def command(self) -> list[Substitution]:
        return self.__command

    @property
    def on_stderr(self) -> list[Substitution]:
        return self.__on_stderr

    def describe(self) -> str:
        return f"Command({' + '.join(each.describe() for each in self.command)})"

    def perform(self, context: LaunchContext) -> str:
        line = perform_substitutions(context, self.command)
        on_stderr = perform_substitutions(context, self.on_stderr)
        if on_stderr not in ("fail", "ignore", "warn", "capture"):
            raise SubstitutionFailure("expected 'on_stderr' to be one of: 'fail', 'ignore', 'warn' or 'capture'")
        words = shlex.split(line, posix=os.name != "nt")
        try:
            result = run_captured(words, subprocess.STDOUT if on_stderr == "capture" else subprocess.PIPE)
        except FileNotFoundError as error:
            raise SubstitutionFailure(f"file not found: {error}") from error
        if result.returncode != 0:
            problem = f"executed command failed. Command: {line}"
            if result.stderr:
                problem += f"\nCaptured stderr output: {result.stderr}"
            raise SubstitutionFailure(problem)
        if result.stderr:
            problem = (
                f"executed command showed stderr output. Command: {line}\nCaptured stderr output:\n{result.stderr}"
            )
            if on_stderr == "fail":
                raise SubstitutionFailure(problem)
            if on_stderr == "warn":
                launch.logging.get_logger().warning(problem)
        return result.stdout
