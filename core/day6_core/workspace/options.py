"""The options of `colcon build`, `test`, `test-result`, `list`, `info` and `graph`, in the words of its help: one table.

The parser comes from it (`arguments`), what is said of an option that has no effect here, and the page of the documentation.
Sources: colcon-core 0.21 and the extensions that ROS installs (colcon-common-extensions, colcon-ros, colcon-override-check).
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

from day6_core.workspace.handlers import HANDLERS
from day6_core.workspace.option import Group, Option, Treated, counting_number, definitions_only, no_more_than_warnings

_FLAG: dict[str, Any] = {"action": "store_true"}
_NAMES: dict[str, Any] = {"nargs": "*", "metavar": "PKG_NAME"}
_PATTERNS: dict[str, Any] = {"nargs": "*", "metavar": "PATTERN"}
_PATHS: dict[str, Any] = {"nargs": "*", "metavar": "PATH"}
_ONE_NAME: dict[str, Any] = {"metavar": "PKG_NAME"}
_AGAIN: dict[str, Any] = {"type": int, "default": 0, "metavar": "N"}
_PASSED: dict[str, Any] = {"nargs": "*", "metavar": "*", "type": str.lstrip}
"""Words that belong to another program, even those that begin with a dash."""

_NOT_SHOWN = "(stdout might not be shown by default, e.g. add `--event-handlers console_cohesion+`)"
_WORKERS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 4

_NO_TARGETS = (
    "without CMake there are no targets, and all that needs no compiler is built",
    "这里没有 CMake，也就没有目标；不用编译器的都会编译好",
)
_ONLY_DEFINITIONS = (
    "CMake doesn't run here; of its arguments only -DNAME=VALUE counts",
    "这里不运行 CMake；它的参数里只有 -D名字=值 有用",
)

_BUILD_BASE = Option("--build-base", "The base path for all build directories (default: build)", {"default": "build"})
_INSTALL_BASE = Option(
    "--install-base", "The base path for all install prefixes (default: install)", {"default": "install"}
)
_MERGE = Option("--merge-install", "Merge all install prefixes into a single location", _FLAG)
_RESULTS = Option("--test-result-base", "The base path for all test results (default: same as `--build-base`)")

BEFORE_VERB = Group(
    (
        Option("--log-base", "The base path for all log directories (default: `./log`, to disable: `/dev/null`)"),
        Option(
            "--log-level",
            "Set log level for the console output, either by numeric or string value (default: `warning`)",
            {},
            Treated.SAID,
            (
                "there is nothing below a warning in the log here",
                "这里的日志没有比警告更细的内容",
            ),
            no_more_than_warnings,
        ),
    )
)
"""The options before the verb."""

BUILD = Group(
    (
        _BUILD_BASE,
        _INSTALL_BASE,
        _MERGE,
        Option("--symlink-install", "Use symlinks instead of copying files where possible", _FLAG),
        _RESULTS,
        Option(
            "--continue-on-error",
            "Continue other packages when a package fails to build (packages recursively depending on the failed package "
            "are skipped)",
            _FLAG,
        ),
    )
)
TEST = Group(
    (
        _BUILD_BASE,
        _INSTALL_BASE,
        _MERGE,
        _RESULTS,
        Option("--retest-until-fail", "Rerun tests up to N times if they pass", _AGAIN, apart="again"),
        Option("--retest-until-pass", "Rerun failing tests up to N times", _AGAIN, apart="again"),
        Option(
            "--abort-on-error",
            "Abort after the first package with any errors (failing tests are not considered errors in this context)",
            _FLAG,
        ),
        Option("--return-code-on-test-failure", "Use a non-zero return code to indicate any test failure", _FLAG),
    )
)
BASE = Group((_BUILD_BASE,))
EXECUTOR = Group(
    (
        Option(
            "--executor",
            "The executor to process all packages (default: parallel)\n"
            "* parallel: Process multiple packages in parallel\n* sequential: Process one package at a time",
            {"choices": ("parallel", "sequential")},
        ),
        Option(
            "--parallel-workers",
            f"The maximum number of packages to process in parallel, or '0' for no limit (default: {_WORKERS})",
            {"type": counting_number, "default": _WORKERS, "metavar": "NUMBER"},
        ),
    ),
    "Executor arguments",
)
EVENTS = Group(
    (
        Option(
            "--event-handlers",
            "Enable (+) or disable (-) event handlers (default: "
            + " ".join(f"{name}{'+' if each.enabled else '-'}" for name, each in HANDLERS.items())
            + ")\n"
            + "\n".join(f"* {name}: {each.summary}" for name, each in HANDLERS.items()),
            {
                "nargs": "*",
                "metavar": ("name1+", "name2-"),
                "choices": [
                    *(f"{name}{'-' if each.enabled else '+'}" for name, each in HANDLERS.items()),
                    *(f"{name}{'+' if each.enabled else '-'}" for name, each in HANDLERS.items()),
                ],
            },
        ),
    ),
    "Event handler arguments",
)
DISCOVERY = Group(
    (
        Option(
            "--ignore-user-meta",
            "Ignore `*.meta` files in the user config directory `~/.colcon/metadata`",
            _FLAG,
        ),
        Option(
            "--metas",
            "The directories containing a `colcon.meta` file or paths to arbitrary files containing the same meta "
            "information (default: ./colcon.meta)",
            {**_PATHS, "default": ["./colcon.meta"]},
        ),
        Option("--base-paths", "The base paths to recursively crawl for packages (default: .)", _PATHS),
        Option("--packages-ignore", "Ignore packages as if they were not discovered", _NAMES),
        Option(
            "--packages-ignore-regex", "Ignore packages where any of the patterns match the package name", _PATTERNS
        ),
        Option(
            "--paths",
            "The paths to check for a package. Use shell wildcards (e.g. `src/*`) to select all direct subdirectories",
            _PATHS,
        ),
    ),
    "Discovery arguments",
)
SELECTION = Group(
    (
        Option("--packages-up-to", "Only process a subset of packages and their recursive dependencies", _NAMES),
        Option(
            "--packages-up-to-regex",
            "Only process a subset of packages and their recursive dependencies, where any of the patterns match the "
            "package name",
            _PATTERNS,
        ),
        Option(
            "--packages-above",
            "Only process a subset of packages and packages which recursively depend on them",
            _NAMES,
        ),
        Option(
            "--packages-above-and-dependencies",
            "Only process a subset of packages and packages which recursively depend on them including all their "
            "recursive dependencies",
            _NAMES,
        ),
        Option(
            "--packages-above-depth",
            "Only process a subset of packages and packages which recursively depend on them up to a given depth",
            {"nargs": "+", "metavar": ("DEPTH", "PKG_NAME")},
        ),
        Option("--packages-select-by-dep", "Only process packages which (recursively) depend on this", _NAMES),
        Option("--packages-skip-by-dep", "Skip packages which (recursively) depend on this", _NAMES),
        Option("--packages-skip-up-to", "Skip a subset of packages and their recursive dependencies", _NAMES),
        Option(
            "--packages-select-build-failed",
            "Only process a subset of packages which have failed to build previously (aborted packages are not "
            "considered errors)",
            _FLAG,
            apart="result",
        ),
        Option(
            "--packages-skip-build-finished",
            "Skip a set of packages which have finished to build previously",
            _FLAG,
            apart="result",
        ),
        Option(
            "--packages-select-test-failures",
            "Only process a subset of packages which had test failures previously",
            _FLAG,
            apart="result",
        ),
        Option(
            "--packages-skip-test-passed",
            "Skip a set of packages which had no test failures previously",
            _FLAG,
            apart="result",
        ),
        Option("--packages-select", "Only process a subset of packages", _NAMES),
        Option("--packages-skip", "Skip a set of packages", _NAMES),
        Option(
            "--packages-select-regex",
            "Only process a subset of packages where any of the patterns match the package name",
            _PATTERNS,
        ),
        Option(
            "--packages-skip-regex",
            "Skip a set of packages where any of the patterns match the package name",
            _PATTERNS,
        ),
        Option("--packages-start", "Skip packages before this in flat topological ordering", _ONE_NAME),
        Option("--packages-end", "Skip packages after this in flat topological ordering", _ONE_NAME),
        Option(
            "--allow-overriding",
            "Allow building packages that exist in underlay workspaces",
            {"action": "extend", "default": [], "nargs": "+", "metavar": "PKG_NAME"},
        ),
    ),
    "Package selection arguments",
)
CMAKE = Group(
    (
        Option(
            "--cmake-args",
            "Pass arguments to CMake projects. Arguments matching other options must be prefixed by a space,\n"
            f'e.g. --cmake-args " --help" {_NOT_SHOWN}',
            _PASSED,
            Treated.SAID,
            _ONLY_DEFINITIONS,
            definitions_only,
        ),
        Option(
            "--cmake-target",
            "Build a specific target instead of the default target",
            {},
            Treated.REFUSED,
            _NO_TARGETS,
        ),
        Option(
            "--cmake-target-skip-unavailable",
            "Skip building packages which don't have the target passed to --cmake-target",
            _FLAG,
            Treated.SAID,
            _NO_TARGETS,
        ),
        Option(
            "--cmake-clean-cache",
            "Remove CMake cache before the build (implicitly forcing CMake configure step)",
            _FLAG,
        ),
        Option(
            "--cmake-clean-first",
            "Build target 'clean' first, then build (to only clean use '--cmake-target clean')",
            _FLAG,
        ),
        Option("--cmake-force-configure", "Force CMake configure step", _FLAG),
    ),
    "Arguments for 'cmake' packages",
)
"""Nothing of CMake is kept from one build to the next, so the last three are obeyed without doing anything."""

AMENT = Group(
    (
        Option(
            "--ament-cmake-args",
            "Pass arguments to 'ament_cmake' packages. Arguments matching other options must be prefixed by a space",
            _PASSED,
            Treated.SAID,
            _ONLY_DEFINITIONS,
            definitions_only,
        ),
    ),
    "Arguments for 'ros.ament_cmake' packages",
)
CATKIN = Group(
    (
        Option(
            "--catkin-cmake-args",
            "Pass arguments to 'catkin' packages. Arguments matching other options must be prefixed by a space",
            _PASSED,
            Treated.SAID,
            _ONLY_DEFINITIONS,
            definitions_only,
        ),
        Option(
            "--catkin-skip-building-tests",
            "By default the 'tests' target of 'catkin' packages is invoked. If running 'colcon test' later isn't intended "
            "this can be skipped",
            _FLAG,
        ),
    ),
    "Arguments for 'ros.catkin' packages",
)
CTEST = Group(
    (
        Option(
            "--ctest-args",
            "Pass arguments to CTest projects. Arguments matching other options must be prefixed by a space,\n"
            f'e.g. --ctest-args " --help" {_NOT_SHOWN}',
            _PASSED,
            Treated.SAID,
            (
                "CTest doesn't run here: the pytest and launch tests of a CMake package all run",
                "这里不运行 CTest：CMake 包的 pytest 和 launch 测试全都运行",
            ),
        ),
    ),
    "Arguments for 'cmake' packages",
)
PYTHON = Group(
    (
        Option(
            "--python-testing",
            "The Python testing framework to use (default: determined based on the packages `tests_require`)\n"
            "* pytest: Use `pytest` to test Python packages\n* setuppy_test: Use `unittest` to test packages",
            {"choices": ("pytest", "setuppy_test")},
        ),
        Option(
            "--pytest-args",
            "Pass arguments to pytests. Arguments matching other options must be prefixed by a space,\n"
            f'e.g. `--pytest-args " --help"` {_NOT_SHOWN}',
            _PASSED,
        ),
        Option("--pytest-with-coverage", "Generate coverage information", _FLAG),
        Option(
            "--unittest-args",
            "Pass arguments to Python unittests. Arguments matching other options must be prefixed by a space,\n"
            f'e.g. `--unittest-args " --help"` {_NOT_SHOWN}',
            _PASSED,
        ),
    ),
    "Arguments for 'python' packages",
)
LIST = Group(
    (
        Option("--topological-order -t", "Order output based on topological ordering (breadth-first)", _FLAG),
        Option("--names-only -n", "Output only the name of each package but not the path", _FLAG, apart="only"),
        Option("--paths-only -p", "Output only the path of each package but not the name", _FLAG, apart="only"),
    )
)
OBSOLETE = Group(
    tuple(
        Option(f"--topological-graph{name}", f"Instead use `colcon graph{new}`", _FLAG)
        for name, new in {
            " -g": "",
            "-dot": " --dot",
            "-density": " --density",
            "-legend": " --legend",
            "-dot-cluster": " --dot --dot-cluster",
            "-dot-include-skipped": " --dot --dot-include-skipped",
        }.items()
    ),
    "Obsolete arguments",
)
INFO = Group(
    (
        Option(
            "package_names",
            "Only show the information of a subset of packages",
            {"nargs": "*", "metavar": "PKG_NAME"},
        ),
    )
)
GRAPH = Group(
    (
        Option(
            "--dot",
            "Output topological graph in DOT (e.g. pass the output to dot: ` | dot -Tpng -o graph.png`), legend: blue=build, "
            "red=run, tan=test, dashed=indirect",
            _FLAG,
            apart="form",
        ),
        Option("--density", "Output density of the graph (only without --dot)", _FLAG, apart="form"),
        Option("--legend", "Output legend for the graph", _FLAG),
        Option("--dot-cluster", "Cluster packages by their filesystem path (only affects --dot)", _FLAG),
        Option("--dot-include-skipped", "Also output skipped packages (only affects --dot)", _FLAG),
    )
)
RESULT = Group(
    (
        Option(
            "--test-result-base",
            "The base path for all test results (default: build)",
            {"default": "build"},
        ),
        Option("--all", "Show all test result files (even without errors / failures)", _FLAG),
        Option(
            "--result-files-only",
            "Print only the paths of the result files. Use with --all to include files without errors / failures",
            _FLAG,
        ),
        Option("--verbose", "Show additional information for errors / failures", _FLAG),
        Option(
            "--delete",
            "Delete all result files. This might include additional files beside what is listed by --result-files-only. An "
            "interactive prompt will ask for confirmation",
            _FLAG,
        ),
        Option("--delete-yes", "Same as --delete without an interactive confirmation", _FLAG),
    )
)

OPTIONS: dict[str, tuple[Group, ...]] = {
    "build": (BUILD, EXECUTOR, EVENTS, DISCOVERY, SELECTION, CMAKE, AMENT, CATKIN),
    "test": (TEST, EXECUTOR, EVENTS, DISCOVERY, SELECTION, CTEST, PYTHON),
    "test-result": (RESULT,),
    "list": (BASE, DISCOVERY, SELECTION, LIST, OBSOLETE),
    "info": (BASE, DISCOVERY, INFO, SELECTION),
    "graph": (BASE, DISCOVERY, SELECTION, GRAPH),
}
"""verb -> its options, in the order of its help"""


def options_of(verb: str) -> Iterator[Option]:
    """Yield the options of a verb."""
    for group in OPTIONS.get(verb, ()):
        yield from group.options
