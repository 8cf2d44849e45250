"""Runs the Python tests of public packages with our ROS and with a real one, and counts where each test ends the same.

    python -m tests.conformance.package_tests --sources FOLDER [--clone] [--real PYTHON [--record]] [--show] [NAME…]

`package_tests.json` names the packages: a repository at a commit, the package's folder in it, and what each test ended as with
real ROS: a letter for each test of a file in the order they ran, `p`assed, `f`ailed, `s`kipped, `e`rror (of a fixture),
`x` for a failure that was expected, `!` for a file that cannot be imported, `?` for what differed from run to run and so doesn't
count. FOLDER has checkouts (see `checkouts.py`; `--clone` fetches what is missing). A NAME chooses by a part of
`owner/name/folder`.

Each package is built (`colcon build --packages-up-to`) in a workspace of its own with all of its repository, sourced, and tested
(`python -m pytest`) in its folder, as `colcon test` does it. Repositories in `with` and packages in `also` are there too. A
package with a `path` isn't built: its tests find it by that folder. `tests` are those that its CMakeLists.txt runs, where it has
others, too. With `--real`, an interpreter that has real ROS (and colcon beside it), the other side is run too, for its time;
`--record` runs it twice and writes down what came out. The real side builds nothing that it has installed, and has to have what
is in `with` and `also`.

What was recorded had Kilted's wheels, launch, its relatives, `ros2` and tf2 of the end of 2024, interfaces built beforehand, and
no node in C++: tests that want one are left out here.

What the packages import besides ROS is in `pip`: both interpreters need it, and pytest 8 (launch_testing knows no newer one).
This runs programs of strangers: without network, and where they can damage nothing.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from tests.conformance.checkouts import Missing, extract

INPUTS = Path(__file__).with_suffix(".json")
OURS = str(Path(sys.executable).with_name("day6-tui"))
DISTRIBUTION = "kilted"
"""The one that can be had as wheels."""
PLUGIN_OF_OURS = find_spec("day6_tui.pytest") is not None
"""Whether a plain pytest finds our ROS, and the packages of the repository, by itself."""
LIMIT_S = 120.0
"""For the build of a package, and for its tests."""

PLUGIN = """\
import os

FOUND = {}

def tell(name, letter):
    with open(os.environ["DAY6_VERDICTS"], "a") as file:
        print(letter, name, file=file)

def pytest_collectreport(report):
    if report.outcome == "failed":
        tell(report.nodeid, "!")

def pytest_runtest_logreport(report):
    if report.when == "call" or report.outcome != "passed":
        letter = report.outcome[0]
        if hasattr(report, "wasxfail"):
            letter = "x"
        elif letter == "f" and report.when != "call":
            letter = "e"
        FOUND[report.nodeid] = letter
    if report.when == "teardown":
        tell(report.nodeid, FOUND.pop(report.nodeid, "p"))
"""
"""Writes down what each test ended as, also when the process dies afterwards."""


@dataclass
class Ended:
    """What became of a package: the letters of each file's tests, seconds, and what was printed."""

    build_s: float
    test_s: float
    text: str
    letters: dict[str, str] = field(default_factory=dict)
    names: dict[str, list[str]] = field(default_factory=dict)

    def take(self, told: list[str]) -> None:
        """Sort what the plugin wrote down by files; nothing was run if a file cannot be imported, whichever it was."""
        if told and all(line.startswith("!") for line in told):
            told = ["! (collecting)"]
        for line in told:
            letter, _, node = line.partition(" ")
            file = node.partition("::")[0]
            self.letters[file] = self.letters.get(file, "") + letter
            self.names.setdefault(file, []).append(node)

    @property
    def seconds(self) -> float:
        return self.build_s + self.test_s


def play(
    package: Mapping[str, Any], sources: Path, real: str | None, domain: int, clone: bool, times: int = 1
) -> list[Ended]:
    """Build a package with our ROS or that of the interpreter `real`, and test it some times."""
    with tempfile.TemporaryDirectory(prefix="day6-package-") as name:
        place = Path(name)
        for each in [package, *([] if real else package.get("with", []))]:
            folder = place / "src" / each["repository"].replace("/", "+")
            if not folder.exists():
                extract(each["repository"], each["commit"], sources, folder, clone=clone)
        folder = place / "src" / package["repository"].replace("/", "+") / package["package"]
        env = _environment(place, real, domain)
        built, build_s = "", 0.0
        if "path" in package:
            env["PYTHONPATH"] = os.pathsep.join(filter(None, [str(folder / package["path"]), env.get("PYTHONPATH")]))
        elif real or not PLUGIN_OF_OURS:
            words = [str(Path(real).with_name("colcon"))] if real else [OURS, "colcon"]
            words += ["build", "--packages-up-to", _name_of(folder), *package.get("also", [])]
            if real:
                _leave_out_installed(place / "src", Path(real).absolute().parents[1], folder)
                words += ["--cmake-args", "-DBUILD_TESTING=OFF", f"-DPython3_EXECUTABLE={real}"]
            begin = time.monotonic()
            built = run(words, place, env)
            build_s = time.monotonic() - begin
        setup = place / "install" / "setup.bash"
        sourced = f". {shlex.quote(str(setup))} && " if setup.exists() else ""
        words = tester(real, package.get("tests", []))
        told = place / "verdicts"
        runs = []
        for _ in range(times):
            told.write_bytes(b"")
            begin = time.monotonic()
            text = run(["bash", "-c", f"{sourced}exec {shlex.join(words)}"], folder, env)
            ended = Ended(build_s, time.monotonic() - begin, built + text)
            ended.take(told.read_text(encoding="utf-8").splitlines())
            runs.append(ended)
        return runs


def _leave_out_installed(sources: Path, prefix: Path, tested: Path) -> None:
    """Keep colcon from building what is installed: interfaces above all, which take the real one minutes."""
    for manifest in sources.rglob("package.xml"):
        if manifest.parent != tested and (prefix / "share" / _name_of(manifest.parent)).is_dir():
            (manifest.parent / "COLCON_IGNORE").touch()


def tester(real: str | None, tests: list[str]) -> list[str]:
    """Return the command that runs the tests of the package in this folder."""
    return [real or sys.executable, "-m", "pytest", "-q", "-p", "day6_verdicts", "-p", "no:cacheprovider", *tests]


def _environment(place: Path, real: str | None, domain: int) -> dict[str, str]:
    """Return the variables of one side: nothing of this process's ROS, a graph of its own."""
    from day6_core.ros.environment import program_environment

    env = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("DAY6_", "ROS_", "AMENT", "COLCON", "PYTHON", "CMAKE"))
    }
    if real:
        prefix = Path(real).absolute().parents[1]
        env |= {"AMENT_PREFIX_PATH": str(prefix), "CMAKE_PREFIX_PATH": str(prefix), "ROS_DISTRO": DISTRIBUTION}
        env |= {"VIRTUAL_ENV": str(prefix), "ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
        libraries = [prefix / "lib", *sorted(prefix.glob("lib/python3*/site-packages/ros_*.libs"))]
        env |= {"LD_LIBRARY_PATH": os.pathsep.join(map(str, libraries)), "CXXFLAGS": "-O0", "CFLAGS": "-O0"}
        python = Path(real)
    else:
        env |= {} if PLUGIN_OF_OURS else program_environment(env)
        env["ROS_DISTRO"] = DISTRIBUTION
        env["DAY6_RUNTIME_DIR"] = tempfile.mkdtemp(dir=place)
        python = Path(sys.executable)
    plugin = place / "plugin"
    plugin.mkdir()
    (plugin / "day6_verdicts.py").write_text(PLUGIN, encoding="utf-8")
    env["PYTHONPATH"] = os.pathsep.join(filter(None, [env.get("PYTHONPATH"), str(plugin)]))
    env["PATH"] = os.pathsep.join([str(python.parent), env.get("PATH", os.defpath)])
    env |= {"DAY6_VERDICTS": str(place / "verdicts"), "HOME": str(place), "LANG": "C.UTF-8"}
    env |= {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_DOMAIN_ID": str(domain), "PYTHONDONTWRITEBYTECODE": "1"}
    return env


def _name_of(package: Path) -> str:
    text = (package / "package.xml").read_text(encoding="utf-8", errors="replace")
    return text.partition("<name>")[2].partition("</name>")[0].strip()


def run(words: list[str], folder: Path, env: dict[str, str]) -> str:
    """Run a program until it ends or its time is up, end what it left behind, and return what it printed."""
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(
            words, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True
        )
        note = ""
        try:
            process.wait(LIMIT_S)
        except subprocess.TimeoutExpired:
            note = f"\nno end in {LIMIT_S:g} s\n"
        finally:
            _end_session(process.pid)
        process.wait()
        output.seek(0)
        return output.read().decode(errors="replace") + note


def _end_session(leader: int) -> None:
    """Kill what is left of a session: a launch that is killed leaves the nodes that it started."""
    for process in list(_below(leader)):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            continue


def _below(leader: int) -> Iterator[int]:
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                words = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(words[3]) == leader:
                yield int(entry.name)


def counted(expected: Mapping[str, str], ended: Ended) -> tuple[int, int, list[str]]:
    """Return how many tests count, how many ended the same, and a line for each that didn't."""
    total = same = 0
    lines = []
    for file in sorted({*expected, *ended.letters}):
        wanted, found = expected.get(file, ""), ended.letters.get(file, "")
        names = ended.names.get(file, [])
        for number in range(max(len(wanted), len(found))):
            one, other = wanted[number : number + 1] or "-", found[number : number + 1] or "-"
            if one == "?":
                continue
            total += 1
            same += one == other
            if one != other:
                lines.append(f"{one} -> {other} {names[number] if number < len(names) else f'{file} [{number}]'}")
    return total, same, lines


def agreed(one: Mapping[str, str], other: Mapping[str, str]) -> dict[str, str]:
    """Return the letters of two runs, with a question mark where they differ."""
    return {
        file: "".join(
            a if a == b else "?"
            for a, b in zip(one.get(file, "").ljust(length), other.get(file, "").ljust(length), strict=True)
        )
        for file in sorted({*one, *other})
        for length in [max(len(one.get(file, "")), len(other.get(file, "")))]
    }


def main() -> int:
    """Print a line for each package, then the sums."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, required=True, help="folder with checkouts")
    parser.add_argument("--clone", action="store_true", help="clone what is missing there")
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with real ROS")
    parser.add_argument("--record", action="store_true", help="run the real one twice and keep what came out")
    parser.add_argument("--show", action="store_true", help="print what was printed where something differs")
    parser.add_argument("--domain", type=int, default=90, help="ROS_DOMAIN_ID")
    parser.add_argument("names", nargs="*", help="parts of `owner/name/folder` (default: all)")
    chosen = parser.parse_args()
    os.environ["ROS_DISTRO"] = DISTRIBUTION
    inputs = json.loads(INPUTS.read_text(encoding="utf-8"))
    seconds: dict[str, list[float]] = {"ours": [], "real": []}
    tests = same = packages = whole = 0
    for package in inputs["packages"]:
        name = "/".join(filter(None, (package["repository"], package["package"])))
        if chosen.names and not any(word in name for word in chosen.names):
            continue
        try:
            if chosen.real:
                real, *again = play(
                    package, chosen.sources, chosen.real, chosen.domain, chosen.clone, 1 + chosen.record
                )
                seconds["real"].append(real.seconds)
                for other in again:
                    package["verdicts"] = agreed(real.letters, other.letters)
                    keep(package)
            (ours,) = play(package, chosen.sources, None, chosen.domain + 1, chosen.clone)
        except Missing as error:
            print(f"-- {error}", flush=True)
            continue
        seconds["ours"].append(ours.seconds)
        count, equal, lines = counted(package.get("verdicts", {}), ours)
        print(f"{equal:4}/{count:<4} {ours.build_s:5.1f} + {ours.test_s:5.1f} s", end=" ")
        if chosen.real:
            print(f"(real {real.build_s:5.1f} + {real.test_s:5.1f} s)", end=" ")
        print(name, flush=True)
        for line in lines if chosen.show else lines[:5]:
            print(f"     {line[:120]}", flush=True)
        if chosen.show and lines:
            print(ours.text, *(["--- real:", real.text] if chosen.real else []), sep="\n", flush=True)
        packages, tests, same, whole = packages + 1, tests + count, same + equal, whole + (equal == count)
    print(
        f"{packages} packages, {whole} of them whole: {same} of {tests} tests end the same ({same / max(tests, 1):.1%})"
    )
    for side, each in seconds.items():
        if each:
            print(f"{side}: a median package takes {statistics.median(each):.1f} s, all {sum(each):.0f} s")
    return int(same < tests)


def keep(package: Mapping[str, Any]) -> None:
    """Write a package's verdicts into the list as it is now: a run takes an hour, and others edit it meanwhile."""
    inputs = json.loads(INPUTS.read_text(encoding="utf-8"))
    for each in inputs["packages"]:
        if (each["repository"], each["package"]) == (package["repository"], package["package"]):
            each["verdicts"] = package["verdicts"]
    INPUTS.write_text(written(inputs), encoding="utf-8")


def written(inputs: Mapping[str, Any]) -> str:
    """Return the list as JSON, a line for each package and each file of tests."""
    lines = []
    for package in inputs["packages"]:
        head = json.dumps({key: value for key, value in package.items() if key != "verdicts"}, ensure_ascii=False)
        files = [f"      {json.dumps(file)}: {json.dumps(each)}" for file, each in package.get("verdicts", {}).items()]
        verdicts = "{\n" + ",\n".join(files) + "\n    }" if files else "{}"
        lines.append(f'    {head[:-1]}, "verdicts": {verdicts}}}')
    return f'{{\n  "pip": {json.dumps(inputs["pip"])},\n  "packages": [\n' + ",\n".join(lines) + "\n  ]\n}\n"


if __name__ == "__main__":
    raise SystemExit(main())
