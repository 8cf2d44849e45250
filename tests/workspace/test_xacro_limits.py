"""xacro files without end: they are ended with status 2 and a message, and nothing waits for them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from launch import LaunchContext
from launch.substitutions import Command
from launch.substitutions.substitution_failure import SubstitutionFailure

from day6_core.ros.programs.xacro import xacro as program
from tests.workspace.workshop import Workshop

pytestmark = pytest.mark.process

HEAD = '<?xml version="1.0"?>\n{}<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>\n'
LAUGHS = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12))
MACROS = "".join(f'<xacro:macro name="m{n}">{f"<xacro:m{n - 1}/>" * 10}</xacro:macro>' for n in range(1, 12))
OUT_OF_TIME = "error: xacro was ended: it needed more than 1 seconds of the processor\n"
OUT_OF_MEMORY = "error: xacro was ended: it needed more than 1024 megabytes of memory\n"


def write(folder: Path, body: str, head: str = "") -> Path:
    file = folder / "endless.xacro"
    file.write_text(HEAD.format(head, body), encoding="utf-8")
    return file


@pytest.mark.parametrize(
    "body",
    [
        '<a v="${9**9**9}"/>',
        '<a v="${max(range(10**12))}"/>',
        f'{MACROS}<xacro:macro name="m0"><link/></xacro:macro><xacro:m11/>',
    ],
    ids=["power", "range", "macros"],
)
def test_what_takes_for_ever_ends_by_the_limit_of_time_and_the_desktop_goes_on_meanwhile(
    workshop: Workshop, body: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program, "CPU_SECONDS", 1)
    write(workshop.workspace, body)
    running = workshop.start("xacro endless.xacro > out.urdf")
    assert workshop.run("echo meanwhile").out == "meanwhile\n"
    assert running.program.status is None  # so the echo did not wait for it
    workshop.wait(lambda: running.program.status is not None)
    assert running.program.status == 2
    assert running.err.text.endswith(OUT_OF_TIME)
    assert (workshop.workspace / "out.urdf").read_text(encoding="utf-8") == ""


@pytest.mark.parametrize(
    ("body", "head", "said"),
    [
        ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "", "error: maximum recursion depth exceeded"),
        ('<xacro:include filename="endless.xacro"/>', "", "error: maximum recursion depth exceeded"),
        (
            '<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/><x v="${a}"/>',
            "",
            "error: circular variable definition: a -> b -> a",
        ),
        ("&e11;", f'<!DOCTYPE r [<!ENTITY e0 "lol">{LAUGHS}]>', "XML parsing error: limit on input amplification"),
    ],
    ids=["macro", "include", "property", "entities"],
)
def test_what_goes_round_in_circles_is_told_in_the_words_of_the_real_one(
    workshop: Workshop, body: str, head: str, said: str
) -> None:
    write(workshop.workspace, body, head)
    done = workshop.run("xacro endless.xacro")
    assert done.status == 2 and done.out == ""
    assert said in done.err and "Traceback" not in done.err


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux limits the memory of a process")
@pytest.mark.parametrize("expression", ["'a' * 10**10", "[0] * 10**10", "list(range(10**10))", "'%10000000000d' % 1"])
def test_what_takes_all_memory_ends_by_the_limit_of_memory(workshop: Workshop, expression: str) -> None:
    write(workshop.workspace, f'<a v="${{{expression}}}"/>')
    done = workshop.run("ros2 run xacro xacro endless.xacro")
    assert (done.status, done.out) == (2, "[ros2run]: Process exited with failure 2\n")
    assert done.err.endswith(OUT_OF_MEMORY)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux limits the memory of a process")
def test_in_a_launch_file_and_in_a_real_terminal_too(tmp_path: Path) -> None:
    file = write(tmp_path, "<a v=\"${'a' * 10**10}\"/>")
    with pytest.raises(SubstitutionFailure) as failure:
        Command(["xacro '", str(file), "'"]).perform(LaunchContext())
    assert str(failure.value).startswith(f"executed command failed. Command: xacro '{file}'\n")
    assert str(failure.value).endswith(OUT_OF_MEMORY)
    words = [sys.executable, "-m", "day6_tui.main", "xacro", str(file)]
    done = subprocess.run(words, capture_output=True, text=True, encoding="utf-8", timeout=60)
    assert done.returncode == 2 and done.stderr.endswith(OUT_OF_MEMORY)


@pytest.mark.parametrize("body", ['<link name="${python.range(3)[2] * 2**10}"/>', '<link name="${9**99 % 7}"/>'])
def test_honest_arithmetic_is_not_touched(workshop: Workshop, body: str) -> None:
    write(workshop.workspace, body)
    done = workshop.run("xacro endless.xacro")
    assert done.status == 0 and done.err == ""
    assert ('name="2048"' in done.out) or ('name="1"' in done.out)
