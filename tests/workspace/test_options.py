"""The options of colcon: help and answers of the real one, recorded, and what is said of options that have no effect here.

`python -m tests.workspace.test_options COLCON` records `colcon_options.json` with a real colcon that has
colcon-common-extensions, colcon-ros and colcon-override-check.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from day6_core.workspace.option import Option, Treated, cmake_definitions
from day6_core.workspace.options import BEFORE_VERB, OPTIONS, options_of
from tests.workspace.workshop import Workshop, edit

RECORDED = Path(__file__).with_name("colcon_options.json")

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name><version>0.0.0</version><description>x</description>
  <maintainer email="a@b.org">a</maintainer><license>MIT</license>
  {depends}
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP = """\
from setuptools import setup

setup(name='{name}', version='0.0.0', packages=['{name}'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/{name}']), ('share/{name}', ['package.xml'])])
"""
PACKAGES = {
    "bottom": "",
    "arm/lower": "<build_depend>bottom</build_depend><exec_depend>bottom</exec_depend>",
    "arm/upper": "<exec_depend>lower</exec_depend><test_depend>bottom</test_depend>",
    "top": "<depend>upper</depend>",
}
"""folder -> dependencies: a chain of four, two of which are in a folder of their own"""

CASES = [
    "graph --dot",
    "graph --dot --dot-cluster",
    "graph --dot --packages-select top bottom",
    "graph --dot --packages-select top bottom --dot-include-skipped",
    "graph --dot --legend",
    "graph --density --legend",
    "graph --packages-select top bottom",
    "graph --density --packages-select nobody",
    "list --packages-select nobody --allow-overriding none",
    "list -t --packages-up-to upper --names-only",
    "list --packages-above lower -p",
    "list -g",
    "list -g --topological-graph-density --topological-graph-legend",
    "list --topological-graph-dot --topological-graph-dot-cluster --topological-graph-dot-include-skipped",
    "list --topological-graph-density",
    "list --topological-graph-legend",
    "list --topological-graph-dot-cluster",
    "list --topological-graph-dot-include-skipped",
    "--log-level error list --packages-select nobody",
    "--log-level 50 list --packages-above nobody",
    "--log-level loud list",
    "info top --packages-select nobody",
]
DEFAULTS = """\
list: {names-only: true, topological-order: "yes", packages-select: top, no-such: 1}
graph: [1]
"""
"""A colcon_defaults.yaml with much that is wrong."""
DEFAULT_CASES = ["list", "graph", "info top"]
OVERRIDING = "colcon build; . install/setup.sh; colcon build --packages-select lower; colcon build"
"""Of the workspace's own packages, those that others there need are warned of when they are built alone."""


def make(workspace: Path) -> None:
    """Write the packages."""
    for path, depends in PACKAGES.items():
        folder, name = workspace / "src" / path, Path(path).name
        for file in (f"{name}/__init__.py", f"resource/{name}"):
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).touch()
        (folder / "package.xml").write_text(MANIFEST.format(name=name, depends=depends), encoding="utf-8")
        (folder / "setup.py").write_text(SETUP.format(name=name), encoding="utf-8")


def plain(text: str, home: Path, workspace: Path) -> str:
    """Return output without what differs by machine and moment: times, folders, cores."""
    text = text.replace(str(workspace), "<WS>").replace(f"{home}/.colcon", "~/.colcon")
    text = re.sub(r"\[\d+\.\d+s\] ", "[<T>] ", text)
    text = re.sub(r"^ +get_python_setup_options: .*\n", "", text, flags=re.MULTILINE)  # an address
    text = re.sub(r"^usage: (?=colcon \[-h\]).*?(?=^colcon: error|\Z)", "", text, flags=re.DOTALL | re.MULTILINE)
    return re.sub(
        r"\(default: \d+\)", "(default: <N>)", re.sub(r"no\s+limit \(default:\s+\d+\)", "no limit (default: 8)", text)
    )


def warning_in(text: str) -> list[str]:
    """Return the lines of the first warning of packages in underlays; there must be one only."""
    assert text.count("Some selected packages are already built") == 1
    lines = text.splitlines()
    first = next(at for at, line in enumerate(lines) if "Some selected packages" in line)
    return lines[first : next(at for at, line in enumerate(lines) if "may be promoted" in line) + 1]


def record(colcon: str) -> None:
    """Write what the real colcon answers."""
    with tempfile.TemporaryDirectory() as folder:
        home, workspace = Path(folder, "home"), Path(folder, "ws")
        home.mkdir()
        make(workspace)
        path = os.pathsep.join([str(Path(colcon).parent), os.environ["PATH"]])
        environment = {"HOME": str(home), "PATH": path, "COLUMNS": "80", "COLCON_LOG_PATH": f"{folder}/log"}

        def answer(command: str) -> dict[str, object]:
            words = ["colcon", *command.split()]
            done = subprocess.run(words, cwd=workspace, env=environment, capture_output=True, text=True, check=False)
            out, err = (plain(text, home, workspace) for text in (done.stdout, done.stderr))
            return {"command": command, "status": done.returncode, "out": out, "err": err}

        found = {"help": [answer(f"{verb} --help") for verb in OPTIONS], "cases": [answer(case) for case in CASES]}
        (workspace / "colcon_defaults.yaml").write_text(DEFAULTS, encoding="utf-8")
        found["defaults"] = [answer(case) for case in DEFAULT_CASES]
        (workspace / "colcon_defaults.yaml").unlink()
        done = subprocess.run(
            ["sh", "-c", OVERRIDING], cwd=workspace, env=environment, capture_output=True, text=True, check=True
        )
        found["overriding"] = [{"err": warning_in(plain(done.stderr, home, workspace))}]
    RECORDED.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


def recorded(kind: str) -> list:
    rows = json.loads(RECORDED.read_text(encoding="utf-8"))[kind] if RECORDED.exists() else []
    return [pytest.param(row, id=row["command"]) for row in rows]


def compared(workshop: Workshop, row: dict) -> None:
    done = workshop.run(f"colcon {row['command']}")
    out, err = (plain(text, workshop.home, workshop.workspace) for text in (done.out, done.err))
    ordered = sorted if "--dot-cluster" in row["command"] else list  # there the real one prints a set
    assert done.status == row["status"]
    assert ordered(out.splitlines()) == ordered(row["out"].splitlines())
    assert err.splitlines() == row["err"].splitlines()


@pytest.mark.parametrize("row", [*recorded("help"), *recorded("cases")])
def test_the_answer_is_that_of_the_real_colcon(workshop: Workshop, row: dict) -> None:
    make(workshop.workspace)
    compared(workshop, row)


@pytest.mark.parametrize("row", recorded("defaults"))
def test_defaults_of_the_workspace_count_as_in_the_real_colcon(workshop: Workshop, row: dict) -> None:
    make(workshop.workspace)
    (workshop.workspace / "colcon_defaults.yaml").write_text(DEFAULTS, encoding="utf-8")
    compared(workshop, row)


def test_every_option_of_the_real_help_is_in_the_table() -> None:
    """`-h` is argparse's own."""
    for row in json.loads(RECORDED.read_text(encoding="utf-8"))["help"]:
        usage = row["out"].partition("\n\n")[0]
        theirs = set(re.findall(r"--[a-z-]+", usage))
        assert theirs == {each.name for each in options_of(row["command"].split()[0]) if each.name.startswith("--")}


# -- what is not as in colcon ------------------------------------------------------------------------------------------

UNLIKE = {
    (verb, each.name): each for verb in OPTIONS for each in options_of(verb) if each.treated is not Treated.OBEYED
}


def given(option: Option) -> str:
    """Return the option with a value that isn't obeyed."""
    if "action" in option.keywords:
        return option.name
    return f"{option.name} {'--other' if option.keywords.get('type') is str.lstrip else 'other'}"


@pytest.mark.parametrize(("verb", "name"), UNLIKE, ids=lambda each: each)
def test_an_option_without_effect_is_told_with_the_reason(workshop: Workshop, verb: str, name: str) -> None:
    option = UNLIKE[verb, name]
    done = workshop.run(f"colcon {verb} {given(option)}")
    if option.treated is Treated.REFUSED:
        assert done.status == 2 and done.err.endswith(
            f"colcon {verb}: error: argument {name}: not possible here: {option.why[0]}\n"
        )
    else:
        assert f"WARNING:colcon.day6_tui:{name} has no effect here: {option.why[0]}\n" in done.err


def test_only_what_differs_has_a_reason_and_in_both_languages() -> None:
    for option in (*BEFORE_VERB.options, *(each for verb in OPTIONS for each in options_of(verb))):
        assert all(option.why) == (option.treated is not Treated.OBEYED) == any(option.why), option.name


def test_a_level_below_warnings_has_nothing_to_show(workshop: Workshop) -> None:
    done = workshop.run("colcon --log-level debug list; COLCON_LOG_LEVEL=error colcon list --packages-select nobody")
    assert (
        done.err.count("--log-level has no effect here: there is nothing below a warning")
        == done.err.count("WARN")
        == 1
    )


@pytest.mark.parametrize(
    ("words", "defined", "others"),
    [
        ("-DA=1 -D B:STRING=x=y", {"A": "1", "B": "x=y"}, []),
        ("-G Ninja -DA= --trace -D", {"A": ""}, ["-G", "Ninja", "--trace", "-D"]),
    ],
)
def test_arguments_of_cmake(words: str, defined: dict[str, str], others: list[str]) -> None:
    assert cmake_definitions(words.split()) == (defined, others)


def test_a_definition_for_cmake_counts(workshop: Workshop) -> None:
    workshop.run("ros2 pkg create day6_own", workshop.terminal(workshop.workspace / "src"))
    lists = 'if(NOT ROBOT STREQUAL "car" OR NOT WHEELS EQUAL 4)\n  message(FATAL_ERROR "${ROBOT}")\nendif()\nament_package()'
    edit(workshop.workspace / "src/day6_own/CMakeLists.txt", "ament_package()", lists)
    assert workshop.run("colcon build").status == 1
    done = workshop.run("colcon build --cmake-args -DROBOT=car --ament-cmake-args -DWHEELS:STRING=4")
    assert done.status == 0 and not done.err


@pytest.mark.process
def test_options_of_tests_are_obeyed_or_say_why_not(workshop: Workshop) -> None:
    package = workshop.create("day6_tested")
    for file in (package / "test").iterdir():
        file.unlink()
    (package / "test/test_it.py").write_text(
        "import sys\nimport unittest\n\n\nclass It(unittest.TestCase):\n    def test_a(self) -> None:\n"
        "        assert 'pytest' not in sys.modules\n\n    def test_b(self) -> None:\n        pass\n"
    )
    (package / "test/__init__.py").touch()
    workshop.run("colcon build")
    more = "--event-handlers console_direct+ --return-code-on-test-failure"
    done = workshop.run(
        f"colcon test {more} --python-testing setuppy_test --retest-until-pass 2 --unittest-args -k test_a"
    )
    assert done.status == 0 and "Ran 1 test in" in done.out + done.err, done
    ignored = "Ignored '--retest-until-pass' for package 'day6_tested' since"
    assert f"WARNING:colcon.colcon_core.verb.test:{ignored} 'unittest' does not support the usage" in done.err
    done = workshop.run(f"colcon test {more} --retest-until-pass 2 --pytest-with-coverage")
    assert done.status == 1 and "1 failed, 1 passed" in done.out
    assert ignored in done.err or "RERUN" in done.out
    assert (
        "Test coverage will not be produced" in done.err
        or (workshop.workspace / "build/day6_tested/coverage.xml").is_file()
    )


@pytest.mark.process
def test_a_package_of_this_workspace_that_others_need_is_warned_of_as_by_the_real_one(workshop: Workshop) -> None:
    make(workshop.workspace)
    said = plain(workshop.run(OVERRIDING).err, workshop.home, workshop.workspace)
    assert warning_in(said) == json.loads(RECORDED.read_text(encoding="utf-8"))["overriding"][0]["err"]


if __name__ == "__main__":
    record(sys.argv[1])
