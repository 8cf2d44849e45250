"""The paths of a package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class FindPackage(Substitution):
    """Base of these substitutions: the result of `find(package_name)`."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__package = normalize_to_list_of_substitutions(package)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if len(data) != 1:
            raise AttributeError("find package substitutions expect 1 argument")
        return cls, {"package": data[0]}

    @property
    def package(self) -> list[Substitution]:
        return self.__package

    def find(self, package_name: str) -> str:
        """Return the path for a package. This one raises NotImplementedError."""
        raise NotImplementedError(f"{type(self).__name__} has no find()")

    def describe(self) -> str:
        return f"{type(self).__name__}(pkg={' + '.join(each.describe() for each in self.package)})"

    def perform(self, context: LaunchContext) -> str:
        return self.find(perform_substitutions(context, self.package))


@expose_substitution("find-pkg-prefix")
class FindPackagePrefix(FindPackage):
    """The prefix under which a package is installed. Raises PackageNotFoundError."""

    def find(self, package_name: str) -> str:
        from ament_index_python.packages import get_package_prefix

        return get_package_prefix(package_name)


@expose_substitution("find-pkg-share")
class FindPackageShare(FindPackage):
    """A package's folder `<prefix>/share/<package>`."""

    def find(self, package_name: str) -> str:
        from ament_index_python.packages import get_package_share_directory

        return get_package_share_directory(package_name)
