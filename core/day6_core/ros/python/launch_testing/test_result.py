"""The results of the tests of one launch."""

from __future__ import annotations

import time
import unittest
from collections.abc import Collection
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch_testing.loader import TestRun


class FailResult(unittest.TestResult):
    """All tests of a launch that ended too early have failed."""

    def __init__(self, test_run: TestRun, message: str) -> None:
        super().__init__()
        for case in test_run.all_cases():
            self.addFailure(case, (Exception, Exception(message), None))  # type: ignore[arg-type]
            self.testsRun += 1

    @property
    def testCases(self) -> list[Any]:
        return [case for case, _ in self.failures]

    @property
    def testTimes(self) -> dict[Any, float]:
        return dict.fromkeys(self.testCases, 0)

    def wasSuccessful(self) -> bool:
        return False


class SkipResult(unittest.TestResult):
    """All tests of a launch that is skipped are skipped."""

    def __init__(self, test_run: TestRun, skip_reason: str = "") -> None:
        super().__init__()
        for case in test_run.all_cases():
            self.addSkip(case, skip_reason)
            self.testsRun += 1

    @property
    def testCases(self) -> list[Any]:
        return [case for case, _ in self.skipped]

    @property
    def testTimes(self) -> dict[Any, float]:
        return dict.fromkeys(self.testCases, 0)

    def wasSuccessful(self) -> bool:
        return True


class TestResult(unittest.TextTestResult):
    """Knows all tests that ran, and how long each took (`testTimes`, seconds)."""

    __test__ = False  # no class that pytest collects

    def __init__(self, stream: Any = None, descriptions: Any = None, verbosity: Any = None) -> None:
        self.__begun: dict[Any, float] = {}
        self.__times: dict[Any, float] = {}
        super().__init__(stream, descriptions, verbosity)

    @property
    def testCases(self) -> Collection[Any]:
        return self.__times.keys()

    @property
    def testTimes(self) -> dict[Any, float]:
        return self.__times

    def startTest(self, test: Any) -> None:
        self.__begun[test] = time.monotonic()
        self.__times[test] = 0.0
        super().startTest(test)

    def stopTest(self, test: Any) -> None:
        self.__times[test] = time.monotonic() - self.__begun.pop(test)
        super().stopTest(test)

    def append(self, results: TestResult) -> None:
        """Add the results of further tests of the same launch."""
        self.__times.update(results.testTimes)
        self.testsRun += results.testsRun
        self.failures += results.failures
        self.errors += results.errors
        self.skipped += results.skipped
        self.expectedFailures += results.expectedFailures
        self.unexpectedSuccesses += results.unexpectedSuccesses
