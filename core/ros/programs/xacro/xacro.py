"""`xacro FILE [NAME:=VALUE …]`: write the URDF that a xacro file stands for.

In a process of its own, as in real ROS: a file may hold expressions of Python, and recursion without end.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

_START = (
    "from day6_tui.core.session.harmless import guard_standard_streams; guard_standard_streams(); "
    "import sys, xml.parsers.expat; from xacro import main; sys.argv[0] = 'xacro'; sys.exit(main())"
)
# xml.parsers is for xacro itself: it names that module without importing it.


async def main(session: Session) -> int:
    from day6_tui.core.ros.environment import PYTHON_PATH, program_environment

    if str(PYTHON_PATH) not in session.env.get("PYTHONPATH", ""):
        session.env = program_environment(session.env)  # for $(find PACKAGE), in a real terminal
    return await session.run_python(["-c", _START, *session.argv[1:]])
