"""Runs scripts in the machine's bash and in our shell, and compares what they print and their status.

    python -m tests.conformance.bash_lines generated [--count 5000] [--seed 32] [--show 20]
    python -m tests.conformance.bash_lines folder PATH [--show 20]
    python -m tests.conformance.bash_lines record

`generated` scripts come from `bash_grammar`; `folder` takes every file below PATH: public scripts, which never enter this
repository. Each is run as `bash FILE` in a folder of its own. What differs is one of two kinds: our shell said that it lacks
something ("refused"), or it did something else without a word ("different"), which must not happen. The counts are kept in
`bash_lines.json`. `record` writes `bash_lines.jsonl`, a sample of what bash answered to generated scripts
that need no other program, for `test_bash_lines`.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from day6_core.session.streams import Captured, InputStream
from day6_core.shell.commands import builtin
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams

SAMPLE = Path(__file__).with_name("bash_lines.jsonl")
SAMPLES = 200
REFUSAL = "bash has this, the shell of day6-tui does not"
SECONDS = 10
ARGUMENTS = ("3", "hello world", "10")
OF_ANOTHER_MACHINE = re.compile(
    r"\b(?:ros2|colcon|rosdep|rviz2|rqt\w*|sudo|apt|apt-get|pip3?|python3?|git|curl|wget|nano|vim?|code|gedit|hostname|uname|whoami|id"
    r"|nproc|lsb_release|date|sleep|ps|kill|pkill|killall|top|which|man|less|more|clear|reset|tput|xterm|watch|tree|pytest)\b"
    r"|/opt/ros/"
)
"""Commands that are simulated here, or whose answers change: a public script with one of them is left out."""
_PLACE = re.compile(r"^(?:\S*script\.sh|bash|\S*/script\.sh): (?:\S+: )?(?:line \d+: )?", re.MULTILINE)


class Answer(NamedTuple):
    """What became of a script in an empty folder, which is called HOME in the texts."""

    status: int
    out: str
    err: str


def environment(home: Path) -> dict[str, str]:
    """The environment of both shells."""
    return {
        "PATH": "/usr/bin:/bin",
        "HOME": str(home),
        "USER": "student",
        "LC_ALL": "C.UTF-8",
        "TZ": "UTC",
        "TERM": "dumb",
    }


@contextmanager
def folder_with(script: str) -> Iterator[Path]:
    """A folder with nothing but the script."""
    with tempfile.TemporaryDirectory(prefix="day6-lines-") as name:
        home = Path(name).resolve()
        (home / "script.sh").write_text(script, encoding="utf-8", errors="surrogateescape")
        yield home


def of_bash(script: str) -> Answer | None:
    """What the machine's bash answers, in a process; None if it takes too long."""
    bash = shutil.which("bash")
    assert bash is not None
    with folder_with(script) as home:
        try:
            done = subprocess.run(
                [bash, "script.sh", *ARGUMENTS], cwd=home, env=environment(home), capture_output=True, stdin=subprocess.DEVNULL,
                timeout=SECONDS, check=False,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return None
        texts = (
            data.decode("utf-8", "surrogateescape").replace(str(home), "HOME") for data in (done.stdout, done.stderr)
        )
        status = done.returncode if done.returncode >= 0 else 128 - done.returncode
        return Answer(status, *texts)


class OurShell:
    """One desk for all scripts."""

    def __init__(self) -> None:
        self.folder = tempfile.TemporaryDirectory(prefix="day6-lines-")
        home = Path(self.folder.name).resolve() / "home"
        self.desk = Desk(home, domain_id=0, join_link=False)

    def answer(self, script: str) -> Answer | None:
        """What our shell answers; None if it takes too long."""
        with folder_with(script) as home:
            shell = self.desk.shell(cwd=home, env=environment(home))
            out, err = Captured(), Captured()
            main = builtin("bash")
            assert main is not None
            program = self.desk.start_program(
                ["bash", "script.sh", *ARGUMENTS],
                main,
                Streams(InputStream(), out, err),
                env=shell.environment,
                cwd=home,
                shell=shell,
            )
            if not self.desk.scheduler.run(lambda: program.status is not None, SECONDS):
                program.kill()
                self.desk.scheduler.run(lambda: program.status is not None, SECONDS)
                return None
            assert program.status is not None
            return Answer(program.status, *(text.replace(str(home), "HOME") for text in (out.text, err.text)))

    def close(self) -> None:
        self.desk.close()
        self.folder.cleanup()


def told(real: Answer | None, ours: Answer | None, script: str) -> str:
    """The verdict, in which a script to which bash itself gives another answer another time (a die's) is `skipped`."""
    found = verdict(real, ours)
    return "skipped" if found == "different" and any(real != of_bash(script) for _ in range(5)) else found


def verdict(real: Answer | None, ours: Answer | None) -> str:
    """`same`, `refused`, `different`, or `skipped` for what the real one does not end."""
    if real is None:
        return "skipped"
    if ours is not None and REFUSAL in ours.err:
        return "refused"
    if ours is None or (real.status, real.out) != (ours.status, ours.out):
        return "different"
    return "same" if bool(real.err.strip()) == bool(ours.err.strip()) else "different"


def hashed(script: str) -> str:
    """A name for a script that does not contain it."""
    return hashlib.sha256(script.encode("utf-8", "surrogateescape")).hexdigest()[:16]


def scripts_of(options: argparse.Namespace) -> list[str]:
    """The scripts that were asked for."""
    if options.kind == "folder":
        files = sorted(path for path in Path(options.path).rglob("*") if path.is_file())
        scripts = [path.read_bytes().decode("utf-8", "surrogateescape") for path in files]
        return [script for script in scripts if OF_ANOTHER_MACHINE.search(_without_comments(script)) is None]
    from tests.conformance.bash_grammar import generated

    return [generated(options.seed * 1_000_000 + number) for number in range(options.count)]


_PROGRAMS = re.compile(
    r"(?<![.\w])(?:cat|sed|grep|sort|uniq|head|tail|wc|tr|cut|seq|awk|xargs|tac|diff|ls|bash|time|rm|RANDOM|BASHPID|nothere_cmd)\b"
)


def planted(home: Path) -> None:
    """Make the files that generated scripts begin with, without a process."""
    (home / "sub").mkdir()
    texts = {
        "one.txt": "one 1\ntwo 2\nthree 3\n",
        "two.txt": "",
        "three.py": "x\n",
        "sub/four.txt": "4\n",
        "a b.txt": "s\n",
    }
    for name, text in texts.items():
        (home / name).write_text(text, encoding="utf-8")


def without_programs(seed: int) -> str:
    """A generated script without its first line, which makes its files; '' if it needs other programs than the shell."""
    from tests.conformance.bash_grammar import generated

    script = generated(seed).partition("\n")[2]
    return "" if _PROGRAMS.search(script) else script


def record(seed: int) -> None:
    """Write the sample."""
    from tests.conformance.bash_grammar import generated

    number, lines = seed * 1_000_000, []
    while len(lines) < SAMPLES:
        number += 1
        script = without_programs(number)
        if not script:
            continue
        answer = of_bash(f"{generated(number).partition(chr(10))[0]}\n{script}")
        if answer is not None and "script.sh" not in answer.out:
            kept = {"seed": number, "script": hashed(script), "status": answer.status, "out": answer.out}
            lines.append(json.dumps({**kept, "err": bool(answer.err.strip())}, ensure_ascii=False))
    SAMPLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _without_comments(script: str) -> str:
    return re.sub(r"(?m)^\s*#.*", "", script)


def show(number: int, script: str, real: Answer | None, ours: Answer | None) -> None:
    """Print one difference."""
    print(f"--- {number} ---\n{script}"[:3000])
    for name, answer in (("bash", real), ("ours", ours)):
        print(f"  {name}: {answer!r}"[:1200])


def main() -> None:
    """Run, and print what differs and the counts."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("kind", choices=["generated", "folder", "record"])
    parser.add_argument("path", nargs="?")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=32)
    parser.add_argument("--show", type=int, default=20, help="how many differences are printed")
    parser.add_argument("--refusals", action="store_true", help="print those that were refused")
    options = parser.parse_args()
    os.environ["DAY6_LINK"] = "off"
    if options.kind == "record":
        record(options.seed)
        return
    ours, counts, shown = OurShell(), {"same": 0, "refused": 0, "different": 0, "skipped": 0}, 0
    for number, script in enumerate(scripts_of(options)):
        real, mine = of_bash(script), ours.answer(script)
        found = told(real, mine, script)
        counts[found] += 1
        if (found == "different" or (options.refusals and found == "refused")) and shown < options.show:
            shown += 1
            show(number, script, real, mine)
    ours.close()
    print(counts)


if __name__ == "__main__":
    main()
