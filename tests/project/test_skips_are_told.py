"""The end of a test run: what was skipped and why, also where several processes run the tests."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

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


@pytest.mark.process
@pytest.mark.parametrize("processes", ["0", "2"])
def test_a_run_ends_with_a_list_of_what_was_skipped_and_why(tmp_path: Path, processes: str) -> None:
    for name, code in SUITE.items():
        (tmp_path / name).write_text("\n".join(line[8:] for line in code.splitlines()), encoding="utf-8")
    done = subprocess.run(
        # In the usual place for temporary files pytest removes those of earlier runs, gigabytes after a whole suite.
        [
            *(sys.executable, "-m", "pytest", "-q", "-p", "conftest", "-p", "no:cacheprovider"),
            *("-n", processes, f"--basetemp={tmp_path / 'base'}", "."),
        ],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(TESTS), "PYTEST_ADDOPTS": "", "COLUMNS": "80"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    skipped = next(n for n, line in enumerate(lines) if " skipped here: 5 " in line)
    assert lines[skipped + 1 : skipped + 3] == [
        "   4  no such tool here  (test_one.py, test_three.py)",
        "   1  no such library here  (test_two.py)",
    ]
    assert " known differences: 1 " in lines[skipped + 3]
    assert lines[skipped + 4] == "   1  the original is wrong  (test_one.py)"
