"""Descriptions made to do harm: every tool that reads them answers, soon, in little memory, and says why not."""

from __future__ import annotations

import subprocess
import sys
import textwrap
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_urdf import check_text, load_robot, parse_robot
from day6_urdf.kinematics import link_transforms
from day6_urdf.load import RobotError
from day6_urdf.topview.plan import plan_top
from day6_urdf.topview.view import render_top

LAUGHS = (
    "<!DOCTYPE r ["
    + "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10 if n else "ha"}">' for n in range(10))
    + ']><robot name="&l9;"><link name="&l9;"/></robot>'
)

EXTERNAL = '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="r"><link name="&x;"/></robot>'


def chain(count: int, kind: str = "fixed") -> str:
    links = "".join(f'<link name="l{n}"/>' for n in range(count))
    joints = "".join(
        f'<joint name="j{n}" type="{kind}"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
        for n in range(count - 1)
    )
    return f'<robot name="r">{links}{joints}</robot>'


LOOP = """<robot name="r"><link name="root"/><link name="a"/><link name="b"/>
<joint name="j" type="fixed"><parent link="root"/><child link="a"/></joint>
<joint name="k" type="fixed"><parent link="a"/><child link="b"/></joint>
<joint name="l" type="fixed"><parent link="b"/><child link="a"/></joint></robot>"""

TEXTS: dict[str, Callable[[], str]] = {
    "billion laughs": lambda: LAUGHS,
    "external entity": lambda: EXTERNAL,
    "nothing": lambda: "",
    "zeros": lambda: "\0" * 10_000,
    "half a million open tags": lambda: "<a>" * 500_000,
    "a tag that never ends": lambda: "<robot " + "a" * 1_000_000,
    "as many attributes": lambda: "<robot " + " ".join(f'a{n}="1"' for n in range(50_000)) + "/>",
    "quotes": lambda: '<robot name="' * 100_000,
    "comments": lambda: "<!--" * 300_000,
    "a loop": lambda: LOOP,
    "two roots": lambda: '<robot name="r"><link name="a"/><link name="b"/></robot>',
    "a chain of five thousand": lambda: chain(5000),
    "wheels of no size": lambda: chain(3, "continuous").replace(
        '<link name="l1"/>',
        '<link name="l1"><visual><geometry><cylinder radius="0" length="0"/></geometry></visual></link>',
    ),
    "an axis of nothing": lambda: chain(2, "continuous").replace("</joint>", '<axis xyz="0 0 0"/></joint>'),
    "sizes beyond all numbers": lambda: chain(2).replace(
        '<link name="l1"/>',
        '<link name="l1"><visual><geometry><box size="1e308 1e308 1e308"/></geometry></visual></link>',
    ),
    "fifty megabytes": lambda: "<robot name='r'>" + "<link/>" * 7_200_000,
}


@pytest.mark.long
@pytest.mark.parametrize("name", TEXTS)
def test_it_is_answered_soon(name: str) -> None:
    text = TEXTS[name]()
    began = time.process_time()
    report = check_text(text)
    assert report.robot is not None or report.diagnostics
    if report.robot is not None and not report.robot.loop:
        assert link_transforms(report.robot, {})
        rows = render_top(plan_top(report.robot), {}, 60, 20)
        assert len(rows) == 20
    assert time.process_time() - began < 8.0


@pytest.mark.parametrize("text", [LAUGHS, EXTERNAL], ids=["billion laughs", "external entity"])
def test_entities_are_left_as_they_are_written(text: str) -> None:
    robot = check_text(text).robot
    assert robot is not None
    assert robot.links[0].name in ("&l9;", "&x;")


def test_yourdfpy_gets_no_entity_and_no_document_type() -> None:
    for text in (LAUGHS, EXTERNAL):
        assert load_robot(text).links[0].name in ("&l9;", "&x;")


def test_two_roots_and_fifty_megabytes_say_why() -> None:
    for name, said in (("two roots", "Two root links found: [a] and [b]"), ("fifty megabytes", "too large: 50.4 MB")):
        with pytest.raises(RobotError) as error:
            parse_robot(TEXTS[name]())
        assert said in str(error.value)


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="measures memory with the module resource")
def test_reading_harm_from_a_file_stays_small(tmp_path: Path) -> None:
    """In a process of its own: 50 MB on the disk may not become 50 MB in memory."""
    file = tmp_path / "huge.urdf"
    with file.open("w") as out:
        for _ in range(50):
            out.write("<link name='a'/>" * 65_536)
    code = f"""
        import resource
        from day6_urdf.check import check_file
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        report = check_file({str(file)!r})
        after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        print(report.diagnostics[0].text)
        print(after - before)
    """
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True, timeout=60)
    said, grown = done.stdout.splitlines()
    assert said == "The robot description is too large: 52.4 MB, more than 4 MB are not read"
    assert int(grown) < 20_000  # kB
