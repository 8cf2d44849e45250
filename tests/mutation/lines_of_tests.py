"""A pytest plugin for `sample.py`: writes down which lines of a part each test runs, and how long it takes."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Generator
from pathlib import Path

import coverage
import pytest

ROOT = Path(__file__).resolve().parents[2]
MEASURED = coverage.Coverage(data_file=None, source=[str(ROOT / os.environ["MUTATION_SOURCE"])], config_file=False)
OUT = Path(os.environ["MUTATION_OUT"])
SECONDS: dict[str, float] = {}
FAILED: list[str] = []
MEASURED.start()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    MEASURED.switch_context(item.nodeid)
    start = time.perf_counter()
    try:
        return (yield)
    finally:
        SECONDS[item.nodeid] = time.perf_counter() - start
        MEASURED.switch_context("")


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.failed:
        FAILED.append(report.nodeid)


def pytest_sessionfinish() -> None:
    MEASURED.stop()
    data = MEASURED.get_data()
    lines = {
        str(Path(file).resolve().relative_to(ROOT)): {
            line: [name for name in names if name] for line, names in data.contexts_by_lineno(file).items()
        }
        for file in data.measured_files()
    }
    OUT.write_text(json.dumps({"lines": lines, "seconds": SECONDS, "failed": FAILED}), encoding="utf-8")
