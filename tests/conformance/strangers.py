"""Plays the programs of strangers' public repositories with our rclpy and with a real one, and counts where they do the same.

    python -m tests.conformance.strangers --sources FOLDER --real PYTHON [--clone] [--show] [--jobs 2] [WORD…]

`strangers.json` names the repositories at fixed commits; FOLDER has checkouts of them (see `checkouts.py`; `--clone` fetches
what is missing). A WORD chooses programs by a part of `owner/name/path`. `--show` prints what differs.

A program is a Python file, below no folder of tests or of a build's results, that imports rclpy and can be started (`if __name__`
or `main`), and that imports nothing but modules of its own package, rclpy, the messages of a real installation, numpy, and what
of Python's library touches no files, processes or networks. What is outside that is left out and counted. Each program is played
twice, alone in a domain of its own: as it is, and in a namespace; some seconds after rclpy is imported and it printed something
it gets Ctrl-C.

It wants a machine with nothing else to do: where a real node takes seconds to come up, Ctrl-C meets the two at different places.
Random numbers begin with the same seed. Both sides do the same when the exit status is equal, and so is all they print, but for:
times, addresses and paths; how often a program that repeats itself came to print until Ctrl-C; Python's frames inside rclpy.
"""

from __future__ import annotations

import argparse
import ast
import difflib
import json
import os
import re
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from day6_core.ros.environment import PYTHON_PATH, program_environment
from tests.conformance.checkouts import Missing, extract
from tests.conformance.played import ROOT, SITE, Outcome, comparable

INPUTS = Path(__file__).with_suffix(".json")
_OF_PYTHON = """
__future__ abc argparse array asyncio collections concurrent copy dataclasses datetime decimal enum fractions functools heapq
itertools json logging math numbers operator queue random re statistics string struct sys textwrap threading time traceback
typing unittest uuid warnings
"""
_OF_ROS = """
rclpy rosidl_runtime_py numpy action_msgs actionlib_msgs builtin_interfaces diagnostic_msgs geometry_msgs lifecycle_msgs nav_msgs
rcl_interfaces rosgraph_msgs sensor_msgs service_msgs shape_msgs std_msgs std_srvs stereo_msgs test_msgs trajectory_msgs
type_description_interfaces unique_identifier_msgs visualization_msgs
"""
HARMLESS = frozenset((_OF_PYTHON + _OF_ROS).split())
SCENARIOS: dict[str, list[str]] = {"alone": [], "in a namespace": ["--ros-args", "-r", "__ns:=/far/away"]}
IMPORTS_S = 60.0
"""Until rclpy is imported; a real one takes many seconds on a machine that is busy."""
FIRST_WORD_S = 3.5
"""A program that then prints nothing for so long is taken to be up."""
RUNS_S = 2.0
"""From the first word to Ctrl-C."""
ENDS_S = 6.0
"""From Ctrl-C to SIGKILL."""
ATTEMPTS = 3
"""Ctrl-C comes at a chance moment of a program: one pair of runs that is equal is enough."""


START = """
import os, random, runpy, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored by what a shell starts in the background
import rclpy.node
random.seed(7)
os.close(int(sys.argv.pop(1)))  # tells that it is imported
if sys.argv[1] == "-m":
    del sys.argv[:2]
    __import__(sys.argv[0])
    sys.modules[sys.argv[0]].main()
else:
    del sys.argv[0]
    sys.path[0] = os.path.dirname(sys.argv[0])
    runpy.run_path(sys.argv[0], run_name="__main__")
"""
"""Starts a program as `python FILE` does, or by its main as an executable of its package does."""


@dataclass(frozen=True)
class Program:
    """A program of a stranger: `path` in its repository, `folder` where its package is imported from."""

    repository: str
    path: str
    folder: Path
    module: str
    guarded: bool

    @property
    def name(self) -> str:
        return f"{self.repository}/{self.path}"


# -- which programs ----------------------------------------------------------------------------------------------------


def programs(repository: str, tree: Path) -> tuple[list[Program], int]:
    """Return the programs of a repository that can be compared, and how many use something that cannot."""
    found: list[Program] = []
    left_out = 0
    for file in sorted(tree.rglob("*.py")):
        inside = file.relative_to(tree)
        if (
            {"test", "tests", "launch", "build", "install"} & set(inside.parts[:-1])
            or not file.is_file()
            or file.is_symlink()
        ):
            continue
        try:
            syntax = ast.parse(file.read_text(encoding="utf-8"))
        except (SyntaxError, ValueError):
            continue
        used = set(_imported(syntax))
        guarded = any(isinstance(each, ast.If) and "__name__" in ast.unparse(each.test) for each in syntax.body)
        has_main = any(isinstance(each, ast.FunctionDef) and each.name == "main" for each in syntax.body)
        if "rclpy" not in used or not (guarded or has_main):
            continue
        folder = _package_root(file, tree)
        own = {each.stem for each in (*folder.iterdir(), *file.parent.iterdir())}
        if used - HARMLESS - own or "open" in _called(syntax):
            left_out += 1
            continue
        module = ".".join(file.relative_to(folder).with_suffix("").parts)
        found.append(Program(repository, inside.as_posix(), folder, module, guarded))
    return found, left_out


def _imported(syntax: ast.Module) -> Iterator[str]:
    for each in ast.walk(syntax):
        if isinstance(each, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in each.names)
        elif isinstance(each, ast.ImportFrom) and each.module and not each.level:
            yield each.module.partition(".")[0]


def _called(syntax: ast.Module) -> set[str]:
    return {each.func.id for each in ast.walk(syntax) if isinstance(each, ast.Call) and isinstance(each.func, ast.Name)}


def _package_root(file: Path, tree: Path) -> Path:
    for folder in file.parents:
        if folder == tree or (folder / "package.xml").is_file():
            return folder
    return file.parent


# -- playing -----------------------------------------------------------------------------------------------------------


def play(program: Program, arguments: list[str], real: str | None, domain: int) -> Outcome:
    """Run a program with our rclpy or that of the interpreter `real`, interrupt it, and return what is comparable."""
    with tempfile.TemporaryDirectory() as place:
        env = dict(os.environ) if real is not None else program_environment()
        for name in ("COLUMNS", "RCUTILS_CONSOLE_OUTPUT_FORMAT", "PYTHONPATH" if real is not None else ""):
            env.pop(name, None)
        env.update(LANG="C.UTF-8", DAY6_LINK="off", PYTHONDONTWRITEBYTECODE="1", PYTHONUNBUFFERED="1", HOME=place)
        env.update(ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST", ROS_PYTHON_CHECK_FIELDS="1", ROS_DOMAIN_ID=str(domain))
        paths = [str(program.folder), *filter(None, [env.get("PYTHONPATH")])]
        env["PYTHONPATH"] = os.pathsep.join(paths)
        file = program.folder / Path(*program.module.split(".")).with_suffix(".py")
        start = [str(file)] if program.guarded else ["-m", program.module]
        imported, tells = os.pipe()
        process = subprocess.Popen(
            [real or sys.executable, "-c", START, str(tells), *start, *arguments],
            cwd=place,
            env=env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            pass_fds=[tells],
        )
        os.close(tells)
        select.select([imported], [], [], IMPORTS_S)
        os.close(imported)
        texts = _interrupted(process)
    site = str(PYTHON_PATH) if real is None else str(Path(real).absolute().parents[1] / "lib/python3.11/site-packages")
    for path, shown in ((site, SITE), (str(ROOT), SITE), (str(program.folder), "<PACKAGE>"), (place, "<CWD>")):
        texts = [text.replace(path, shown) for text in texts]
    return comparable(Outcome(texts[0], texts[1], process.returncode))


def _interrupted(process: subprocess.Popen[bytes]) -> list[str]:
    """Read what a process writes; send Ctrl-C some time after its first word, SIGKILL when it does not end."""
    assert process.stdout is not None and process.stderr is not None
    pipes = {process.stdout.fileno(): 0, process.stderr.fileno(): 1}
    texts = [bytearray(), bytearray()]
    began = time.monotonic()
    signals = [(began + FIRST_WORD_S + RUNS_S, signal.SIGINT)]
    while pipes:
        now = time.monotonic()
        if signals and now >= signals[0][0]:
            number = signals.pop(0)[1]
            process.send_signal(number)
            if number == signal.SIGINT:
                signals.append((now + ENDS_S, signal.SIGKILL))
        for pipe in select.select(list(pipes), [], [], 0.05)[0]:
            chunk = os.read(pipe, 65536)
            if not chunk:
                del pipes[pipe]
            elif not any(texts):
                signals[:1] = [(time.monotonic() + RUNS_S, signal.SIGINT)]
            if sum(map(len, texts)) < 1_000_000:
                texts[pipes.get(pipe, 0)] += chunk
    process.wait()
    return [bytes(text).decode(errors="replace") for text in texts]


# -- comparing ---------------------------------------------------------------------------------------------------------

_LOG = re.compile(r"\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[<TIME>\] ")
_NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
_ADDRESS = re.compile(r"0x[0-9a-fA-F]+")


def difference(real: Outcome, ours: Outcome) -> list[str]:
    """Return what differs as lines, none if both sides do the same."""
    lines = [] if real.exit_code == ours.exit_code else [f"exit status {real.exit_code}, ours {ours.exit_code}"]
    for what, one, other in (
        ("stdout", real.stdout.splitlines(), ours.stdout.splitlines()),
        ("logs", _logs(real.stderr), _logs(ours.stderr)),
        ("stderr", _rest(real.stderr), _rest(ours.stderr)),
    ):
        if not same_course(one, other):
            lines += difflib.unified_diff(
                one[:60], other[:60], f"{what} of real rclpy", f"{what} of ours", lineterm="", n=1
            )
    return lines


def _logs(text: str) -> list[str]:
    return [line for line in text.splitlines() if _LOG.match(line)]


def _rest(text: str) -> list[str]:
    return [line for line in text.splitlines() if not _LOG.match(line)]


def same_course(one: list[str], other: list[str]) -> bool:
    """Say whether two outputs are equal, or the shorter one is the longer one's before it repeated itself some more.

    What follows the repetition (a word of farewell) must be equal too.
    """
    if one == other:
        return True
    short, long = sorted((one, other), key=len)
    begin = _common(short, long)
    end = min(_common(short[::-1], long[::-1]), len(short) - begin)
    if begin + end < len(short):
        return False
    shapes = [_NUMBER.sub("N", line) for line in long]
    # The lines that only the longer one has are of kinds that came before.
    return begin > 0 and set(shapes[begin : len(long) - end]) <= set(shapes[:begin])


def _common(one: list[str], other: list[str]) -> int:
    return next((n for n, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


def main() -> int:
    """Play everything and print a line for each repository."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, required=True, help="folder with checkouts")
    parser.add_argument("--clone", action="store_true", help="clone what is missing there")
    parser.add_argument("--real", metavar="PYTHON", required=True, help="interpreter with real rclpy")
    parser.add_argument("--show", action="store_true", help="print what differs")
    parser.add_argument("--jobs", type=int, default=2, help="programs at a time")
    parser.add_argument("words", nargs="*", help="parts of names of programs (default: all)")
    chosen = parser.parse_args()
    inputs = json.loads(INPUTS.read_text(encoding="utf-8"))
    known: Mapping[str, str] = inputs["known"]
    domains: SimpleQueue[int] = SimpleQueue()
    for number in range(chosen.jobs):
        domains.put(20 + number)

    def both(program: Program, scenario: str) -> list[str]:
        domain = domains.get()
        try:
            for _ in range(ATTEMPTS):
                real = play(program, SCENARIOS[scenario], chosen.real, domain)
                lines = difference(real, play(program, SCENARIOS[scenario], None, domain))
                if not lines:
                    break
            return lines
        finally:
            domains.put(domain)

    equal: Counter[str] = Counter()
    total: Counter[str] = Counter()
    left_out = 0
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(chosen.jobs) as pool:
        for number, each in enumerate(inputs["repositories"]):
            repository = each["repository"]
            try:
                tree = extract(repository, each["commit"], chosen.sources, Path(name) / str(number), clone=chosen.clone)
            except Missing as error:
                print(f"-- {error}", flush=True)
                continue
            found, without = programs(repository, tree)
            left_out += without
            wanted = [one for one in found if not chosen.words or any(word in one.name for word in chosen.words)]
            played = [(one, scenario, pool.submit(both, one, scenario)) for one in wanted for scenario in SCENARIOS]
            for program, scenario, done in played:
                lines = done.result()
                total[repository] += 1
                equal[repository] += not lines
                if lines:
                    reason = next((known[key] for key in known if program.name.startswith(key)), "not explained")
                    print(f"!= {program.name}, {scenario}: {reason}")
                    print(*(lines if chosen.show else ()), sep="\n   ", flush=True)
            if played:
                print(f"{equal[repository]:4}/{total[repository]:<4} {repository} at {each['commit'][:10]}", flush=True)
    count = sum(1 for repository in total if total[repository])
    print(f"{sum(equal.values())} of {sum(total.values())} scenarios equal, from {count} repositories")
    print(f"{left_out} programs left out: they import what is not part of both")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
