"""The logs of a launch: the screen, `launch.log` (or `--log-file-name`) in a folder per launch, files of single processes.

The folder is `<date>-<host>-<pid>` below ROS_LOG_DIR, or ROS_HOME/log, or ~/.ros/log; `latest` beside it points to the newest.
"""

from __future__ import annotations

import datetime
import logging
import os
import socket
import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from launch.logging import handlers

__all__ = ["get_logger", "get_output_loggers", "handlers", "launch_config", "log_launch_config", "reset"]

_SCREEN_FORMATS = {
    "default": "[{levelname}] [{name}]: {message}",
    "default_with_timestamp": "{created:.7f} [{levelname}] [{name}]: {message}",
}
_FILE_FORMATS = {"default": "{created:.7f} [{levelname}] [{name}]: {message}"}
_CONFIGURED: set[str] = set()
"""Names of the loggers that got handlers here."""


class LaunchConfig:
    """The configuration of a launch's log; its only instance is `launch.logging.launch_config`."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Reset folder, handlers and formats."""
        self._log_dir: str | None = None
        self._factory: Callable[..., logging.Handler] | None = None
        self.file_name = "launch.log"
        self.file_handlers: dict[str, Any] = {}
        self.screen_handler: Any = None
        self.screen_formatter: logging.Formatter | None = None
        self.file_formatter: logging.Formatter | None = None
        logging.root.setLevel(logging.INFO)
        self.set_screen_format("default")
        self.set_log_format("default")

    @property
    def level(self) -> int:
        return logging.root.getEffectiveLevel()

    @level.setter
    def level(self, new_level: int | str) -> None:
        logging.root.setLevel(new_level)

    @property
    def log_dir(self) -> str:
        """The folder of this launch's logs, created on first access."""
        if self._log_dir is None:
            self._log_dir = _make_log_dir()
        return self._log_dir

    @log_dir.setter
    def log_dir(self, new_log_dir: str | None) -> None:
        if new_log_dir is not None:
            if self.file_handlers:
                import warnings

                warnings.warn(f"log files of this launch are open below {self._log_dir} already", stacklevel=2)
            if not os.path.isdir(new_log_dir):
                raise ValueError(f"{new_log_dir} is not a directory")
        self._log_dir = new_log_dir

    @property
    def log_handler_factory(self) -> Callable[..., Any]:
        """The factory of log file handlers: `factory(path, encoding=…)`."""
        if self._factory is None:
            self._factory = handlers.FileHandler if os.name == "nt" else handlers.WatchedFileHandler
        return self._factory

    @log_handler_factory.setter
    def log_handler_factory(self, new_factory: Callable[..., Any]) -> None:
        self._factory = new_factory

    def set_screen_format(self, screen_format: str | None, *, screen_style: str | None = None) -> None:
        """Set the format of the screen: 'default', 'default_with_timestamp', or one for `logging.Formatter`."""
        override = os.environ.get("OVERRIDE_LAUNCH_SCREEN_FORMAT")
        self.screen_formatter = _formatter(screen_format, screen_style, override, _SCREEN_FORMATS, "screen")
        if self.screen_formatter is not None and self.screen_handler is not None:
            self.screen_handler.setFormatter(self.screen_formatter)

    def set_log_format(self, log_format: str | None, *, log_style: str | None = None) -> None:
        """Set the format of the log files, like `set_screen_format`."""
        override = os.environ.get("OVERRIDE_LAUNCH_LOG_FORMAT")
        self.file_formatter = _formatter(log_format, log_style, override, _FILE_FORMATS, "log")
        for handler in self.file_handlers.values():
            handler.setFormatter(self.file_formatter)

    def get_screen_handler(self) -> Any:
        """Return the handler that writes to standard output."""
        if self.screen_handler is None:
            self.screen_handler = handlers.StreamHandler(sys.stdout)
            self.screen_handler.setFormatter(self.screen_formatter)
        return self.screen_handler

    def get_log_file_path(self, file_name: str | None = None) -> str:
        """Return the path of a log file in the launch's folder, by default that of the launch itself."""
        return os.path.join(self.log_dir, file_name or self.file_name)

    def get_log_file_handler(self, file_name: str | None = None) -> Any:
        """Return the handler of a log file in the launch's folder, by default that of the launch itself."""
        file_name = file_name or self.file_name
        if file_name not in self.file_handlers:
            handler = self.log_handler_factory(self.get_log_file_path(file_name), encoding="utf-8")
            handler.setFormatter(self.file_formatter)
            self.file_handlers[file_name] = handler
        return self.file_handlers[file_name]


def _formatter(
    wanted: str | None, style: str | None, override: str | None, names: Mapping[str, str], what: str
) -> logging.Formatter | None:
    if override:
        wanted, style = override.encode("latin1").decode("unicode_escape"), "{"
    if wanted is None:
        return None
    if wanted in names and not override:
        if style is not None:
            raise ValueError(f'Cannot set a custom format style for the "{wanted}" {what} format.')
        wanted = names[wanted]
    return logging.Formatter(wanted, style=style or "{")  # type: ignore[arg-type]


def _make_log_dir() -> str:
    base = os.environ.get("ROS_LOG_DIR") or os.path.join(os.environ.get("ROS_HOME") or os.path.join("~", ".ros"), "log")
    base = os.path.normpath(os.path.expanduser(base))
    while True:
        stamp = datetime.datetime.now().strftime("%Y-%m-%d-%H-%M-%S-%f")
        folder = os.path.join(base, f"{stamp}-{socket.gethostname()}-{os.getpid()}")
        try:
            os.makedirs(folder)
            break
        except FileExistsError:
            continue
    latest = os.path.join(base, "latest")
    try:
        if os.path.islink(latest):
            os.unlink(latest)
        if not os.path.lexists(latest):
            os.symlink(folder, latest, target_is_directory=True)
    except OSError as error:
        # Two launches at once, or Windows without the right to create links: only the link is missing.
        logging.getLogger("launch.logging").debug("no link %s: %s", latest, error)
    return folder


launch_config = LaunchConfig()


def log_launch_config(*, logger: logging.Logger = logging.root) -> None:
    """Log the folder of the log files and the log level."""
    if launch_config.file_handlers:
        logger.info(f"All log files can be found below {launch_config.log_dir}")
    logger.info(f"Default logging verbosity is set to {logging.getLevelName(launch_config.level)}")


def get_logger(name: str | None = None) -> logging.Logger:
    """Return a logger that writes to the screen and to `launch.log`."""
    logger = _logger(name)
    for handler in (launch_config.get_screen_handler(), launch_config.get_log_file_handler()):
        if handler not in logger.handlers:
            logger.addHandler(handler)
    return logger


def _logger(name: str | None) -> logging.Logger:
    logger = logging.getLogger(name)
    logger.propagate = False
    _CONFIGURED.add(logger.name)
    return logger


_OUTPUTS: dict[str, dict[str, set[str]]] = {
    "screen": {"both": {"screen"}},
    "log": {"both": {"log"}, "stderr": {"screen"}},
    "both": {"both": {"log", "screen"}},
    "own_log": {"both": {"own_log"}, "stdout": {"own_log"}, "stderr": {"own_log"}},
    "full": {"both": {"screen", "log", "own_log"}, "stdout": {"own_log"}, "stderr": {"own_log"}},
}


def _output_table(config: str | Mapping[str, str | Iterable[str]]) -> dict[str, set[str]]:
    """Return `{'stdout' | 'stderr' | 'both': destinations}`. Raises ValueError for an invalid `output=`."""
    table: dict[str, set[str]] = {"both": set(), "stdout": set(), "stderr": set()}
    if isinstance(config, str):
        if config not in _OUTPUTS:
            raise ValueError(f'{config} is not a valid standard output config i.e. "screen", "log" or "both"')
        table.update(_OUTPUTS[config])
        return table
    if not isinstance(config, Mapping):
        raise ValueError(f"{config} is not a valid output configuration")
    for source, wanted in config.items():
        if source not in table:
            raise ValueError(f'{source} is not a valid output source i.e. "stdout", "stderr" or "both"')
        destinations = {wanted} if isinstance(wanted, str) else set(wanted)
        for each in sorted(destinations - {"screen", "log", "own_log"}):
            raise ValueError(f'{each} is not a valid output destination i.e. "screen", "log" or "own_log"')
        table[source] = destinations
    return table


def get_output_loggers(
    process_name: str, output_config: str | Mapping[str, str | Iterable[str]]
) -> tuple[logging.Logger, logging.Logger]:
    """Return the loggers for a process's stdout and stderr.

    The configuration is 'screen', 'log' (stdout to launch.log, stderr to the screen too), 'both', 'own_log' (files of its own),
    'full', or `{'stdout' | 'stderr' | 'both': destinations}` with destinations 'screen', 'log', 'own_log'.
    """
    table = _output_table(output_config)
    loggers = []
    for source in ("stdout", "stderr"):
        logger = _logger(f"{process_name}-{source}")
        wanted = table["both"] | table[source]
        found: list[Any] = []
        if "screen" in wanted:
            screen = launch_config.get_screen_handler()
            screen.setFormatterFor(logger, logging.Formatter("{message}", style="{"))
            found.append(screen)
        if "log" in wanted:
            file = launch_config.get_log_file_handler()
            file.setFormatterFor(logger, logging.Formatter("{created:.7f} {message}", style="{"))
            found.append(file)
        own = [f"{process_name}-{source}.log"] if "own_log" in table[source] else []
        own += [f"{process_name}.log"] if "own_log" in table["both"] else []
        for file_name in own:
            file = launch_config.get_log_file_handler(file_name)
            file.setFormatter(logging.Formatter("{message}", style="{"))
            found.append(file)
        for handler in found:
            if handler not in logger.handlers:
                logger.addHandler(handler)
        loggers.append(logger)
    return loggers[0], loggers[1]


def reset() -> None:
    """Remove all handlers and start with a new configuration."""
    for name in _CONFIGURED:
        logger = logging.getLogger(name if name != "root" else None)
        logger.setLevel(logging.NOTSET)
        logger.handlers.clear()
    _CONFIGURED.clear()
    launch_config.reset()
