"""diff: two files, or two folders with all that is in them."""

from __future__ import annotations

import difflib
import errno
import os
import stat

from day6_core import deep
from day6_core.session.session import Session
from day6_core.session.task import let_others_run
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.builtins.text import text_named

_KINDS = {stat.S_IFREG: "regular file", stat.S_IFDIR: "directory", stat.S_IFIFO: "fifo", stat.S_IFSOCK: "socket"}
_LONG = {"--unified": "u", "--brief": "q", "--recursive": "r", "--new-file": "N", "--report-identical-files": "s"}


async def diff(session: Session) -> int:
    """`diff [-urqNs] [-U LINES] OLD NEW`."""
    try:
        options, names = parse(session.argv, "uqrbwiNs", "U", _LONG)
        if len(names) != 2:
            missing = f"missing operand after '{session.argv[-1]}'" if len(names) < 2 else f"extra operand '{names[2]}'"
            raise UsageError(f"{missing}\ndiff: Try 'diff --help' for more information.")
    except UsageError as error:
        complain(session, error)
        return 2
    return await _Comparison(session, options).run(*names)


class _Comparison:
    """One call of diff."""

    def __init__(self, session: Session, options: dict[str, str]) -> None:
        self.session = session
        self.options = options
        self.status = 0
        words = session.argv[1:]
        self._words = " ".join(word for word in words if word.startswith("-") and len(word) > 1)

    async def run(self, old: str, new: str) -> int:
        folders = [name != "-" and self._kind(name) == stat.S_IFDIR for name in (old, new)]
        missing = [name for name in (old, new) if any(folders) and name != "-" and not self._kind(name)]
        if missing:
            self._problem(missing[0], FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)))
        elif all(folders):
            await self._folders(old, new)
        else:
            if folders[0] and new != "-":
                old = os.path.join(old, os.path.basename(new))
            elif folders[1] and old != "-":
                new = os.path.join(new, os.path.basename(old))
            await self._files(old, new)
        return self.status

    # -- folders -------------------------------------------------------------------------------------------------------

    async def _folders(self, old: str, new: str) -> None:
        waiting = self._pairs(old, new)  # no recursion: a tree may be deeper than Python's stack
        while waiting:
            old, new = waiting.pop()
            kinds = self._kind(old), self._kind(new)
            both = kinds == (stat.S_IFDIR, stat.S_IFDIR)
            if "r" in self.options and (both or ("N" in self.options and {*kinds} == {0, stat.S_IFDIR})):
                waiting += self._pairs(old, new)
            elif both:
                self.session.print(f"Common subdirectories: {old} and {new}")
            else:
                await self._pair(old, new, kinds)
            await let_others_run()

    def _pairs(self, old: str, new: str) -> list[tuple[str, str]]:
        """What is to be compared of two folders, of which one may be missing, the last first."""
        names = sorted({*self._names_in(old), *self._names_in(new)}, reverse=True)
        return [(os.path.join(old, name), os.path.join(new, name)) for name in names]

    def _names_in(self, name: str) -> list[str]:
        try:
            return deep.names_in(self.session.cwd / name)
        except FileNotFoundError:
            return []
        except OSError as error:
            self._problem(name, error)
            return []

    def _kind(self, name: str) -> int:
        return stat.S_IFMT(deep.mode(self.session.cwd / name, follow=True))

    async def _pair(self, old: str, new: str, kinds: tuple[int, int]) -> None:
        """Compare two of the same name that are not both folders."""
        if 0 in kinds and "N" not in self.options:
            there = new if not kinds[0] else old
            self._differ(f"Only in {os.path.dirname(there)}: {os.path.basename(there)}")
        elif kinds[0] == kinds[1] or 0 in kinds:
            await self._files(old, new, within=True)
        else:
            old_kind, new_kind = (_KINDS.get(kind, "special file") for kind in kinds)
            self._differ(f"File {old} is a {old_kind} while file {new} is a {new_kind}")

    # -- files ---------------------------------------------------------------------------------------------------------

    async def _files(self, old: str, new: str, *, within: bool = False) -> None:
        """Compare two files; `within` folders, a heading says which, and with -N a missing one is empty."""
        texts = [await self._text(name, within and "N" in self.options) for name in (old, new)]
        if texts[0] is None or texts[1] is None:
            return
        if texts[0] == texts[1]:
            if "s" in self.options:
                self.session.print(f"Files {old} and {new} are identical")
        elif "q" in self.options:
            self._differ(f"Files {old} and {new} differ")
        elif "\0" in texts[0] or "\0" in texts[1]:
            self._differ(f"Binary files {old} and {new} differ")
        else:
            if within:
                self._differ(" ".join(filter(None, ("diff", self._words, old, new))))
            self.status = max(self.status, 1)
            self._lines(
                old, new, *(text.removesuffix("\n").split("\n") if text else [] for text in texts if text is not None)
            )
        await self.session.stdout.drain()

    async def _text(self, name: str, may_be_missing: bool) -> str | None:
        """Return what is in a file; None, with a message, if it can't be read."""
        path = self.session.cwd / name
        try:
            if name == "-":
                return await self.session.stdin.read_all()
            if may_be_missing and not deep.mode(path):
                return ""
            return await text_named(self.session, name)
        except OSError as error:
            self._problem(name, error)
            return None

    def _lines(self, old_name: str, new_name: str, old: list[str], new: list[str]) -> None:
        if "u" not in self.options and "U" not in self.options:
            self._normal(old, new)
            return
        context = int(self.options.get("U", "3")) if self.options.get("U", "3").isdigit() else 3
        for line in difflib.unified_diff(old, new, old_name, new_name, n=context, lineterm=""):
            self.session.print(line)

    def _normal(self, old: list[str], new: list[str]) -> None:
        for kind, a, b, c, d in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
            if kind == "equal":
                continue
            left = _span(a, b) if kind != "insert" else str(a)
            right = _span(c, d) if kind != "delete" else str(c)
            self.session.print(left + {"replace": "c", "insert": "a", "delete": "d"}[kind] + right)
            for line in old[a:b]:
                self.session.print(f"< {line}")
            if kind == "replace":
                self.session.print("---")
            for line in new[c:d]:
                self.session.print(f"> {line}")

    def _differ(self, text: str) -> None:
        self.session.print(text)
        self.status = max(self.status, 1)

    def _problem(self, name: str, error: OSError) -> None:
        complain(self.session, f"{name}: {reason(error)}")
        self.status = 2


def _span(first: int, end: int) -> str:
    return str(end) if end - first == 1 else f"{first + 1},{end}"
