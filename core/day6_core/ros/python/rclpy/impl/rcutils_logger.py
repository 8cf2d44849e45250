"""The logger of rclpy, with its filters once, throttle and skip_first."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Mapping
from types import FrameType
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from rclpy._day6.incidental import also
from rclpy._day6.logging_settings import PROCESS, LoggingSettings
from rclpy._day6.withdrawn import withdraw
from rclpy.clock import Clock
from rclpy.impl.logging_severity import LoggingSeverity

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from rclpy._day6.typing_names import LoggingArgs, LoggingFilterArgs, ThrottleContext

__getattr__ = also(
    __name__,
    "LoggingArgs LoggingFilterArgs LoggingFilterParams OnceContext RcutilsLoggerContext SkipFirstContext SupportedFilters "
    "ThrottleContext",
)

_INTERNAL_FILES: frozenset[str] = frozenset(
    (__file__, os.path.join(os.path.dirname(os.path.dirname(__file__)), "logging.py"))
)
_internal_callers: list[str] = []
"""What others count as logging code too: tools that wrap the loggers add (a part of) the path of their file."""
_absolute: dict[str, str] = {}


def _find_caller(frame: FrameType | None) -> FrameType:
    """Return the nearest frame outside the logging code."""
    while frame is not None and _is_internal(frame.f_code.co_filename):
        frame = frame.f_back
    if frame is None:
        raise ValueError("Cannot get frame info if frame is None")
    return frame


def _is_internal(file: str) -> bool:
    if file in _INTERNAL_FILES:
        return True
    return bool(_internal_callers) and any(part in os.path.realpath(file) for part in _internal_callers)


class CallerId(NamedTuple):
    """The place of one logging call."""

    function_name: str
    file_path: str
    line_number: int
    last_index: int

    @staticmethod
    def _of(frame: FrameType) -> CallerId:
        """Return the current place of a frame."""
        code = frame.f_code
        path = _absolute.get(code.co_filename)
        if path is None:
            path = _absolute[code.co_filename] = os.path.abspath(code.co_filename)
        return CallerId(code.co_name, path, frame.f_lineno, frame.f_lasti)


class LoggingFilter:
    """Base of the filters: `params` are its arguments and their defaults (None: required)."""

    params: dict[str, Any] = {}

    @classmethod
    def initialize_context(cls, context: dict[str, object], **kwargs: object) -> None:
        """Store the filter's arguments in the state of a logging call."""
        for name, default in cls.params.items():
            value = kwargs.get(name, default)
            if value is None:
                raise TypeError(f'Required parameter "{name}" was not specified for logging filter "{cls.__name__}"')
            context[name] = value

    @staticmethod
    def should_log(context: dict[str, object]) -> bool:
        """Return whether the call may log now."""
        return True


class Once(LoggingFilter):
    """Lets a call log only the first time."""

    params = {"once": None}

    @staticmethod
    def should_log(context: dict[str, object]) -> bool:
        """Return whether this is the first time."""
        first = not context.get("has_been_logged_once")
        context["has_been_logged_once"] = True
        return first


class Throttle(LoggingFilter):
    """Lets a call log at most once in some seconds."""

    params = {"throttle_duration_sec": None, "throttle_time_source_type": Clock()}

    @classmethod
    def initialize_context(cls, context: dict[str, object], **kwargs: object) -> None:
        """Store duration and clock.

        Raises:
            ValueError: for anything that isn't a clock.
        """
        super().initialize_context(context, **kwargs)
        context["throttle_last_logged"] = 0
        clock = context["throttle_time_source_type"]
        if not isinstance(clock, Clock):
            raise ValueError(f'Received throttle_time_source_type of "{clock}" is not a clock instance')

    @staticmethod
    def should_log(context: dict[str, object]) -> bool:
        """Return whether the duration is over."""
        memory = cast("ThrottleContext", context)
        now = memory["throttle_time_source_type"].now().nanoseconds
        if now < memory["throttle_last_logged"] + memory["throttle_duration_sec"] * 1e9:
            return False
        memory["throttle_last_logged"] = now
        return True


class SkipFirst(LoggingFilter):
    """Lets a call log from the second time on."""

    params = {"skip_first": None}

    @staticmethod
    def should_log(context: dict[str, object]) -> bool:
        """Return whether this is not the first time."""
        skipped = bool(context.get("first_has_been_skipped"))
        context["first_has_been_skipped"] = True
        return skipped


supported_filters: dict[str, type[LoggingFilter]] = {"throttle": Throttle, "skip_first": SkipFirst, "once": Once}


def get_filters_from_kwargs(**kwargs: object) -> list[str]:
    """Return the names of the filters for some arguments.

    Raises:
        TypeError: for unknown or missing arguments.
    """
    detected = [
        name for name, each in supported_filters.items() if any(kwargs.get(argument) for argument in each.params)
    ]
    for name in detected:
        for argument, default in supported_filters[name].params.items():
            if argument not in kwargs and default is None:
                raise TypeError(
                    f'required parameter "{argument}" not specified but is required for the the logging filter "{name}"'
                )
    known = [argument for each in supported_filters.values() for argument in each.params]
    for argument in kwargs:
        if argument not in known:
            raise TypeError(f'parameter "{argument}" is not one of the recognized logging options "{known}"')
    return detected


class _Call:
    """The state of one logging call: its arguments of the first time."""

    __slots__ = ("context", "filters", "name", "severity")

    def __init__(self, severity: int, name: str, filters: list[str], kwargs: Mapping[str, object]) -> None:
        self.severity = severity
        self.name = name
        self.filters = filters
        self.context: dict[str, object] = {}
        for each in filters:
            supported_filters[each].initialize_context(self.context, **kwargs)

    def check(self, severity: int, name: str, filters: list[str], kwargs: Mapping[str, object]) -> None:
        """Raise ValueError if the same call has other arguments than the first time."""
        if severity != self.severity:
            raise ValueError("Logger severity cannot be changed between calls.")
        if name != self.name:
            raise ValueError("Logger name cannot be changed between calls.")
        if filters != self.filters:
            raise ValueError("Requested logging filters cannot be changed between calls.")
        for each in filters:
            for argument, default in supported_filters[each].params.items():
                if self.context[argument] != kwargs.get(argument, default):
                    raise ValueError("Logging filter parameters cannot be changed between calls.")


class RcutilsLogger:
    """A named logger. Levels are those of the name, else of its parents, else the default."""

    def __init__(self, name: str = "") -> None:
        self.name = name
        self.contexts: dict[CallerId, _Call] = {}
        self._settings: LoggingSettings = PROCESS
        self._registered = False

    @classmethod
    def _of_node(cls, name: str, settings: LoggingSettings) -> RcutilsLogger:
        logger = cls(name)
        logger._settings = settings
        return logger

    def __del__(self) -> None:
        if self._registered:
            self._settings.publishers.pop(self.name, None)

    def get_child(self, name: str) -> RcutilsLogger:
        """Return the logger `<this name>.<name>`.

        Raises:
            ValueError: for an empty name.
        """
        if not name:
            raise ValueError("Child logger name must not be empty.")
        logger = self._of_node(self.name + "." + name if self.name else name, self._settings)
        publisher = self._settings.publishers.get(self.name) if self.name else None
        if publisher is not None and logger.name not in self._settings.publishers:
            self._settings.publishers[logger.name] = publisher
            logger._registered = True
        return logger

    def set_level(self, level: int | LoggingSeverity) -> None:
        """Set this logger's level.

        Raises:
            ValueError: for a number that isn't a level.
        """
        self._settings.set_level(self.name, int(LoggingSeverity(level)))

    def get_effective_level(self) -> LoggingSeverity:
        """Return the effective level of this logger."""
        return LoggingSeverity(self._settings.effective_level(self.name))

    def is_enabled_for(self, severity: int | LoggingSeverity) -> bool:
        """Return whether messages of that level are logged."""
        return self._settings.effective_level(self.name) <= LoggingSeverity(severity)

    def log(
        self,
        message: str,
        severity: int | LoggingSeverity,
        name: str | None = None,
        **kwargs: Unpack[LoggingFilterArgs],
    ) -> bool:
        """Log a message; the keyword arguments are those of the filters.

        Returns whether it was logged.

        Raises:
            TypeError: for a message that isn't a str and for unknown arguments.
            ValueError: if the same call changes its level, name or filters.
        """
        if severity.__class__ is not LoggingSeverity:
            severity = LoggingSeverity(severity)
        settings = self._settings
        if settings.effective_level(self.name) > severity:
            return False
        if name is None:
            name = self.name
        frame = _find_caller(sys._getframe(1))
        filters = get_filters_from_kwargs(**kwargs) if kwargs else []
        caller = CallerId._of(frame)
        call = self.contexts.get(caller)
        if call is None:
            self.contexts[caller] = call = _Call(severity, name, filters, kwargs)
        elif severity != call.severity or name != call.name or filters or call.filters:
            call.check(severity, name, filters, kwargs)
        for each in call.filters:
            if not supported_filters[each].should_log(call.context):
                return False
        if message is None:
            message = "(null)"
        elif isinstance(message, bytes):
            message = message.decode("utf-8", "replace")
        elif not isinstance(message, str):
            raise TypeError(_wrong_message(severity, name, message, caller))
        file = self._written(caller.file_path)
        settings.emit(int(severity), name, message, caller.function_name, file, caller.line_number)
        return True

    def _written(self, path: str) -> str:
        """How messages name a file, whose path is absolute."""
        return path

    def debug(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level DEBUG; see `log`."""
        return self.log(message, LoggingSeverity.DEBUG, **kwargs)

    def info(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level INFO; see `log`."""
        return self.log(message, LoggingSeverity.INFO, **kwargs)

    def warning(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level WARN; see `log`."""
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def warn(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level WARN: the old name of `warning`."""
        warnings.warn(
            "Deprecated in favor of :py:classmethod:RcutilsLogger.warning:.", DeprecationWarning, stacklevel=2
        )
        return self.warning(message, **kwargs)

    def error(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level ERROR; see `log`."""
        return self.log(message, LoggingSeverity.ERROR, **kwargs)

    def fatal(self, message: str, **kwargs: Unpack[LoggingArgs]) -> bool:
        """Log with level FATAL; see `log`."""
        return self.log(message, LoggingSeverity.FATAL, **kwargs)


def _effective_level_of(name: str) -> int:
    """Return the effective level of a logger, like the next two by the binding's name: for loggers of other packages' own."""
    return PROCESS.effective_level(name)


def _is_enabled_for(name: str, severity: int) -> bool:
    return PROCESS.effective_level(name) <= int(severity)


def _log_from(severity: int, name: str, message: str, function: str, file: str, line: int) -> None:
    """Log what was said at this place, if the logger's level allows it."""
    if _is_enabled_for(name, severity):
        PROCESS.emit(int(severity), name, message, function, file, line)


def _wrong_message(severity: Any, name: str, message: object, caller: CallerId) -> str:
    """Return real rclpy's error text for a message that isn't a str; its binding prints the whole call."""
    return (
        "rclpy_logging_rcutils_log(): incompatible function arguments. The following argument types are supported:\n"
        "    1. (arg0: typing.SupportsInt, arg1: str, arg2: str, arg3: str, arg4: str, arg5: typing.SupportsInt) -> None"
        f"\n\nInvoked with: {severity!r}, {name!r}, {message!r}, {caller.function_name!r}, {caller.file_path!r}, "
        f"{caller.line_number!r}"
    )


withdraw(__name__)
