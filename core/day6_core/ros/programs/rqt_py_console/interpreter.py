"""The Python behind the console of rqt: a program of its own, run as a file, which reads its lines from a pipe.

As the real one it is the interpreter of the module `code`, whose tracebacks name the file `<input>`. All that is printed goes
into one stream, so that it arrives in its order; marks in it say what is an error's and when a line is awaited.
"""

from __future__ import annotations

import code
import io
import os
import signal
import sys
import types

AWAITS = "\x05"
"""ENQ: a line is read now; what stands before it, back to the last newline, is the prompt."""

ERROR, PLAIN = "\x0e", "\x0f"
"""SO, SI: around what is written to `sys.stderr`."""


class Input(io.TextIOBase):
    """`sys.stdin`, which tells when it is read."""

    def __init__(self, source: io.TextIOBase, marks: io.TextIOBase) -> None:
        self._source, self._marks = source, marks

    def fileno(self) -> int:
        return self._source.fileno()

    def readable(self) -> bool:
        return True

    def readline(self, size: int | None = -1, /) -> str:  # type: ignore[override]  # typeshed: io.IOBase's is of bytes
        self._marks.write(AWAITS)
        return self._source.readline(-1 if size is None else size)

    def read(self, size: int | None = -1, /) -> str:
        self._marks.write(AWAITS)
        return self._source.read(size)


class Errors(io.TextIOBase):
    """`sys.stderr`, marked as such in the stream of everything."""

    def __init__(self, target: io.TextIOBase) -> None:
        self._target = target

    def fileno(self) -> int:
        return 2

    def writable(self) -> bool:
        return True

    def write(self, text: str, /) -> int:
        self._target.write(f"{ERROR}{text}{PLAIN}")
        return len(text)

    def flush(self) -> None:
        self._target.flush()


def main() -> None:
    os.dup2(1, 2)  # what is not Python's, like a crash, comes in its order, too
    source, target = sys.stdin, sys.stdout
    assert isinstance(source, io.TextIOBase) and isinstance(target, io.TextIOBase)
    sys.stdin, sys.stderr = Input(source, target), Errors(target)
    if sys.platform == "win32":
        signal.signal(signal.SIGBREAK, signal.default_int_handler)
    if sys.path and sys.path[0] == os.path.dirname(os.path.abspath(__file__)):
        sys.path[0] = ""  # the folder one is in, as for an interpreter without a file
    sys.argv = [""]
    program = sys.modules["__main__"] = types.ModuleType("__main__")
    print(f"Python {sys.version} on {sys.platform}".replace("\n", ""))
    code.InteractiveConsole(program.__dict__, "<input>").interact("", "")


if __name__ == "__main__":
    main()
