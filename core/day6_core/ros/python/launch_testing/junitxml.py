"""Writes results as JUnit XML: a `testsuites` with a `testsuite` for each launch."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from typing import Any


def unittestResultsToXml(
    *, name: str = "launch_test", test_results: Mapping[Any, Any] | None = None
) -> ElementTree.ElementTree:
    """Return the document of `{launch: result}`; the results are those of `test_result`."""
    results = test_results or {}
    root = ElementTree.Element("testsuites", name=name)
    root.set("tests", str(sum(result.testsRun for result in results.values())))
    root.set("failures", str(sum(len(result.failures) for result in results.values())))
    root.set("errors", str(sum(len(result.errors) for result in results.values())))
    root.set("time", _seconds(sum(sum(result.testTimes.values()) for result in results.values())))
    root.extend(unittestResultToXml(str(run), result) for run, result in results.items())
    return ElementTree.ElementTree(root)


def unittestResultToXml(name: str, test_result: Any) -> ElementTree.Element:
    """Return the `testsuite` of one launch."""
    suite = ElementTree.Element("testsuite", name=name, tests=str(test_result.testsRun))
    for outcome in ("failures", "errors", "skipped"):
        suite.set(outcome, str(len(getattr(test_result, outcome))))
    suite.set("time", _seconds(sum(test_result.testTimes.values())))
    suite.extend(unittestCaseToXml(test_result, case) for case in test_result.testCases)
    return suite


def unittestCaseToXml(test_result: Any, test_case: Any) -> ElementTree.Element:
    """Return the `testcase` of one test, with what is wrong with it."""
    method, _, qualifiers = test_case.id().partition(" ")
    class_name, _, name = method.rpartition(".")
    element = ElementTree.Element("testcase", classname=class_name, name=f"{name} {qualifiers}".strip())
    element.set("time", _seconds(test_result.testTimes[test_case]))
    for tag, outcomes in (
        ("failure", test_result.failures),
        ("error", test_result.errors),
        ("skipped", test_result.skipped),
    ):
        for case, message in outcomes:
            if case == test_case:
                ElementTree.SubElement(element, tag, message=message)
    return element


def _seconds(time: float) -> str:
    return str(round(time, 3))
