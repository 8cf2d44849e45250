"""The end of a test run: what was skipped and why, also where several processes run the tests; what may not be skipped."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.skips import ALLOWED

TESTS = Path(__file__).resolve().parents[1]
SUITE = {
    "test_one.py": """
        import pytest
        needs_tool = pytest.mark.skipif(True, reason="no such tool here")
        @needs_tool
        @pytest.mark.parametrize("n", range(3))
        def test_with_a_tool(n): pass
        @pytest.mark.xfail(reason="the original is wrong")
        def test_that_differs(): assert False
        def test_that_passes(): pass
    """,
    "test_two.py": """
        import pytest
        pytest.importorskip("no_such_module", reason="no such library here")
    """,
    "test_three.py": """
        import pytest
        def test_with_a_tool(): pytest.skip("no such tool here")
    """,
}


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    for name, code in SUITE.items():
        (folder / name).write_text("\n".join(line[8:] for line in code.splitlines()), encoding="utf-8")
    return subprocess.run(
        # In the usual place for temporary files pytest removes those of earlier runs, gigabytes after a whole suite.
        [
            *(sys.executable, "-m", "pytest", "-q", "-p", "tests.conftest", "-p", "no:cacheprovider"),
            *(*words, f"--basetemp={folder / 'base'}", "."),
        ],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(TESTS.parent), "PYTEST_ADDOPTS": "", "COLUMNS": "80"},
        capture_output=True,
        text=True,
    )


@pytest.mark.process
@pytest.mark.parametrize("processes", ["0", "2"])
def test_a_run_ends_with_a_list_of_what_was_skipped_and_why(tmp_path: Path, processes: str) -> None:
    done = run(tmp_path, "-n", processes)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    skipped = next(n for n, line in enumerate(lines) if " skipped here: 5 " in line)
    assert lines[skipped + 1 : skipped + 3] == [
        "   4  no such tool here  (test_one.py, test_three.py)",
        "   1  no such library here  (test_two.py)",
    ]
    assert " known differences: 1 " in lines[skipped + 3]
    assert lines[skipped + 4] == "   1  the original is wrong  (test_one.py)"


@pytest.mark.process
@pytest.mark.parametrize("processes", ["0", "2"])
def test_a_skip_that_is_not_known_fails_the_run_that_is_asked_to(tmp_path: Path, processes: str) -> None:
    reason = next(iter(ALLOWED))
    (tmp_path / "test_four.py").write_text(f"import pytest\ndef test_known(): pytest.skip({reason!r})\n")
    done = run(tmp_path, "-n", processes, "--no-unknown-skips")
    assert done.returncode == 1, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    assert any(" skipped here: 1 " in line for line in lines) and f"   1  {reason}  (test_four.py)" in lines
    unknown = next(n for n, line in enumerate(lines) if "skipped, which fails this run" in line)
    assert lines[unknown + 1] == "   4  no such tool here  (test_one.py, test_three.py)"


def test_every_known_reason_is_one_that_a_test_has() -> None:
    sources = "".join(path.read_text(encoding="utf-8") for path in TESTS.glob("*/test_*.py"))
    assert [reason for reason in ALLOWED if f'"{reason}"' not in sources] == []
