"""A path that `/` extends."""

from __future__ import annotations

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.path_join_substitution import PathJoinSubstitution


class PathSubstitution(PathJoinSubstitution):
    """`PathSubstitution(FindPackageShare('demo')) / 'launch' / 'demo.launch.py'`."""

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__([path])
