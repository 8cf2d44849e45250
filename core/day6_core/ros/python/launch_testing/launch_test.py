"""The command `launch_test`: runs the launch test in a file."""

from __future__ import annotations

import argparse
import importlib.util
import logging
import os
import sys
import warnings
from types import ModuleType

from launch_testing.junitxml import unittestResultsToXml
from launch_testing.loader import LoadTestsFromPythonModule
from launch_testing.print_arguments import print_arguments_of_launch_description
from launch_testing.test_runner import LaunchTestRunner

_logger = logging.getLogger(__name__)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's options."""
    parser.add_argument("launch_test_file", help="Path to the launch test.")
    parser.add_argument(
        "--package-name",
        action="store",
        default=None,
        help="Name of the package the test is in. Useful to aggregate xUnit reports.",
    )
    parser.add_argument("-v", "--verbose", action="store_true", default=False, help="Run with verbose output")
    parser.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        action="store_true",
        default=False,
        help="Show arguments that may be given to the launch test.",
    )
    parser.add_argument(
        "launch_arguments",
        nargs="*",
        help="Arguments in '<name>:=<value>' format (for duplicates, last one wins).",
    )
    parser.add_argument(
        "--junit-xml", action="store", dest="xmlpath", default=None, help="Do write xUnit reports to specified path."
    )


def parse_arguments() -> tuple[argparse.ArgumentParser, argparse.Namespace]:
    parser = argparse.ArgumentParser(prog="launch_test", description="Launch integration testing tool.")
    add_arguments(parser)
    return parser, parser.parse_args()


def run(
    parser: argparse.ArgumentParser,
    args: argparse.Namespace,
    test_runner_cls: type[LaunchTestRunner] = LaunchTestRunner,
) -> int:
    """Run the launch test that the options name; returns an exit status. Raises what is wrong with it."""
    if not os.path.isfile(args.launch_test_file):
        parser.error(f"Test file '{args.launch_test_file}' does not exist")
    path = os.path.abspath(args.launch_test_file)
    base = os.path.splitext(os.path.basename(path))[0]
    package = args.package_name or base
    runs = LoadTestsFromPythonModule(_module(package, path), name=f"{package}.{base}.launch_tests")
    runner = test_runner_cls(test_runs=runs, launch_file_arguments=args.launch_arguments, debug=args.verbose)
    runner.validate()
    if args.show_args:
        print_arguments_of_launch_description(launch_description=runs[0].get_launch_description())
        return 0
    _logger.debug("Running integration test")
    results = runner.run()
    _logger.debug("Done running integration test")
    if args.xmlpath:
        document = unittestResultsToXml(test_results=results, name=f"{package}.{base}")
        document.write(args.xmlpath, encoding="utf-8", xml_declaration=True)
    return 0 if all(result.wasSuccessful() for result in results.values()) else 1


def _module(name: str, path: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise ImportError(f"Test file '{path}' is not a Python file")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main() -> None:
    logging.basicConfig()
    warnings.formatwarning = lambda message, *args, **kwargs: f"Warning: {message}{os.linesep}"
    parser, args = parse_arguments()
    if args.verbose:
        _logger.setLevel(logging.DEBUG)
        _logger.debug("Running with verbose output")
    try:
        status = run(parser, args)
    except Exception as error:
        parser.error(str(error))
    sys.exit(status)


if __name__ == "__main__":
    main()
