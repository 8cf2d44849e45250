"""Runs random command lines in the simulated shell and in real bash, each in a tree of its own, and compares the trees.

    python -m tests.perf.shell_against_bash [LINES] [SEED]

Both trees begin alike. After every few lines names, kinds, contents, modes and targets of links must be the same; the first
difference is shown with its seed and the lines that led to it.
"""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

NAMES = [
    "a",
    "b",
    "c.txt",
    "d e",
    "sub",
    "sub/x",
    "sub/y",
    "deep/er/z",
    "link",
    "hard",
    "new",
    "none/x",
    "sub/",
    ".",
    "-n",
]
CONTENTS = [b"one\ntwo\n", b"", b"no end", b"a\r\nb\r\n", b"caf\xe9\n", "轮\u2028子\x0c\n".encode(), bytes(range(256))]
LINES_IN_A_SCRIPT = 10


def plant(folder: Path, rng: random.Random) -> None:
    """Make the tree that both begin with."""
    (folder / "sub").mkdir(parents=True)
    (folder / "deep" / "er").mkdir(parents=True)
    for name in ("a", "b", "c.txt", "d e", "sub/x", "deep/er/z"):
        (folder / name).write_bytes(rng.choice(CONTENTS))
    (folder / "link").symlink_to(rng.choice(["a", "sub", "nowhere", "c.txt"]))
    os.link(folder / "b", folder / "hard")


def a_line(rng: random.Random) -> str:
    """Return a command line that changes files."""

    def name() -> str:
        word = rng.choice(NAMES)
        return f"./{word}" if word.startswith("-") else f"'{word}'" if " " in word else word

    first, second, third = name(), name(), name()
    if first in (second, third):  # what two processes do to one file at once is chance
        third = "other"
        second = "another"
    return rng.choice(
        [
            f"echo hello > {first}",
            f"echo more >> {first}",
            f"printf 'x\\ny' > {first} 2> {second}",
            f"cat {first} > {second}",
            f"cat {first} {second} >> {third}",
            f"cat {first} | tee {second} > {third}",
            f"test -d {first} || cat < {first} > {second}",
            f"test -d {second} || tee -a {first} < {second} > /dev/null",
            f"cp {first} {second}",
            f"cp -r {first} {second}",
            f"cp -a {first} {second}",
            f"cp -n {first} {second}",
            f"cp {first} {second} {third}",
            f"mv {first} {second}",
            f"mv -n {first} {second}",
            f"mv {first} {second} {third}",
            f"rm {first}",
            f"rm -f {first} {second}",
            f"rm -r {first}",
            f"rm -rf {first}",
            f"rmdir {first}",
            f"mkdir {first}",
            f"mkdir -p {first}/k",
            f"touch {first} {second}",
            f"ln -s {first} {second}",
            f"ln {first} {second}",
            f"ln -sf {first} {second}",
            f"sed -i s/o/0/ {first}",
            f"sed -i 1d {first} {second}",
            f"sed s/o/0/ {first} > {second}",
            f"sort {first} -o {second}",
            f"head -n 1 {first} > {second}",
            f"tail -n 1 {first} > {second}",
            f"grep -av zzz {first} > {second}",
            f"chmod {rng.choice(['600', '755', 'u+x', '-w'])} {first}",
            f"{{ cat {first}; echo a; }} > {second} 2>&1",
            f"(cd sub && echo in > {first})",
            f"for f in *; do echo $f; done > {first}",
            f"echo x > {first} && mv {first} {second} || rm -f {third}",
            f"cat {first} > /dev/stdout > {second}",
            f": > {first}",
            f"test -s {first} && cp {first} {second}.bak",
            f"cat <<X > {first}\nhere $HOME_NOT\nX",
            f"ls -1 > {first} 2> /dev/null",
            f"find . -name '*.txt' > {first}",
            f"test -d {first} || wc -l < {first} > {second}",
        ]
    )


def picture(folder: Path) -> dict[str, object]:
    """Return what lies in `folder`, comparable."""
    found: dict[str, object] = {}
    for here, folders, files in os.walk(folder):
        for each in (*folders, *files):
            path = Path(here, each)
            shown = str(path.relative_to(folder))
            status = path.lstat()
            if path.is_symlink():
                found[shown] = ("link", os.readlink(path))
            elif path.is_dir():
                found[shown] = ("folder", oct(status.st_mode & 0o7777))
            else:
                found[shown] = ("file", oct(status.st_mode & 0o7777), status.st_nlink, path.read_bytes())
    return found


def differences(seed: int, lines: int = LINES_IN_A_SCRIPT) -> list[str]:
    """Run one script in both; return what differs, one entry a line, [] for nothing."""
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="day6-trees-") as base:
        ours, real = Path(base, "o", "t"), Path(base, "r", "t")
        plant(ours, random.Random(seed))
        plant(real, random.Random(seed))
        script = [a_line(rng) for _ in range(lines)]
        environment = {**os.environ, "DAY6_LINK": "off", "LC_ALL": "C.UTF-8"}
        bash = shutil.which("bash")
        assert bash is not None
        text = "\n".join(script)
        quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        subprocess.run([bash, "-c", text], cwd=real, env=environment, timeout=60, check=False, **quiet)
        words = [sys.executable, "-m", "day6_tui.main", "exec", "--home", base, "-c", text]
        subprocess.run(words, cwd=ours, env=environment, timeout=60, check=False, **quiet)
        mine, theirs = picture(ours), picture(real)
        if mine == theirs:
            return []
        told = [f"seed {seed}", *script]
        for shown in sorted({*mine, *theirs}):
            if mine.get(shown) != theirs.get(shown):
                told.append(f"  {shown}: here {mine.get(shown)!r}, bash {theirs.get(shown)!r}")
        return told


def main() -> None:
    """Run as many lines as asked for, and show every difference."""
    lines = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    bad = 0
    for seed in range(first, first + lines // LINES_IN_A_SCRIPT):
        found = differences(seed)
        if found:
            bad += 1
            print("\n".join(found), flush=True)
    print(f"{lines} lines, {bad} scripts with a difference")


if __name__ == "__main__":
    main()
