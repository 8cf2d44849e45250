"""The services by which other programs read and set a node's log levels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy._day6.logging_settings import LoggingSettings
    from rclpy.node import Node

__getattr__ = also(__name__, "TOPIC_SEPARATOR_STRING GetLoggerLevels LoggerLevel SetLoggerLevels SetLoggerLevelsResult")


class LoggingService:
    """Serves `~/get_logger_levels` and `~/set_logger_levels`."""

    def __init__(self, node: Node) -> None:
        from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

        self._settings: LoggingSettings = node.context._logging
        name = node.get_name()
        for srv_type, service, answer in (
            (GetLoggerLevels, "get_logger_levels", self._get_logger_levels),
            (SetLoggerLevels, "set_logger_levels", self._set_logger_levels),
        ):
            node.create_service(srv_type, f"{name}/{service}", answer, qos_profile=qos_profile_services_default)

    def _get_logger_levels(self, request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import LoggerLevel

        response.levels = [LoggerLevel(name=name, level=self._settings.level(name)) for name in request.names]
        return response

    def _set_logger_levels(self, request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import SetLoggerLevelsResult

        for each in request.levels:
            result = SetLoggerLevelsResult(successful=True)
            try:
                self._settings.set_level(each.name, int(LoggingSeverity(each.level)))
            except ValueError:
                result = SetLoggerLevelsResult(successful=False, reason="Failed reason: Invalid logger level.")
            response.results.append(result)
        return response
