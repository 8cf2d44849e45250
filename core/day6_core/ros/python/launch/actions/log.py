"""Log a message with a level."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from day6_core.ros import differences
from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext

_LEVELS = ("CRITICAL", "FATAL", "ERROR", "WARN", "WARNING", "INFO", "DEBUG", "NOTSET")
_NO_LEVEL = "The action log now expects a log level. Either provide one or switch to using the log_info action"


class LogInterface(Action):
    """Logs `msg` with the logger 'launch.user'. Raises KeyError if there is no such level when it runs."""

    def __init__(self, *, msg: SomeSubstitutionsType, level: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__msg = normalize_to_list_of_substitutions(msg)
        self.__level = normalize_to_list_of_substitutions(level)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["msg"] = parser.parse_substitution(entity.get_attr("message"))
        return cls, keywords

    @property
    def msg(self) -> list[Substitution]:
        return self.__msg

    @property
    def level(self) -> list[Substitution]:
        return self.__level

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        level = perform_substitutions(context, self.level).upper()
        if level not in _LEVELS:
            raise KeyError(f"Invalid log level '{level}', expected: {dict.fromkeys(_LEVELS).keys()}")
        launch.logging.get_logger("launch.user").log(getattr(logging, level), perform_substitutions(context, self.msg))
        return None


@expose_action("log")
class Log(LogInterface):
    """The tag `log`; before Lyrical it has no level and logs as `LogInfo`."""

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        if not differences.in_launch("launch.actions:Log"):
            return LogInfo, keywords
        level = entity.get_attr("level", optional=True)
        if level is None:
            import warnings

            warnings.warn(_NO_LEVEL, stacklevel=2)
        keywords["level"] = parser.parse_substitution(level or "INFO")
        return cls, keywords


class _Leveled(LogInterface):
    LEVEL = ""

    def __init__(self, *, msg: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(msg=msg, level=self.LEVEL, **kwargs)


@expose_action("log_info")
class LogInfo(_Leveled):
    """Logs with the level INFO."""

    LEVEL = "INFO"


@expose_action("log_warning")
class LogWarning(_Leveled):
    """Logs with the level WARNING."""

    LEVEL = "WARNING"


@expose_action("log_debug")
class LogDebug(_Leveled):
    """Logs with the level DEBUG."""

    LEVEL = "DEBUG"


@expose_action("log_error")
class LogError(_Leveled):
    """Logs with the level ERROR."""

    LEVEL = "ERROR"
