"""Descriptions of parameters: typed values, single parameters, files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from launch.frontend.parse_substitution import parse_substitution
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class ParameterValue:
    """A value with a type (`int`, `List[float]` …; None: as YAML reads the text)."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        self.__value = normalize_typed_substitution(value, value_type)
        self.__value_type = value_type
        self.__evaluated: Any = None

    @property
    def value(self) -> Any:
        return self.__value if self.__evaluated is None else self.__evaluated

    @property
    def value_type(self) -> Any:
        return self.__value_type

    def __str__(self) -> str:
        return f"launch_ros.description.ParameterValue(value={self.value}, value_type={self.value_type})"

    def evaluate(self, context: LaunchContext) -> Any:
        """Return the value. Raises TypeError or ValueError if it has another type."""
        self.__evaluated = perform_typed_substitution(context, self.value, self.value_type)
        return self.__evaluated


class Parameter:
    """A name with a value."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, *, value_type: Any = None) -> None:
        ensure_argument_type(name, SomeSubstitutionsType_types_tuple, "name")
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = ParameterValue(value, value_type=value_type)
        self.__evaluated: tuple[str, Any] | None = None

    @property
    def name(self) -> list[Substitution] | str:
        return self.__name if self.__evaluated is None else self.__evaluated[0]

    @property
    def value(self) -> Any:
        return self.__value.value

    @property
    def value_type(self) -> Any:
        return self.__value.value_type

    def __str__(self) -> str:
        return f"launch_ros.description.Parameter(name={self.name}, value={self.value}, value_type={self.value_type})"

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        """Return name and value."""
        if self.__evaluated is None:
            self.__evaluated = perform_substitutions(context, self.__name), self.__value.evaluate(context)
        return self.__evaluated


class ParameterFile:
    """A file of parameters; with `allow_substs` it may contain `$(…)`, and the node gets a copy with their values."""

    def __init__(
        self,
        param_file: str | bytes | os.PathLike[str] | SomeSubstitutionsType,
        *,
        allow_substs: bool | SomeSubstitutionsType = False,
    ) -> None:
        types = (*SomeSubstitutionsType_types_tuple, os.PathLike, bytes)
        ensure_argument_type(param_file, types, "param_file", "ParameterFile()")
        is_path = isinstance(param_file, (bytes, os.PathLike))
        self.__param_file: Any = param_file if is_path else normalize_to_list_of_substitutions(param_file)  # type: ignore[arg-type]
        self.__allow_substs = normalize_typed_substitution(allow_substs, bool)
        self.__evaluated: Path | None = None
        self.__is_copy = False
        self._given = ""
        """The path of the file itself, once it is known; `param_file` may be a copy with its substitutions performed."""

    @property
    def param_file(self) -> Any:
        return self.__param_file if self.__evaluated is None else self.__evaluated

    @property
    def allow_substs(self) -> Any:
        return self.__allow_substs

    def __str__(self) -> str:
        return f"launch_ros.description.ParameterFile(param_file={self.param_file}, allow_substs={self.allow_substs})"

    def evaluate(self, context: LaunchContext) -> Path:
        """Return the path. With substitutions it raises OSError, or SubstitutionFailure for an invalid file."""
        if self.__evaluated is None:
            file = self.__param_file
            if isinstance(file, list):
                file = perform_substitutions(context, file)
            path = Path(os.fsdecode(file))
            self._given = str(path)
            if perform_typed_substitution(context, self.__allow_substs, bool):
                path = _substituted(context, path)
                self.__is_copy = True
            self.__evaluated = path
        return self.__evaluated

    def cleanup(self) -> None:
        """Remove the copy."""
        if self.__is_copy and self.__evaluated is not None:
            self.__evaluated.unlink(missing_ok=True)
            self.__evaluated = None
            self.__is_copy = False

    def __del__(self) -> None:
        if getattr(self, "_ParameterFile__is_copy", False):
            self.cleanup()


def _substituted(context: LaunchContext, path: Path) -> Path:
    import tempfile

    import yaml

    text = perform_substitutions(context, parse_substitution(path.read_text(encoding="utf-8")))
    try:
        yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise SubstitutionFailure("The substituted parameter file is not a valid yaml file") from error
    with tempfile.NamedTemporaryFile("w", prefix="launch_params_", delete=False, encoding="utf-8") as copy:
        copy.write(text)
    return Path(copy.name)
