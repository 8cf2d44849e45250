"""cp and mv, like GNU's in edge cases: nothing is copied onto or into itself, and no folder silently replaces another."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path

from day6_core import deep
from day6_core.session.session import Session
from day6_core.session.task import let_others_run
from day6_core.shell.builtins.files import removed
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.builtins.text import text_named, write_named
from day6_core.shell.outside import asking
from day6_core.shell.own_streams import stream_number

BLOCK = 1024 * 1024
"""Bytes copied before other programs may run."""

_LONG = {
    "--archive": "a", "--force": "f", "--interactive": "i", "--no-clobber": "n", "--recursive": "r", "--update": "u",
    "--verbose": "v",
}  # fmt: skip


class _Refused(Exception):
    """Why one file was not copied or moved; the text is complete but for the name of the command."""


@asking(lambda names: names[-1:])
async def cp(session: Session) -> int:
    """`cp [-rafvinpu] SOURCE… TARGET`."""
    return await _Transfer(session).run(move=False)


@asking(lambda names: names)
async def mv(session: Session) -> int:
    """`mv [-fvinu] SOURCE… TARGET`."""
    return await _Transfer(session).run(move=True)


class _Transfer:
    """One call of cp or mv."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.options: dict[str, str] = {}
        self.failed = False
        self._left: list[tuple[str, str] | Callable[[], None]] = []
        """What is still to be copied of folders, last first, and what follows the last of each: no tree is too deep."""

    async def run(self, *, move: bool) -> int:
        session = self.session
        try:
            self.options, names = parse(session.argv, "rRafvinpudP", "", _LONG)
            if len(names) < 2:
                missing = f"missing destination file operand after '{names[0]}'" if names else "missing file operand"
                raise UsageError(f"{missing}\nTry '{session.name} --help' for more information.")
        except UsageError as error:
            complain(session, error)
            return 1
        *sources, target = names
        # A dot means a folder even if that folder has been removed.
        into = bool(target) and (os.path.basename(target) in (".", "..") or (session.cwd / target).is_dir())
        if len(sources) > 1 and not into:
            there = bool(target) and os.path.lexists(session.cwd / target)
            complain(session, f"target '{target}': {os.strerror(errno.ENOTDIR if there else errno.ENOENT)}")
            return 1
        for name in sources:
            shown = os.path.join(target, os.path.basename(name.rstrip("/"))) if into else target
            await self._one(name, shown, move=move)
        return 1 if self.failed else 0

    async def _one(self, name: str, shown: str, *, move: bool) -> None:
        try:
            await (self._move if move else self._copy)(name, shown)
        except _Refused as refusal:
            self.complain(str(refusal))
        await self._copy_what_is_left()

    async def _copy_what_is_left(self) -> None:
        while self._left:
            step = self._left.pop()
            if callable(step):
                step()
                continue
            try:
                await self._copy(*step, is_inner=True)
            except _Refused as refusal:
                self.complain(str(refusal))
            await let_others_run()

    def complain(self, text: str) -> None:
        complain(self.session, text)
        self.failed = True

    def _report(self, text: str) -> None:
        if "v" in self.options:
            self.session.print(text)

    @property
    def _recursive(self) -> bool:
        return bool({"r", "R", "a"} & self.options.keys())

    # -- checks of both ------------------------------------------------------------------------------------------------

    async def _may_replace(self, source: os.stat_result, name: str, shown: str) -> bool:
        """Whether `shown`, if it exists, may be overwritten; False skips it silently. Raises _Refused."""
        goal = os.path.join(self.session.cwd, shown)
        if not shown or not deep.mode(goal):
            return True
        is_folder = deep.is_folder(goal, follow=True)
        folder = is_folder and not (deep.is_link(goal) and not stat.S_ISDIR(source.st_mode))
        if folder and not stat.S_ISDIR(source.st_mode):
            raise _Refused(f"cannot overwrite directory '{shown}' with non-directory")
        if stat.S_ISDIR(source.st_mode) and (not is_folder or deep.is_link(goal)):  # it could lead back into the source
            raise _Refused(f"cannot overwrite non-directory '{shown}' with directory '{name}'")
        if "n" in self.options and not (folder and self._recursive):
            return False
        if "u" in self.options and not folder and deep.status(goal, follow=True).st_mtime_ns >= source.st_mtime_ns:
            return False
        if "i" in self.options and not folder:
            self.session.stderr.write(f"{self.session.name}: overwrite '{shown}'? ")
            return (await self.session.stdin.read_line()).strip().lower() in ("y", "yes")
        return True

    def _look(self, name: str, *, follow: bool) -> os.stat_result:
        """Return the status of `name`. Raises _Refused."""
        try:
            if not name:
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
            path = os.path.join(self.session.cwd, name)  # a slash at the end means a folder
            return deep.status(path, follow=follow)
        except OSError as error:
            raise _Refused(f"cannot stat '{name}': {reason(error)}") from None

    def _is_inside(self, name: str, shown: str) -> bool:
        """Whether `shown` would lie in the folder `name`, or is it."""
        folder, goal = (Path(self.session.cwd, each).resolve() for each in (name, shown))
        return folder == goal or folder in goal.parents

    # -- copying -------------------------------------------------------------------------------------------------------

    async def _copy(self, name: str, shown: str, *, is_inner: bool = False) -> None:
        follow = not self._recursive and not {"d", "P"} & self.options.keys()
        source = self._look(name, follow=follow)
        if stat.S_ISDIR(source.st_mode) and not self._recursive:
            raise _Refused(f"-r not specified; omitting directory '{name}'")
        goal = os.path.join(self.session.cwd, shown)
        own = not is_inner and any(stream_number(Path(self.session.cwd, each)) is not None for each in (name, shown))
        if own and shown and not stat.S_ISDIR(source.st_mode):
            await self._copy_stream(name, shown)
            return
        if shown and deep.mode(goal, follow=True) and _same(os.path.join(self.session.cwd, name), goal, follow=follow):
            if stat.S_ISDIR(source.st_mode) and name.rstrip("/") in (".", ".."):
                raise _Refused(f"cannot copy a directory, '{name}', into itself, '{shown}'")
            raise _Refused(f"'{name}' and '{shown}' are the same file")
        if stat.S_ISDIR(source.st_mode) and not is_inner and self._is_inside(name, shown):
            raise _Refused(f"cannot copy a directory, '{name}', into itself, '{shown}'")
        if await self._may_replace(source, name, shown):
            await self._copy_any(source, name, shown)

    async def _copy_any(self, source: os.stat_result, name: str, shown: str) -> None:
        if stat.S_ISDIR(source.st_mode):
            self._copy_folder(source, name, shown)
            return
        if stat.S_ISLNK(source.st_mode):
            self._copy_link(name, shown)
        else:
            await self._copy_file(source, name, shown)
        self._keep_times(source, shown)

    def _keep_times(self, source: os.stat_result, shown: str) -> None:
        """`-p`, `-a`: the copy is as old as the original, and has its mode."""
        if not {"p", "a"} & self.options.keys():
            return
        goal = os.path.join(self.session.cwd, shown)
        with contextlib.suppress(OSError, NotImplementedError):  # a file system that knows no times or modes
            deep.set_times(goal, source)
            if not stat.S_ISLNK(source.st_mode):
                deep.set_mode(goal, stat.S_IMODE(source.st_mode))

    def _copy_folder(self, source: os.stat_result, name: str, shown: str) -> None:
        goal = os.path.join(self.session.cwd, shown)
        new = not deep.is_folder(goal, follow=True)
        try:
            if new:
                deep.make_folder(goal, stat.S_IMODE(source.st_mode) | 0o700)
                self._report(f"'{name}' -> '{shown}'")
            inner = sorted(deep.names_in(os.path.join(self.session.cwd, name)), reverse=True)
        except OSError as error:
            what = (
                f"create directory '{shown}'" if new and not deep.is_folder(goal, follow=True) else f"access '{name}'"
            )
            raise _Refused(f"cannot {what}: {reason(error)}") from None
        self._left.append(lambda: self._keep_times(source, shown))
        self._left += [(os.path.join(name, each), os.path.join(shown, each)) for each in inner]

    def _copy_link(self, name: str, shown: str) -> None:
        goal = os.path.join(self.session.cwd, shown)
        try:
            if deep.mode(goal):
                deep.remove(goal, folder=False)
            deep.make_link(deep.target_of(os.path.join(self.session.cwd, name)), goal)
        except OSError as error:
            raise _Refused(f"cannot create symbolic link '{shown}': {reason(error)}") from None
        self._report(f"'{name}' -> '{shown}'")

    async def _copy_file(self, source: os.stat_result, name: str, shown: str) -> None:
        goal = os.path.join(self.session.cwd, shown)
        try:
            reading = deep.open_file(
                os.path.join(self.session.cwd, name), os.O_RDONLY | _FLAGS | getattr(os, "O_NONBLOCK", 0)
            )
        except OSError as error:
            raise _Refused(f"cannot open '{name}' for reading: {reason(error)}") from None
        with open(reading, "rb", buffering=0) as data:
            if deep.is_link(goal) and not deep.mode(goal, follow=True):
                raise _Refused(f"not writing through dangling symlink '{shown}'")
            try:
                writing = self._create(shown, stat.S_IMODE(source.st_mode))
            except OSError as error:
                raise _Refused(f"cannot create regular file '{shown}': {reason(error)}") from None
            self._report(f"'{name}' -> '{shown}'")
            await self._pour(data.read, writing, shown)

    async def _copy_stream(self, name: str, shown: str) -> None:
        """Copy from or to a stream of this command (`/dev/stdin`)."""
        try:
            text = await text_named(self.session, name)
            await write_named(self.session, shown, text.encode("utf-8", "surrogateescape"))
        except OSError as error:
            raise _Refused(f"error copying '{name}' to '{shown}': {reason(error)}") from None

    def _create(self, shown: str, mode: int) -> int:
        """Open the new or old file `shown` to be written. Raises OSError."""
        goal = os.path.join(self.session.cwd, shown)
        if not shown:
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
        if shown.endswith("/") and not deep.is_folder(goal, follow=True):
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
        flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | _FLAGS
        try:
            return deep.open_file(goal, flags, mode & 0o777)
        except OSError:
            if "f" not in self.options or not stat.S_ISREG(deep.mode(goal, follow=True)):
                raise
        deep.remove(goal, folder=False)
        return deep.open_file(goal, flags, mode & 0o777)

    async def _pour(self, read: object, writing: int, shown: str) -> None:
        """Copy the contents. On a full disk, the part that fits is written, as with GNU's."""
        assert callable(read)
        try:
            with open(writing, "wb", buffering=0) as file:
                while block := read(BLOCK):
                    view = memoryview(block)
                    while view:
                        view = view[file.write(view) or 0 :]
                    await let_others_run()
        except OSError as error:
            raise _Refused(f"error writing '{shown}': {reason(error)}") from None

    # -- moving --------------------------------------------------------------------------------------------------------

    async def _move(self, name: str, shown: str) -> None:
        source = self._look(name, follow=False)
        goal = os.path.join(self.session.cwd, shown)
        if os.path.basename(name.rstrip("/")) in (".", ".."):
            raise _Refused(f"cannot move '{name}' to '{shown}': {os.strerror(errno.EBUSY)}")
        if shown and os.path.lexists(goal) and _same(os.path.join(self.session.cwd, name), goal, follow=False):
            raise _Refused(f"'{name}' and '{shown}' are the same file")
        if stat.S_ISDIR(source.st_mode) and self._is_inside(name, shown):
            raise _Refused(f"cannot move '{name}' to a subdirectory of itself, '{shown}'")
        if not await self._may_replace(source, name, shown):
            return
        try:
            if not shown:
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
            if shown.endswith("/") and not stat.S_ISDIR(source.st_mode) and not os.path.isdir(goal):
                raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
            deep.rename(os.path.join(self.session.cwd, name), goal)
        except OSError as error:
            if error.errno != errno.EXDEV:
                raise _Refused(f"cannot move '{name}' to '{shown}': {reason(error)}") from None
            if not await self._moved_to_another_disk(source, name, shown):
                self.failed = True
                return
        self._report(f"renamed '{name}' -> '{shown}'")

    async def _moved_to_another_disk(self, source: os.stat_result, name: str, shown: str) -> bool:
        """Copy it, and remove the original only when every part has been copied; return whether all of that went well."""
        copier = _Transfer(self.session)
        copier.options = {"a": "a"}
        await copier._copy_any(source, name, shown)
        await copier._copy_what_is_left()
        return not copier.failed and await removed(self.session, name)


_FLAGS = getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)


def _same(source: str, goal: str, *, follow: bool) -> bool:
    """Whether both names mean the same file, which a copy would truncate and a move would delete."""
    try:
        if os.path.samestat(deep.status(source, follow=True), deep.status(goal, follow=True)):
            return follow or not deep.is_link(goal) or os.path.samestat(deep.status(source), deep.status(goal))
    except OSError:
        return False
    return False
