"""`ros2 run day6_bot copy_model [NAME]`: copy a shipped robot's URDF here; without a name, list the robots."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_urdf import copy_model, shipped_model, shipped_models

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    if len(session.argv) < 2:
        session.print(*shipped_models(), sep="\n")
        return 0
    name = session.argv[1]
    try:
        file = shipped_model(name).name
        there = (session.cwd / file).exists()
        copy_model(session.cwd, name)
    except KeyError:
        session.print_error(f"there is no robot '{name}'; there are {', '.join(shipped_models())}")
        return 1
    except OSError as error:
        session.print_error(f"{name}.urdf cannot be written here: {error.strerror}")
        return 1
    session.print(f"{file} is here already and stays as it is" if there else f"{file} written")
    return 0
