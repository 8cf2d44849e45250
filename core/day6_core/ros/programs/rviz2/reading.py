"""Files and robots for RViz, read in threads: the window never waits, and reads that are no longer needed are cancelled."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._robot_files import are_of_this_machine, share_folders
from day6_core.session.threads import in_thread
from day6_core.whole_file import replace_file

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_core.session.session import Session


class Reader:
    """Runs the slow tasks of one RViz."""

    def __init__(self, session: Session, rviz: RViz) -> None:
        self._session = session
        self._rviz = rviz

    def robot(
        self, text: str, source: str, trusted: bool, done: Callable[[Any], None], cancelled: Callable[[], bool]
    ) -> None:
        """Read a robot description; `source` is its file, '' if it came by a topic. Calls `done` with RobotParts.

        `trusted`: it came from this machine, and may name any file of it.
        """
        session, rviz = self._session, self._rviz
        # What the thread may use of the session is copied now.
        share_of = share_folders(self._session)
        folder = (session.cwd / source).parent if source else None

        def work() -> Any:
            from day6_core.ros.programs.rviz2.model.meshes import MeshStore
            from day6_core.ros.programs.rviz2.model.robot_parts import read_robot

            def progress(text: str) -> None:
                rviz.progress = text
                rviz.touch()

            store = MeshStore(share_of, folder, cancelled, progress, anywhere=trusted)
            return read_robot(text, store.read)

        async def run() -> None:
            parts = await in_thread(work)
            rviz.progress = ""
            if not cancelled():
                done(parts)
            rviz.touch()

        session.spawn(run())

    def mesh(self, uri: str, trusted: bool, done: Callable[[Any], None]) -> None:
        """Read one mesh of a marker; `trusted` as for a robot. Calls `done` with its MeshData, None if it cannot be read."""
        share_of = share_folders(self._session)

        def work() -> Any:
            from day6_core.ros.programs.rviz2.model.meshes import MeshStore

            try:
                return MeshStore(share_of, anywhere=trusted).read(uri)
            except (OSError, ValueError, MemoryError):
                return None

        async def run() -> None:
            done(await in_thread(work))
            self._rviz.touch()

        self._session.spawn(run())

    def is_of_this_machine(self, gid: bytes | None) -> bool:
        """Whether a publisher belongs to this process, or to another one of this user on this machine."""
        return gid is not None and are_of_this_machine(self._session, lambda publisher: publisher.gid == gid)

    def file(self, name: str, done: Callable[[str], None]) -> None:
        """Read a text file; one that cannot be read is empty, as for RViz."""
        path = self._session.path(name)

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
        return self._session.path(name)

    def write(self, path: Path, text: str) -> None:
        """Write a small text file, without waiting for the disk: this is the scheduler's thread. Raises OSError."""
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, text.encode("utf-8"), sync=False)
