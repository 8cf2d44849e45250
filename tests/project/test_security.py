"""What comes from outside (interface texts, manifests, parameter files, other users) becomes no code and costs no memory."""

from __future__ import annotations

import ast
import itertools
import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.interfaces import get_message
from day6_core.interfaces.registry import forget
from day6_core.ros.environment import program_environment
from tests.support.source_files import PACKAGES, ROOT, nodes, trees
from tests.support.waiting import run

REASONS = {
    (
        "day6_core/interfaces/generate.py",
        "exec",
    ): "class source; of a text only checked identifiers and repr() of values get into it",
    (
        "day6_core/shell/outward/ide.py",
        "xml",
    ): "the project's own .idea files, at its owner's wish; expat expands no entities of files",
    ("day6_core/interfaces/generate.py", "eval"): "the default of a field, made by repr() of a value that was parsed",
    ("day6_core/interfaces/generate.py", "compile"): "names the generated source in tracebacks",
    ("day6_core/interfaces/copying.py", "exec"): "generated from the checked structure of a message",
    ("day6_core/interfaces/copying.py", "compile"): "names the generated source in tracebacks",
    ("day6_core/interfaces/cdr_read.py", "exec"): "generated from the checked structure of a message",
    ("day6_core/interfaces/cdr_read.py", "compile"): "names the generated source in tracebacks",
    ("day6_core/interfaces/cdr_write.py", "exec"): "generated from the checked structure of a message",
    ("day6_core/interfaces/cdr_write.py", "compile"): "names the generated source in tracebacks",
    (
        "day6_core/ros/python/launch/substitutions/local_substitution.py",
        "eval",
    ): "a launch file is the user's own program",
    (
        "day6_core/ros/python/launch/substitutions/python_expression.py",
        "eval",
    ): "the same: $(eval …) is there to run Python",
    ("day6_core/ros/python/launch_testing/junitxml.py", "xml"): "writes results, and reads nothing",
    (
        "day6_core/ros/python/ament_xmllint/main.py",
        "xml",
    ): "expat only says what is no XML; with its handler nothing is expanded",
    (
        "day6_core/ros/python/launch_xml/parser.py",
        "xml",
    ): "refuses a document type, without which there are no entities",
    (
        "day6_core/ros/programs/joint_state_publisher/joints.py",
        "xml",
    ): "expat only says what is no XML; every entity definition is refused; tried in tests/joint_state_publisher",
    (
        "day6_core/ros/programs/xacro/limits.py",
        "xml",
    ): "for xacro, in a process with limits; tests/workspace/test_xacro_limits",
    ("day6_core/shell/editing/checks.py", "xml"): "expat only says what is no XML; entity definitions are refused",
    ("day6_core/shell/editing/checks.py", "compile"): "finds mistakes in the text of an editor; nothing is run",
    ("day6_core/plain_xml.py", "xml"): "a document type is refused; tried in tests/rviz2 and tests/workspace",
    ("day6_core/workspace/sourcing.py", "exec"): "two lines of our own with the name of a package, which was checked",
    ("day6_core/ros/ros2/pkg/xml.py", "xml"): "expat opens nothing and stops entities that grow; tried below",
    ("day6_tui/notebook/ros2_line.py", "shell=True"): "the line of a cell, which may run anything anyway, as after `!`",
    (
        "day6_core/ros/ros2/doctor/__init__.py",
        "xml",
    ): "as for pkg xml: expat opens nothing and stops entities that grow",
}
"""Where something dangerous is used all the same, and why it is not dangerous there."""

DANGEROUS_CALLS = {"eval", "exec", "compile", "__import__", "breakpoint"}
DANGEROUS_MODULES = {"pickle", "cPickle", "marshal", "shelve", "dill", "xml", "lxml"}
DANGEROUS_ATTRIBUTES = {
    "os.system", "os.popen", "subprocess.getoutput", "subprocess.getstatusoutput", "tempfile.mktemp", "yaml.load",
    "yaml.load_all", "yaml.full_load", "yaml.unsafe_load", "yaml.Loader", "yaml.FullLoader", "yaml.UnsafeLoader", "numpy.load",
}  # fmt: skip


def dangers(tree: ast.AST) -> Iterator[tuple[str, int]]:
    attributes = {each.partition(".")[2] for each in DANGEROUS_ATTRIBUTES}
    never_runs = {
        id(inner)
        for node in nodes(tree)
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"
        for inner in nodes(*node.body)
    }
    for node in nodes(tree):
        if id(node) in never_runs:
            continue
        if isinstance(node, ast.Call):
            if isinstance(node.func, ast.Name) and node.func.id in DANGEROUS_CALLS:
                yield node.func.id, node.lineno
            for keyword in node.keywords:
                harmless = isinstance(keyword.value, ast.Constant) and not keyword.value.value
                if keyword.arg != "shell" or harmless:
                    continue
                if ast.unparse(node.func).startswith(("subprocess.", "Popen", "asyncio.")):
                    yield "shell=True", node.lineno
        elif isinstance(node, ast.Attribute):
            if node.attr in attributes and (name := ast.unparse(node)) in DANGEROUS_ATTRIBUTES:
                yield name, node.lineno
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
            yield from ((name.split(".")[0], node.lineno) for name in names if name.split(".")[0] in DANGEROUS_MODULES)


def test_nothing_from_outside_is_run() -> None:
    found = {}
    # As ruff formats them: without a blank within a name or before the bracket.
    words = (*(f"{name}(" for name in DANGEROUS_CALLS), *DANGEROUS_MODULES, *DANGEROUS_ATTRIBUTES, "shell")
    check = Path(".ci", "check")
    modules = [(check, ast.parse((ROOT / check).read_text(encoding="utf-8")))]
    for path, tree in itertools.chain(modules, trees(*PACKAGES, ".ci", words=words)):
        for danger, line in dangers(tree):
            found[path.as_posix(), danger] = line
    assert {key: line for key, line in found.items() if key not in REASONS} == {}
    assert set(REASONS) <= set(found), "a reason is left for something that is not there any more"


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The `msg` folder of a package of interfaces that somebody else wrote."""
    folder = tmp_path / "share" / "evil_msgs" / "msg"
    folder.mkdir(parents=True)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    yield folder
    forget("evil_msgs")


@pytest.mark.parametrize(
    "line",
    [
        "int32 x=__import__('os').system('touch {0}')",
        "int32 a;__import__('os').mkdir('{0}')",
        "string a \"');__import__('os').mkdir('{0}')#\"",
        "string a '''+__import__('os').mkdir('{0}')+'''",
        "string[] a ['\\'', __import__('os').mkdir('{0}'), '\\'']",
        "float64 a __import__('os').mkdir('{0}')",
        "float64[2] a [inf, __import__('os').mkdir('{0}')]",
        "int32[__import__('os').mkdir('{0}')] a",
        "string<=__import__('os').mkdir('{0}') a",
        "string X=');__import__('os').mkdir('{0}')#",
        "int32 ａ",
        "int32 a\u2028    import os",
        "evil_msgs/__import__ a",
    ],
)
def test_a_text_of_an_interface_stays_a_text(package: Path, tmp_path: Path, line: str) -> None:
    (package / "Evil.msg").write_text(line.format(tmp_path / "done") + "\n", encoding="utf-8")
    try:
        get_message("evil_msgs/msg/Evil")()
    except Exception as error:
        # Refusing it is right, as long as it was the parser that did it and not Python, reading it as code.
        assert not isinstance(error, SyntaxError)
    assert not (tmp_path / "done").exists()


def test_names_of_interfaces_lead_nowhere_else(package: Path, tmp_path: Path) -> None:
    (tmp_path / "Secret.msg").write_text("int32 a\n", encoding="utf-8")
    for name in ("../../../Secret", "..", "Evil/../../Secret", "/etc/passwd"):
        with pytest.raises((LookupError, ValueError)):
            get_message(f"evil_msgs/msg/{name}")
    with pytest.raises((LookupError, ValueError)):
        get_message(f"../{tmp_path.name}/msg/Secret")


def exec_line(line: str, folder: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "day6_tui.main", "exec", "--home", str(folder / "home"), "-c", line]
    done: subprocess.CompletedProcess[str] = run(command, env={**program_environment(), "DAY6_LINK": "off"})
    return done


@pytest.mark.process
def test_a_manifest_cannot_fill_the_memory_or_read_files(tmp_path: Path) -> None:
    share = tmp_path / "share"
    index = share / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    entities = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 10))
    texts = {
        "laughs": f'<!DOCTYPE p [<!ENTITY e0 "ha">{entities}]><package><name>&e9;</name></package>',
        "reads": '<!DOCTYPE p [<!ENTITY e SYSTEM "file:///etc/passwd">]><package><name>&e;</name></package>',
    }
    for name, text in texts.items():
        (index / name).touch()
        (share / name).mkdir()
        (share / name / "package.xml").write_text(text, encoding="utf-8")
    done = exec_line(f"export AMENT_PREFIX_PATH='{tmp_path}'; ros2 pkg xml laughs; ros2 pkg xml reads", tmp_path)
    assert done.stdout == ""
    assert done.stderr.count("ParseError") == 2, done.stderr
    assert "root:" not in done.stderr


@pytest.mark.process
def test_yaml_makes_no_objects(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text(
        f"/**:\n  ros__parameters: {{a: !!python/object/apply:os.mkdir ['{tmp_path}/done']}}\n"
    )
    text = f"{{data: !!python/object/apply:os.mkdir ['{tmp_path}/done']}}"
    done = exec_line(
        f"ros2 run turtlesim turtlesim_node --ros-args --params-file '{tmp_path}/p.yaml' & sleep 0.2;"
        f"ros2 param load /turtlesim '{tmp_path}/p.yaml'; ros2 topic pub --once /t std_msgs/msg/String \"{text}\"",
        tmp_path,
    )
    assert done.returncode == 1
    assert "could not determine a constructor" in done.stderr
    assert not (tmp_path / "done").exists()


@pytest.mark.skipif(os.name != "posix", reason="Windows has no modes; its folder is in the user's profile")
def test_the_folder_of_the_link_is_closed_to_others_whatever_the_umask(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.link.paths import meeting_place, password

    monkeypatch.setenv("DAY6_LINK", "tcp")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "run"))
    (tmp_path / "run").mkdir()
    (tmp_path / "run").chmod(0o755)
    before = os.umask(0)
    try:
        place = meeting_place(3)
        password(place)
    finally:
        os.umask(before)
    modes = {
        path.name: stat.S_IMODE(path.stat().st_mode) for path in (tmp_path / "run", *(tmp_path / "run").rglob("*"))
    }
    assert modes == {"run": 0o700, "3": 0o700, "secret": 0o600, "users": 0o600}


@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root can make another user's folder")
def test_a_folder_of_another_user_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from day6_core.link.paths import LinkError, meeting_place

    monkeypatch.setenv("DAY6_LINK", "tcp")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "theirs"))
    (tmp_path / "theirs").mkdir()
    os.chown(tmp_path / "theirs", 12345, 12345)
    with pytest.raises(LinkError, match="belongs to another user"):
        meeting_place(0)
