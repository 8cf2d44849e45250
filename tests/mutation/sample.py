"""Plants faults by chance in a part of day6-tui and prints the share that the tests of the same folder catch.

    python -m tests.mutation.sample [--parts rclpy,graph,…] [--number 50] [--seed 1] [--jobs 2]

The faults (mutants) are those of cosmic-ray (an operator, a comparison, a number, a condition, a loop, an exception changed),
and a few more that people make: a call forgotten, min for max, any for all. A part's places are all equally likely, whatever
can be done at them. Every mutant is planted in a copy of the checkout, which has an environment of its own; the tests that run
its line come first, then the rest of the folder: those of the default layer, and if these do not notice, all. A run that takes
far too long counts as caught.

Survivors are printed as they would be typed. One that changes nothing that can be observed is entered, with the reason, into
`equivalent.json` beside this file, and counted apart from then on. Started by hand, on Linux or macOS, with the extra `mutation`.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import itertools
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import time
import venv
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

import parso
from cosmic_ray.ast import ast_nodes
from cosmic_ray.mutating import MutationVisitor
from cosmic_ray.operators.provider import OperatorProvider

from tests.support import one_process

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Where the sources of a part are, and the folder of its tests.
PARTS = {
    "graph": ("core/day6_core/graph", "tests/graph"),
    "link": ("core/day6_core/link", "tests/link"),
    "rclpy": ("core/day6_core/ros/python/rclpy", "tests/rclpy"),
    "ros2": ("core/day6_core/ros/ros2", "tests/ros2"),
    "shell": ("core/day6_core/shell", "tests/shell"),
    "urdf": ("urdf/day6_urdf", "tests/urdf"),
}
NONE_PLAYED = 5  # a status of pytest
OPERATORS = OperatorProvider()
# These two need to be told which variable. Whether `is` or `==` stands there (ReplaceComparisonOperator_…_Is…) changes nothing
# for None, small numbers and members of enumerations.
NEED_ARGUMENTS = {"VariableReplacer", "VariableInserter"}
# Conditions whose branches no run on Linux sees.
ELSEWHERE = ("TYPE_CHECKING", "win32", "darwin")
PARTNERS = {"min": "max", "max": "min", "any": "all", "all": "any"}


@dataclass(frozen=True)
class Mutant:
    """One fault: in which file (relative to the checkout), which line, the whole text that the file would then have."""

    file: str
    line: int
    operator: str
    before: str  # the line as it is
    after: str  # what becomes of it
    text: str

    def listed(self, entry: dict[str, str]) -> bool:
        """Return whether an entry of `equivalent.json` speaks of this mutant."""
        return (entry["file"], entry["before"], entry["after"]) == (self.file, self.before, self.after)


@dataclass(frozen=True)
class Site:
    """A place of a file at which something can be changed, and the ways to change it: operator's name and occurrence."""

    line: int
    ways: tuple[tuple[str, int], ...]


Span = tuple[tuple[int, int], tuple[int, int]]


def span(node: ast.expr | ast.stmt) -> Span:
    return (node.lineno, node.col_offset), (node.end_lineno or 0, node.end_col_offset or 0)


def unobserved(node: ast.AST) -> Iterator[Span]:
    """Yield what of a node only type checkers read, only other systems run, or only a subclass replaces."""
    if isinstance(node, (ast.arg, ast.AnnAssign)) and node.annotation is not None:
        yield span(node.annotation)
    elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
        if node.returns is not None:
            yield span(node.returns)
        if any("overload" in ast.unparse(decorator) for decorator in node.decorator_list):
            yield span(node)
            yield from map(span, node.decorator_list)
    elif isinstance(node, ast.ClassDef):
        yield from map(span, node.decorator_list)  # @dataclass(frozen=True, slots=True) and the like
        yield from (span(keyword.value) for keyword in node.keywords if keyword.arg == "total")  # of a TypedDict
        if any("Protocol" in ast.unparse(base) for base in node.bases):
            yield span(node)
    elif (
        (isinstance(node, ast.If) and any(word in ast.unparse(node.test) for word in ELSEWHERE))
        or (isinstance(node, ast.Raise) and "NotImplementedError" in ast.unparse(node))
        or (isinstance(node, ast.Call) and ast.unparse(node.func).endswith(("TypeVar", "cast", "ParamSpec")))
    ):
        yield span(node)


def forgotten(tree: ast.Module) -> Iterator[ast.stmt]:
    """Yield the statements that a person might forget: calls, additions, errors."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.AugAssign, ast.Raise, ast.Delete)) or (
            isinstance(node, ast.Expr) and isinstance(node.value, (ast.Call, ast.Await))
        ):
            yield node


def confused(tree: ast.Module) -> Iterator[ast.Name]:
    """Yield the names that have a partner people confuse them with."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in PARTNERS:
            yield node.func


def sites(text: str) -> list[Site]:
    """Return every place of a module at which something can be changed."""
    tree = ast.parse(text)
    skipped = [found for node in ast.walk(tree) for found in unobserved(node)]
    ways: dict[tuple[tuple[int, int], str], list[tuple[str, int]]] = {}

    def add(where: tuple[int, int], family: str, name: str, occurrence: int) -> None:
        if not any(start <= where < end for start, end in skipped):
            ways.setdefault((where, family), []).append((name, occurrence))

    nodes = list(ast_nodes(parso.parse(text)))
    for name in OPERATORS:
        if name not in NEED_ARGUMENTS and "_Is" not in name:
            positions = [at for node in nodes for at in OPERATORS[name]().mutation_positions(node)]
            for occurrence, (start, _) in enumerate(positions):
                add(start, name.partition("_")[0], name, occurrence)
    for occurrence, statement in enumerate(forgotten(tree)):
        add(span(statement)[0], "Forget", "Forget", occurrence)
    for occurrence, called in enumerate(confused(tree)):
        add(span(called)[0], "Confuse", "Confuse", occurrence)
    return [Site(where[0], tuple(found)) for (where, _), found in sorted(ways.items())]


def replaced(text: str, node: ast.expr | ast.stmt, new: str) -> str:
    """Return a text with another one in place of a node, whose columns are counted in UTF-8."""
    lines = text.encode().splitlines(keepends=True)
    (first, left), (last, right) = span(node)
    body = lines[first - 1][:left] + new.encode() + lines[last - 1][right:]
    return b"".join([*lines[: first - 1], body, *lines[last:]]).decode()


def changed(text: str, way: tuple[str, int]) -> str | None:
    """Return a module's text after one change, None when there is none to make."""
    name, occurrence = way
    tree = ast.parse(text)
    if name == "Forget":
        return replaced(text, list(forgotten(tree))[occurrence], "pass")
    if name == "Confuse":
        called = list(confused(tree))[occurrence]
        return replaced(text, called, PARTNERS[called.id])
    visitor = MutationVisitor(occurrence, OPERATORS[name]())
    code = visitor.walk(parso.parse(text))
    return code.get_code() if visitor.mutation_applied else None


def mutant_of(file: str, text: str, site: Site, way: tuple[str, int]) -> Mutant | None:
    """Return the fault that one way makes, None when Python could not even read it or nothing changes."""
    after = changed(text, way)
    try:
        if after is None or ast.dump(ast.parse(after)) == ast.dump(ast.parse(text)):
            return None
    except SyntaxError:
        return None
    old, new = text.splitlines(), after.splitlines()
    at = next(
        (i for i, (one, other) in enumerate(zip(old, new, strict=False)) if one != other), min(len(old), len(new)) - 1
    )
    return Mutant(file, site.line, way[0], old[at].strip(), new[at].strip(), after)


def sampled(part: str, number: int, seed: int) -> list[Mutant]:
    """Return mutants of a part, each at a place of its own. The same seed gives the same ones while the sources stay."""
    chance = random.Random(f"{part} {seed}")
    folder = ROOT / PARTS[part][0]
    texts = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.py"))}
    places = [(file, site) for file, text in texts.items() for site in sites(text)]
    chance.shuffle(places)
    found: list[Mutant] = []
    for file, site in places:
        if len(found) == number:
            break
        mutant = mutant_of(file, texts[file], site, chance.choice(site.ways))
        if mutant is not None:
            found.append(mutant)
    return found


class Copy:
    """A copy of the checkout in which a mutant can be planted without touching what anybody works on."""

    def __init__(self, folder: Path) -> None:
        self._root = folder / "checkout"
        listed = subprocess.run(
            ["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, stdout=subprocess.PIPE, check=True
        )
        for name in filter(None, listed.stdout.decode().split("\0")):
            if (ROOT / name).is_file():
                (self._root / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, self._root / name)
        venv.create(self._root / ".venv", symlinks=True)
        self._python = self._root / ".venv" / "bin" / "python"
        packages = subprocess.run(
            [str(self._python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
            stdout=subprocess.PIPE, text=True, check=True,
        ).stdout.strip()  # fmt: skip
        # A folder named in a .pth file is not searched for further ones: what makes the real checkout importable stays out.
        ours = (self._root / name for name in ("core", "tui", "urdf", "tests/mutation"))
        paths = (*ours, sysconfig.get_path("purelib"))
        (Path(packages) / "copy.pth").write_text("".join(f"{path}\n" for path in paths), encoding="utf-8")
        self._stamp = time.time()

    def tests(self, *arguments: str, timeout: float | None = None, **env: str) -> bool:
        """Run pytest with these arguments and return whether all passed; too late is not."""
        command = [
            str(self._python),
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            "-o",
            "addopts=--import-mode=importlib",
        ]
        process = subprocess.Popen(
            [*command, *arguments], cwd=self._root, env={**os.environ, **env},
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
        )  # fmt: skip
        try:
            return process.wait(timeout) in (0, NONE_PLAYED)
        except subprocess.TimeoutExpired:
            return False
        finally:
            end_group(process)

    def plant(self, file: str, text: str) -> None:
        """Write a file's text, with a time of its own: Python compares whole seconds to find out whether a file is new."""
        self._stamp += 2
        path = self._root / file
        path.write_text(text, encoding="utf-8", newline="")
        os.utime(path, (self._stamp, self._stamp))


def end_group(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError):  # it has ended, and so have all that it started
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


LAYERS = {"default layer": (), "whole": ("-m", " or ".join(one_process.LAYERS))}
"""What tells pytest which tests to play; those of the second come after those of the first."""


@dataclass
class Lines:
    """Which tests of a layer run which line of a part, and how long each takes."""

    layer: str
    tests: dict[str, dict[int, list[str]]]
    seconds: dict[str, float]
    failing: list[str]
    """Tests that fail without any mutant: those that count what is loaded, or measure time, while lines are watched."""

    def running(self, mutant: Mutant) -> list[str]:
        """Return the tests that run a mutant's line, quickest first."""
        found = set(self.tests.get(mutant.file, {}).get(mutant.line, [])) - set(self.failing)
        return sorted(found, key=lambda test: self.seconds.get(test, 0.0))


def mapped(copy: Copy, part: str, layer: str, folder: Path) -> Lines:
    """Run a part's tests of a layer once and return which lines each of them runs.

    Raises:
        SystemExit: more than a few of them fail without any mutant.
    """
    source, tests = PARTS[part]
    out = folder / f"{part} {layer}.json"
    copy.tests(
        *LAYERS[layer], tests, "-p", "lines_of_tests", "--maxfail=6", MUTATION_SOURCE=source, MUTATION_OUT=str(out)
    )
    data = json.loads(out.read_text(encoding="utf-8"))
    if len(data["failed"]) > 5:
        sys.exit(f"{tests} fails as it is: {', '.join(data['failed'])}")
    by_file = {file: {int(line): names for line, names in lines.items()} for file, lines in data["lines"].items()}
    return Lines(layer, by_file, data["seconds"], data["failed"])


def caught(copy: Copy, mutant: Mutant, lines: Lines, tests: str) -> bool:
    """Plant a mutant, run the tests, take it out again; return whether one of them noticed."""
    original = (ROOT / mutant.file).read_text(encoding="utf-8")
    copy.plant(mutant.file, mutant.text)
    try:
        first = lines.running(mutant)
        patience = 60 + 3 * sum(lines.seconds.get(test, 0.0) for test in first)
        if first and not copy.tests("-x", *first, timeout=patience):
            return True
        known = [*lines.failing, *(first if len(first) < 1000 else ())]
        others = [option for test in known for option in ("--deselect", test)]
        return not copy.tests("-x", *LAYERS[lines.layer], tests, *others, timeout=60 + 3 * sum(lines.seconds.values()))
    finally:
        copy.plant(mutant.file, original)


def measure(part: str, options: argparse.Namespace, copies: list[Copy], folder: Path) -> Counter[str]:
    """Print a part's survivors and count the mutants: by the layer that caught them, "survived", "equivalent"."""
    mutants = sampled(part, options.number, options.seed)
    with ThreadPoolExecutor(len(copies)) as workers:
        maps = list(workers.map(lambda copy, layer: mapped(copy, part, layer, folder), itertools.cycle(copies), LAYERS))
    known = json.loads((HERE / "equivalent.json").read_text(encoding="utf-8"))
    free: SimpleQueue[Copy] = SimpleQueue()
    for copy in copies:
        free.put(copy)

    def outcome(mutant: Mutant) -> str:
        reason = next((entry["reason"] for entry in known if mutant.listed(entry)), None)
        if reason is not None:
            return f"equivalent: {reason}"
        copy = free.get()
        try:
            return next((lines.layer for lines in maps if caught(copy, mutant, lines, PARTS[part][1])), "survived")
        finally:
            free.put(copy)

    counts: Counter[str] = Counter()
    with ThreadPoolExecutor(len(copies)) as workers:
        for mutant, result in zip(mutants, workers.map(outcome, mutants), strict=True):
            counts[result.partition(":")[0]] += 1
            if result not in LAYERS or options.verbose:
                print(f"{mutant.file}:{mutant.line} {mutant.operator}: {result}")
                print(f"    - {mutant.before}\n    + {mutant.after}", flush=True)
    return counts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--parts", default=",".join(PARTS), help="of " + ", ".join(PARTS))
    parser.add_argument("--number", type=int, default=50, help="mutants of each part")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="mutants tried at the same time")
    parser.add_argument("--verbose", action="store_true", help="print those that were caught, too")
    options = parser.parse_args()
    rows: dict[str, Counter[str]] = {}
    with tempfile.TemporaryDirectory(prefix="mutants-") as name:
        folder = Path(name)
        copies = []
        for number in range(options.jobs):
            (folder / str(number)).mkdir()
            copies.append(Copy(folder / str(number)))
        for part in options.parts.split(","):
            print(f"== {part}", flush=True)
            rows[part] = measure(part, options, copies, folder)
    rows["all"] = sum(rows.values(), Counter())
    print(
        f"\n| part | mutants | equivalent | caught of the others by the {' | by the '.join(LAYERS)} |\n{'| --- ' * 5}|"
    )
    for part, counts in rows.items():
        real = counts.total() - counts["equivalent"]
        shares = (sum(counts[layer] for layer in list(LAYERS)[: at + 1]) / max(1, real) for at in range(len(LAYERS)))
        cells = (part, counts.total(), counts["equivalent"], *(f"{share:.0%}" for share in shares))
        print(f"| {' | '.join(map(str, cells))} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
