"""The handlers of `logging` and `logging.handlers`, which can also format the records of single loggers differently."""

from __future__ import annotations

import logging
import logging.handlers
from typing import Any

_classes: dict[str, type] = {}


def __getattr__(name: str) -> Any:
    """Return the handler class of that name, created on first access."""
    base = getattr(logging.handlers, name, None) or getattr(logging, name, None)
    if not (isinstance(base, type) and issubclass(base, logging.Handler)):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name not in _classes:
        _classes[name] = with_per_logger_formatting(base)
    return _classes[name]


def with_per_logger_formatting(cls: Any) -> Any:
    """Return a class derived from a handler class, with `setFormatterFor` and `unsetFormatterFor`."""

    class PerLogger(cls):  # type: ignore[misc]
        def __init__(self, *args: Any, **kwargs: Any) -> None:
            super().__init__(*args, **kwargs)
            self._formatters: dict[str, logging.Formatter] = {}

        def setFormatterFor(self, logger: logging.Logger | str, formatter: logging.Formatter) -> None:
            self._formatters[_name(logger)] = formatter

        def unsetFormatterFor(self, logger: logging.Logger | str) -> None:
            self._formatters.pop(_name(logger), None)

        def format(self, record: logging.LogRecord) -> str:
            own = self._formatters.get(record.name)
            return own.format(record) if own is not None else str(super().format(record))

    PerLogger.__name__ = PerLogger.__qualname__ = cls.__name__
    PerLogger.__doc__ = cls.__doc__
    return PerLogger


def _name(logger: logging.Logger | str) -> str:
    return logger if isinstance(logger, str) else logger.name
