"""The two services by which others read and set the levels of a node's loggers (off by default)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import LoggerLevel, SetLoggerLevelsResult
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.logging import get_logger_level, set_logger_level
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.node import Node


class LoggingService:
    """Creates `~/get_logger_levels` and `~/set_logger_levels`."""

    def __init__(self, node: Node) -> None:
        for service, name, callback in (
            (GetLoggerLevels, "get_logger_levels", self._get),
            (SetLoggerLevels, "set_logger_levels", self._set),
        ):
            node.create_service(
                service, f"{node.get_name()}/{name}", callback, qos_profile=qos_profile_services_default
            )

    def _get(self, request: Any, response: Any) -> Any:
        for name in request.names:
            try:
                level = get_logger_level(name)
            except RuntimeError:
                level = LoggingSeverity.UNSET
            response.levels.append(LoggerLevel(name=name, level=int(level)))
        return response

    def _set(self, request: Any, response: Any) -> Any:
        for wanted in request.levels:
            result = SetLoggerLevelsResult(successful=True)
            try:
                set_logger_level(wanted.name, wanted.level, detailed_error=True)
            except ValueError:
                result = SetLoggerLevelsResult(successful=False, reason="Failed reason: Invalid logger level.")
            except RuntimeError as error:
                result = SetLoggerLevelsResult(successful=False, reason=str(error))
            response.results.append(result)
        return response
