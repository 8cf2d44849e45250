"""dlopen_composition: loads the component libraries that it is given by their paths. Here there are none to load."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    if len(session.argv) < 2:
        session.print_error("Requires at least one argument to be passed with the library to load")
    else:
        session.print_error(
            "dlopen_composition loads shared libraries of C++, and day6-tui runs no C++: "
            "try `ros2 run composition manual_composition`, or a container and `ros2 component load`"
        )
    return 1
