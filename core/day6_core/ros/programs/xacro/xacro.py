"""`xacro FILE [NAME:=VALUE …]`: write the URDF that a xacro file stands for.

In a process of its own, as in real ROS: a file may hold expressions of Python, and recursion without end. That process has limits
(`day6_core.ros.programs.xacro.limits`); where one is passed the status is 2, as of every error of xacro.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.xacro.limits import CPU_SECONDS, OUT_OF_TIME

if TYPE_CHECKING:
    from day6_core.session.session import Session

_START = (
    "from day6_core.session.harmless import guard_standard_streams; guard_standard_streams(); "
    "from day6_core.ros.programs.xacro.limits import run; run({})"
)
_FAILED = 2


async def main(session: Session) -> int:
    from day6_core.ros.environment import as_program
    from day6_core.session.session import KilledBySignal
    from day6_core.session.signals import NUMBERS

    session.env = as_program(session.env)  # for $(find PACKAGE)
    try:
        status = await session.run_python(["-c", _START.format(CPU_SECONDS), *session.argv[1:]])
    except KilledBySignal as end:
        if end.number != NUMBERS["XCPU"]:
            raise
        status = OUT_OF_TIME
    if status == OUT_OF_TIME:
        session.print_error(f"error: xacro was ended: it needed more than {CPU_SECONDS} seconds of the processor")
        return _FAILED
    return status
