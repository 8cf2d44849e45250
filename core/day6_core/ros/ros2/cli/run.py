"""From a command line to its verb and back to an exit status."""

from __future__ import annotations

import logging
import signal
from typing import TYPE_CHECKING, Any

from day6_core.ros import environment
from day6_core.ros.ros2.cli.choice import NothingChosen
from day6_core.ros.ros2.cli.tree import build_parser
from day6_core.session.argument_parser import ParserExit
from day6_core.session.session import Crash
from day6_core.session.streams import WriteError

if TYPE_CHECKING:
    from day6_core.session.session import Session

_log = logging.getLogger(__name__)

VERSION = "0.36.1"
"""The version of ros2cli whose behaviour and texts these are."""


_NO_VERSION = {
    "en": "note: the ros2 of a real installation has no --version; it prints its usage",
    "zh": "说明：真正安装的 ros2 没有 --version，它只会打印用法",
}


async def run_command(session: Session) -> int:
    """Parse `session.argv` and run the verb; exit statuses as ros2cli's: 2 for Ctrl-C, 1 for a reported failure."""
    environment.activate()
    argv = session.argv[1:]
    if argv == ["--version"]:
        session.print(f"ros2 {VERSION} (day6-tui)")
        from day6_core.language import language_of

        session.print_error(_NO_VERSION[language_of(session.env)])
        return 0
    try:
        args = build_parser(session, argv).parse_args(argv)
    except ParserExit as end:
        return end.status
    if not hasattr(args, "run"):
        args.help_of.print_help()
        return 0
    return await _status_of(session, args)


async def _status_of(session: Session, args: Any) -> int:
    try:
        outcome = await args.run(session, args)
    except ParserExit as end:
        return end.status
    except NothingChosen:
        return 0
    except KeyboardInterrupt:
        return int(signal.SIGINT)
    except (BrokenPipeError, WriteError):
        raise
    except (RuntimeError, Crash, TimeoutError) as error:
        # What C++ code throws within `ros2` itself comes to Python as a RuntimeError (pybind11).
        outcome = str(error)
    except Exception as error:
        from day6_core.ros.ros2.cli.failure import failure_text

        _log.debug("%s", " ".join(session.argv), exc_info=True)
        session.stderr.write(failure_text(error))
        return 1
    if isinstance(outcome, str):
        session.print_error(outcome)
        return 1
    return int(outcome or 0)
