"""A unique name."""

from __future__ import annotations

import os
import random
import re
import socket
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("anon")
class AnonName(Substitution):
    """`name` with host, process number and a random number; always the same one for the same name."""

    def __init__(self, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if len(data) != 1:
            raise TypeError("anon substitution expects 1 argument")
        return cls, {"name": data[0]}

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def describe(self) -> str:
        return f"AnonName({' + '.join(each.describe() for each in self.name)})"

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.name)
        unique = context.launch_configurations.setdefault(f"anon{name}", self.compute_name(name))
        return str(unique)

    def compute_name(self, id_value: str) -> str:
        """Return a new unique name."""
        number = random.randint(0, sys.maxsize)
        return re.sub(r"[.\-:]", "_", f"{id_value}_{socket.gethostname()}_{os.getpid()}_{number}")
