"""Sources of launch descriptions."""

from __future__ import annotations

import traceback

import launch.logging
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


class LaunchDescriptionSource:
    """A launch description, or the `location` from which it is loaded when it is needed."""

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = "<string>",
        method: str = "unspecified mechanism from a script",
    ) -> None:
        self.__launch_description = launch_description
        self.__location = normalize_to_list_of_substitutions(location)
        self.__expanded_location: str | None = None
        self.__method = method

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Return the launch description; None if its location isn't known before launching, or can't be loaded."""
        if self.__launch_description is None:
            try:
                return self._load(perform_substitutions(LaunchContext(), self.__location))
            except Exception as error:
                # It is loaded again when it is visited, and the error is reported then.
                logger = launch.logging.get_logger(__name__)
                logger.debug(traceback.format_exc())
                logger.debug(f"Failed to load the launch file without a context: {error}")
        return self.__launch_description

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """Return the launch description; the first call loads it."""
        if self.__expanded_location is None:
            self.__expanded_location = perform_substitutions(context, self.__location)
        if self.__launch_description is None:
            self.__launch_description = self._load(self.__expanded_location)
        return self.__launch_description

    def _load(self, location: str) -> LaunchDescription:
        from day6_core.ros.differences import launch_file_at

        return self._get_launch_description(launch_file_at(location))

    def _get_launch_description(self, location: str) -> LaunchDescription:
        raise RuntimeError(
            "LaunchDescriptionSource.get_launch_description(): called without launch description being set"
        )

    @property
    def location(self) -> str:
        """The path; while it isn't known, the substitutions that it consists of."""
        if self.__expanded_location is None:
            return " + ".join(map(str, self.__location))
        return self.__expanded_location

    @property
    def described_location(self) -> str:
        """The location as it was written, known or not: two equal ones lead to the same file."""
        return " + ".join(each.describe() for each in self.__location)

    @property
    def method(self) -> str:
        return self.__method
