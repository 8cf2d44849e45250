"""Files and robots for RViz, read in threads: the window never waits, and what is not wanted any more is given up."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_tui.core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rviz2.model.manager import RViz
    from day6_tui.core.session.session import Session


class Reader:
    """Does what takes long for one RViz."""

    def __init__(self, session: Session, rviz: RViz) -> None:
        self._session = session
        self._rviz = rviz

    def robot(self, text: str, source: str, done: Callable[[Any], None], cancelled: Callable[[], bool]) -> None:
        """Read a robot description; `source` is its file, '' if it came by a topic. Calls `done` with RobotParts."""
        session, rviz = self._session, self._rviz
        # What the thread may use of the session is copied now.
        prefixes = session.env.get("AMENT_PREFIX_PATH", "")
        folder = (session.cwd / source).parent if source else None

        def work() -> Any:
            from day6_tui.core.ros.programs.rviz2.model.meshes import MeshStore
            from day6_tui.core.ros.programs.rviz2.model.robot_parts import read_robot

            def progress(text: str) -> None:
                rviz.progress = text
                rviz.touch()

            store = MeshStore(prefixes.split(os.pathsep), folder, cancelled, progress)
            return read_robot(text, store.read)

        async def run() -> None:
            parts = await in_thread(work)
            rviz.progress = ""
            if not cancelled():
                done(parts)
            rviz.touch()

        session.spawn(run())

    def file(self, name: str, done: Callable[[str], None]) -> None:
        """Read a text file; one that cannot be read is empty, as for RViz."""
        path = self._session.cwd / Path(name).expanduser()

        def work() -> str:
            try:
                if path.stat().st_size > 64_000_000:
                    return ""
                return path.read_text(encoding="utf-8", errors="replace")
            except OSError:
                return ""

        async def run() -> None:
            done(await in_thread(work))
            self._rviz.touch()

        self._session.spawn(run())

    def path(self, name: str) -> Path:
        """The file that a user of this program means."""
        return self._session.cwd / Path(name).expanduser()

    def write(self, path: Path, text: str) -> None:
        """Write a small text file. Raises OSError."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
