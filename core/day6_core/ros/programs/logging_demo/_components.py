"""The two components: one logs in every way that rclcpp has, the other one changes levels when asked (logging_demo/src)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from logging_demo.srv import ConfigLogger

from day6_core.ros.programs.demo_messages import String
from rclpy.logging import LoggingSeverity

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from rclpy.node import Node

PERIOD = 0.5
"""Seconds between two rounds of messages."""
QUIET = 5.5
"""Seconds after which DEBUG is switched on."""
LAST_COUNT = 15


class LoggerUsage:
    """Publishes a count twice a second, and logs once, always, and at DEBUG where that is true of the count."""

    NAME = "logger_usage_demo"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._count = 0
        self._publisher = node.create_publisher(String, "logging_demo_count", 10)
        node.create_timer(PERIOD, self._on_timer)
        self._change = node.create_timer(QUIET, self._log_more)

    def _log_more(self) -> None:
        self._change.cancel()
        self._logger.info("Setting severity threshold to DEBUG")
        self._logger.set_level(LoggingSeverity.DEBUG)

    def _on_timer(self) -> None:
        logger = self._logger
        logger.info("Timer callback called (this will only log once)", once=True)
        message = String(data=f"Current count: {self._count}")
        logger.info(f"Publishing: '{message.data}'")
        self._publisher.publish(message)
        # Whether a DEBUG message is true of the count is found out only where it would be shown.
        if logger.is_enabled_for(LoggingSeverity.DEBUG):
            if self._divides_twelve():
                logger.debug("Count divides into 12 (function evaluated to true)")
            if self._count % 2 == 0:
                logger.debug("Count is even (expression evaluated to true)")
        self._count += 1
        if self._count > LAST_COUNT:
            logger.warning("Reseting count to 0")
            self._count = 0

    def _divides_twelve(self) -> bool:
        if self._count == 0:
            self._logger.error("Modulo divisor cannot be 0")
            return False
        return 12 % self._count == 0


class LoggerConfig:
    """Sets the level of any logger of its process; '' is the default of all."""

    NAME = "logger_config"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._levels = node.context._logging
        node.create_service(ConfigLogger, "config_logger", self._configure)

    def _configure(self, request: Any, response: Any) -> Any:
        self._logger.info(f"Incoming request: logger '{request.logger_name}', severity '{request.level}'")
        try:
            level = LoggingSeverity[request.level.upper()]
        except KeyError:
            self._logger.error(f"Unknown severity '{request.level}'")
            response.success = False
            return response
        self._levels.set_level(request.logger_name, int(level))
        response.success = True
        return response


COMPONENTS: dict[str, type[Component]] = {
    f"logging_demo::{kind.__name__}": kind for kind in (LoggerConfig, LoggerUsage)
}
