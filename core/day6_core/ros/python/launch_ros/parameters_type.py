"""The types of arguments that take a node's parameters."""

from __future__ import annotations

from typing import Any

SomeParameters = Any
"""A list of files (paths, `ParameterFile`), dicts and `Parameter`s."""

SomeParametersDict = Any
Parameters = Any
ParametersDict = Any
ParameterName = Any
ParameterValue = Any
SomeParameterName = Any
SomeParameterValue = Any
EvaluatedParameters = Any
EvaluatedParameterValue = Any
