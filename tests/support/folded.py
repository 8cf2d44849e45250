"""One test for very many cases of plain data: cheap to collect, and told case by case where it fails.

Only for functions of their arguments. What needs a fixture's fresh state, a process or a file for every case stays parametrised.
"""

from __future__ import annotations

import functools
import inspect
import json
import os
from collections.abc import Callable, Iterable
from typing import Any

import pytest

SHOWN = 20
"""Cases that are told with their whole difference; of more only the names."""


def folded(
    names: str, values: Iterable[Any], ids: Callable[[Any], str] = repr
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Use in the place of `pytest.mark.parametrize`: the function is one test, which runs every case and tells each that fails.

    A case that skips itself counts as failed, and so does a run without any case. `PYTEST_CASE='part of its name'` chooses cases;
    the file PYTEST_CASES_TO gets a line of JSON for each: test, case, whether it passed.
    """
    split = [name.strip() for name in names.split(",")]
    cases = list(values)
    report = os.environ.get("PYTEST_CASES_TO")

    def decorate(function: Callable[..., None]) -> Callable[..., None]:
        @functools.wraps(function)
        def all_cases(**fixtures: Any) -> None:
            wanted = os.environ.get("PYTEST_CASE", "")
            chosen = [(name, value) for value in cases if wanted in (name := ids(value))]
            failed = []
            for name, value in chosen:
                arguments = zip(split, value if len(split) > 1 else (value,), strict=True)
                try:
                    function(**fixtures, **dict(arguments))
                except (Exception, pytest.fail.Exception, pytest.skip.Exception, pytest.xfail.Exception) as error:
                    failed.append((name, _told(error) if len(failed) < SHOWN else ""))
            if report is not None:
                names_of_failed = {name for name, _ in failed}
                with open(report, "a", encoding="utf-8") as file:
                    for name, _ in chosen:
                        file.write(json.dumps([function.__name__, name, name not in names_of_failed]) + "\n")
            if failed or not chosen:
                texts = [f"-- {name}\n{text}".rstrip() for name, text in failed]
                pytest.fail("\n".join([f"{len(failed)} of {len(chosen)} cases failed", *texts]), pytrace=False)

        own = inspect.signature(function)
        rest = [each for name, each in own.parameters.items() if name not in split]
        all_cases.__signature__ = own.replace(parameters=rest)  # type: ignore[attr-defined]
        return all_cases

    return decorate


def _told(error: BaseException) -> str:
    """Return the lines of a failure, from the test's function on."""
    info = pytest.ExceptionInfo.from_exception(error)
    info.traceback = info.traceback[1:]
    return str(info.getrepr(style="short"))
