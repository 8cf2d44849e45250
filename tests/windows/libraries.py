"""Unpacks the libraries of a Python for Windows from panda3d's wheel, for `run`: libraries.py WHEEL PYTHON BUILT.

PYTHON gets them as an installation has them, BUILT the definitions from which python.exe and python3.dll are linked.
"""

from __future__ import annotations

import struct
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path


def exports(library: bytes) -> Iterator[str]:
    """Yield the names that a 64-bit library of Windows exports."""

    def number(place: int, kind: str = "I") -> int:
        return int(struct.unpack_from(f"<{kind}", library, place)[0])

    header = number(0x3C)
    table = header + 24 + number(header + 20, "H")
    sections = [struct.unpack_from("<IIII", library, table + 40 * n + 8) for n in range(number(header + 6, "H"))]

    def place(address: int) -> int:
        return next(raw + address - start for size, start, _, raw in sections if start <= address < start + size)

    directory = place(number(header + 24 + 112))
    names = place(number(directory + 32))
    for index in range(number(directory + 24)):
        start = place(number(names + 4 * index))
        yield library[start : library.index(b"\0", start)].decode()


def main(wheel: str, python: str, built: str) -> None:
    """Write them."""
    with zipfile.ZipFile(wheel) as packed:
        for name in packed.namelist():
            folder, _, file = name.lower().rpartition("/")
            # Wine has the first of its own, and cannot bear the second.
            if folder != "deploy_libs" or file.startswith("api-ms-") or file == "_wmi.pyd":
                continue
            beside = file.startswith(("python3", "vcruntime"))
            Path(python, "" if beside else "DLLs", file).write_bytes(packed.read(name))
    names = list(exports(Path(python, "python312.dll").read_bytes()))
    for library, entry in (("python312", "{0}"), ("python3", "{0} = python312.{0}")):
        lines = [f"LIBRARY {library}.dll", "EXPORTS", *map(entry.format, names)]
        Path(built, f"{library}.def").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
