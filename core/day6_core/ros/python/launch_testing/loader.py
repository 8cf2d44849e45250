"""Makes the test runs of a module: a `generate_test_description`, with the tests beside its launch and those after it."""

from __future__ import annotations

import functools
import inspect
import unittest
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import ModuleType
from typing import Any

from launch import LaunchDescription

from launch_testing.actions.ready import ReadyToTest

READY_TIMEOUT = 15.0
"""Seconds until `ReadyToTest` has to be executed, unless `ready_to_test_action_timeout` says otherwise."""


class TestRun:
    """One launch with its tests; `param_args` are what `parametrize` gives it, `{name: value}`."""

    __test__ = False  # no class that pytest collects

    def __init__(
        self,
        name: str,
        test_description_function: Callable[..., Any],
        param_args: Mapping[str, Any],
        pre_shutdown_tests: Any,
        post_shutdown_tests: Any,
    ) -> None:
        self.name = name
        self.param_args = param_args
        self.pre_shutdown_tests = pre_shutdown_tests
        self.post_shutdown_tests = post_shutdown_tests
        self._test_description_function = test_description_function
        self.timeout: float = getattr(test_description_function, "__ready_to_test_action_timeout__", READY_TIMEOUT)
        for suite in (*_suites(pre_shutdown_tests), *_suites(post_shutdown_tests)):
            suite._cleanup = False  # type: ignore[attr-defined]  # the cases are still needed when they have run
        if param_args:
            for case in self.all_cases():
                renamed = case._testMethodName + self._format_params()
                setattr(case, renamed, getattr(case, case._testMethodName))
                case._testMethodName = renamed

    @property
    def markers(self) -> dict[str, Any]:
        """What `markers` has noted of the description."""
        return getattr(self._test_description_function, "__markers__", {})

    def normalized_test_description(
        self, *, ready_fn: Callable[[], object]
    ) -> tuple[LaunchDescription, dict[str, Any]]:
        """Make the launch description, which will call `ready_fn`, and the context: further arguments for tests.

        Raises Exception if there is no ReadyToTest in it, and whatever its function raises.
        """
        made = self._test_description_function()
        description, context = made if isinstance(made, tuple) else (made, {})
        ready = next(_ready_actions(description.entities), None)
        if ready is None:
            raise Exception(
                "generate_test_description functions must return a LaunchDescription containing a ReadyToTest action"
            )
        ready._add_callback(ready_fn)
        return description, context

    def get_launch_description(self) -> LaunchDescription:
        """Make the launch description to look at it, not to launch it."""
        return self.normalized_test_description(ready_fn=lambda: None)[0]

    def bind(
        self,
        tests: Any,
        injected_attributes: Mapping[str, Any] | None = None,
        injected_args: Mapping[str, Any] | None = None,
    ) -> None:
        """Give objects to tests: as attributes of their classes, and as the arguments of that name of their methods."""
        arguments = injected_args or {}
        for case in _cases(tests):
            for method in (case._testMethodName, "setUp", "tearDown"):
                setattr(case, method, _bound(getattr(case, method), arguments))
        for test_class in dict.fromkeys(map(type, _cases(tests))):
            for name, value in (injected_attributes or {}).items():
                setattr(test_class, name, property(functools.partial(_warned_of, name=name, value=value)))
            for method in ("setUpClass", "tearDownClass"):
                setattr(test_class, method, _bound(getattr(test_class, method), arguments))

    def all_cases(self) -> Iterator[Any]:
        yield from _cases(self.pre_shutdown_tests)
        yield from _cases(self.post_shutdown_tests)

    def __str__(self) -> str:
        return self.name + self._format_params()

    def _format_params(self) -> str:
        return f"[{', '.join(map(str, self.param_args.values()))}]" if self.param_args else ""


def LoadTestsFromPythonModule(module: ModuleType, *, name: str = "launch_tests") -> list[TestRun]:
    """Return the runs of a module with a `generate_test_description`: one, or one for each value of `parametrize`."""
    function = module.generate_test_description
    descriptions = function() if hasattr(function, "__parametrized__") else [(function, {})]
    return [
        TestRun(
            name,
            description,
            arguments,
            PreShutdownTestLoader().loadTestsFromModule(module),
            PostShutdownTestLoader().loadTestsFromModule(module),
        )
        for description, arguments in descriptions
    ]


def PreShutdownTestLoader() -> unittest.TestLoader:
    """Return a loader of the tests for the launch."""
    return _TestLoader(post_shutdown=False)


def PostShutdownTestLoader() -> unittest.TestLoader:
    """Return a loader of the tests for the time after the launch."""
    return _TestLoader(post_shutdown=True)


class _TestLoader(unittest.TestLoader):
    """Loads the classes with or those without `post_shutdown_test`, each as a class of its own for every run."""

    def __init__(self, post_shutdown: bool) -> None:
        super().__init__()
        self._post_shutdown = post_shutdown

    def loadTestsFromTestCase(self, testCaseClass: type[unittest.TestCase]) -> unittest.TestSuite:
        if getattr(testCaseClass, "__post_shutdown_test__", False) != self._post_shutdown:
            return unittest.TestSuite()
        own = type(testCaseClass.__name__, (testCaseClass,), {"__module__": testCaseClass.__module__})
        return super().loadTestsFromTestCase(own)


def _ready_actions(entities: Iterable[Any]) -> Iterator[ReadyToTest]:
    """Yield the ReadyToTest actions among entities, however deep."""
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from _ready_actions(entity.describe_sub_entities())
        for _, conditional in entity.describe_conditional_sub_entities():
            yield from _ready_actions(conditional)


def _suites(tests: Any) -> Iterator[unittest.TestSuite]:
    if isinstance(tests, unittest.TestSuite):
        yield tests
        for test in tests:
            yield from _suites(test)


def _cases(tests: Any) -> Iterator[Any]:
    if isinstance(tests, Iterable):
        for test in tests:
            yield from _cases(test)
    else:
        yield tests


def _bound(function: Callable[..., Any], candidates: Mapping[str, Any]) -> Callable[..., Any]:
    """Return a function to which those of the arguments are given that it has."""
    names = inspect.signature(function).parameters
    return functools.partial(function, **{name: value for name, value in candidates.items() if name in names})


def _warned_of(test: Any, *, name: str, value: Any) -> Any:
    """Return an injected attribute, with a warning once a test."""
    if "_warned_of_attributes" not in test.__dict__:
        test._warned_of_attributes = True
        warnings.warn(
            f"Automatically adding attributes like self.{name} to the test class will be deprecated in a future release.  "
            f"Instead, add {name} to the test method argument list to access the test object you need",
            stacklevel=2,
        )
    return value
