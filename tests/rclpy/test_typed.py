"""What a type checker sees of rclpy: pyright, strict, with the settings that `day6-tui env --vscode` writes.

The programs in `typed/` are those of the tutorials with annotations; `assert_type` lines in them say what has to be inferred.
`typed/slips.py` holds mistakes, each in a line that ends with "# error: …".
"""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.environment import PYTHON_PATH
from day6_core.shell.outward import ide, jsonc
from tests.e2e.lesson_files import TALKER, WHEEL_SPINNER

HERE = Path(__file__).parent
PROGRAMS = sorted((HERE / "typed").glob("*.py"))

_HEARD = """\
from rclpy.node import Node
from std_msgs.msg import String

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.subscription = self.create_subscription(String, 'chatter', self.listener_callback, 10)
        self.create_subscription(String, 'chatter', lambda msg: reveal_type(msg), 10)
        reveal_type(self.subscription)

    def listener_callback(self, msg: String):
        self.get_logger().info('I heard: %s' % msg.data)
"""


def _asking(program: str, *questions: str) -> str:
    """A program that asks for types where it publishes."""
    publish = "        self.publisher_.publish(msg)\n"
    assert program.count(publish) == 1
    return program.replace(publish, publish + "".join(f"        reveal_type({each})\n" for each in questions))


ARTICLE = {
    "talker.py": _asking(TALKER, "self.publisher_", "self.timer", "msg.data"),
    "wheel_spinner.py": _asking(WHEEL_SPINNER, "self.publisher_", "msg.header.stamp", "msg.name"),
    "listener.py": _HEARD,
}
"""The article's programs, which have no annotations, with what an editor is asked about them."""

Diagnostics = dict[str, list[tuple[int, str, str]]]
"""Of each file: line, severity and text."""


@pytest.fixture(scope="module")
def diagnostics(tmp_path_factory: pytest.TempPathFactory) -> Diagnostics:
    checker = Path(sys.executable).with_name("basedpyright")
    command = str(checker) if checker.exists() else shutil.which("basedpyright")
    if command is None:
        pytest.skip("basedpyright is not installed: pip install .[test]")
    project = tmp_path_factory.mktemp("typed")
    stubs = project / "stubs"
    ide.write_stubs(stubs)
    settings, *_ = ide.write_vscode(project, stubs)
    paths = jsonc.parse(settings.read_text(encoding="utf-8"))["python.analysis.extraPaths"]
    for path in PROGRAMS:
        shutil.copy(path, project)
    for name, text in ARTICLE.items():
        (project / name).write_text(text, encoding="utf-8")
    options = {
        "extraPaths": paths,
        "exclude": ["stubs"],
        "typeCheckingMode": "strict",
        "pythonVersion": "3.10",
    }
    (project / "pyrightconfig.json").write_text(json.dumps(options), encoding="utf-8")
    done = subprocess.run(
        [command, "--outputjson", "--pythonpath", sys.executable, "--project", str(project)],
        capture_output=True,
        encoding="utf-8",
        env={**os.environ, "LC_ALL": "C.UTF-8"},
        timeout=300,
    )
    report = json.loads(done.stdout)
    assert report["summary"]["filesAnalyzed"] == len(PROGRAMS) + len(ARTICLE)
    found: Diagnostics = defaultdict(list)
    for each in report["generalDiagnostics"]:
        line = each["range"]["start"]["line"] + 1
        found[Path(each["file"]).name].append((line, each["severity"], each["message"]))
    return found


@pytest.mark.process
@pytest.mark.parametrize("name", [path.name for path in PROGRAMS if path.name != "slips.py"])
def test_a_tutorials_program_has_no_error_and_every_type_is_inferred(diagnostics: Diagnostics, name: str) -> None:
    assert "assert_type(" in (HERE / "typed" / name).read_text(encoding="utf-8")
    assert diagnostics[name] == []


@pytest.mark.process
def test_every_slip_is_an_error_and_nothing_else_is(diagnostics: Diagnostics) -> None:
    lines = (HERE / "typed" / "slips.py").read_text(encoding="utf-8").splitlines()
    expected = {number for number, line in enumerate(lines, start=1) if "# error: " in line}
    assert len(expected) >= 20
    assert {line for line, severity, _ in diagnostics["slips.py"] if severity == "error"} == expected


@pytest.mark.process
@pytest.mark.parametrize(
    ("name", "types"),
    [
        ("talker.py", ["Publisher[String]", "Timer", "str"]),
        ("wheel_spinner.py", ["Publisher[JointState]", "Time", "list[str]"]),
        ("listener.py", ["String", "Subscription[String]"]),
    ],
)
def test_the_articles_programs_are_understood_without_annotations(
    diagnostics: Diagnostics, name: str, types: list[str]
) -> None:
    told = [(severity, message) for _, severity, message in sorted(diagnostics[name])]
    assert [
        message.rpartition(' is "')[2].rstrip('"') for severity, message in told if severity == "information"
    ] == types
    # `main(args=None)` has no annotation either.
    assert [message for severity, message in told if severity == "error" and '"args"' not in message] == []


# -- how much of the public face is Any --------------------------------------------------------------------------------

OF_REAL = 34 / 454
"""The share of public signatures with `Any` in real rclpy 9.1.2, as a review counted; by the counting here it is 62 of 538."""


def _signatures(body: list[ast.stmt], prefix: str = "") -> Iterator[tuple[str, ast.FunctionDef | ast.AsyncFunctionDef]]:
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            if not node.name.startswith("_") or node.name == "__init__":
                yield prefix + node.name, node
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            yield from _signatures(node.body, f"{prefix}{node.name}.")
        elif isinstance(node, (ast.If, ast.Try)):
            yield from _signatures([*node.body, *node.orelse], prefix)


def _is_overload(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return any(ast.unparse(each).rpartition(".")[2] == "overload" for each in function.decorator_list)


def signatures_with_any(package: Path) -> tuple[list[str], int]:
    """Return the public signatures of a package that hold `Any`, and the number of all.

    Counted are functions, methods and `__init__` of modules and classes whose names have no leading underscore. An
    overloaded function counts by its overloads: nobody sees the signature of its implementation.
    """
    with_any: list[str] = []
    count = 0
    for path in sorted(package.rglob("*.py")):
        parts = path.relative_to(package).parts
        if any(part.startswith("_") and part != "__init__.py" for part in parts):
            continue
        found = list(_signatures(ast.parse(path.read_text(encoding="utf-8")).body))
        overloaded = {name for name, function in found if _is_overload(function)}
        for name, function in found:
            if name in overloaded and not _is_overload(function):
                continue
            count += 1
            arguments = function.args
            given = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.vararg, arguments.kwarg]
            annotations: list[Any] = [function.returns, *(each.annotation for each in given if each is not None)]
            words = {
                word.id
                for each in annotations
                if each is not None
                for word in ast.walk(ast.parse(each.value) if _is_text(each) else each)
                if isinstance(word, ast.Name)
            }
            if "Any" in words:
                with_any.append(f"{path.relative_to(package)}: {name}")
    return with_any, count


def _is_text(annotation: ast.expr) -> bool:
    return isinstance(annotation, ast.Constant) and isinstance(annotation.value, str)


def test_no_larger_share_of_the_public_signatures_holds_any_than_in_real_rclpy() -> None:
    with_any, count = signatures_with_any(PYTHON_PATH / "rclpy")
    assert count > 400
    assert len(with_any) / count <= OF_REAL, "\n".join(with_any)
