"""Checks and reports of `ros2 doctor`, its own and those that other packages register."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ros2cli.entry_points import load_entry_points
from ros2cli.node.strategy import NodeStrategy

from day6_core.ros.ros2 import doctor
from ros2doctor.api.format import doctor_error, doctor_warn


class DoctorCheck:
    """A check. A subclass has both methods."""

    def category(self) -> str:
        """Return its name among the failed modules."""
        raise NotImplementedError

    def check(self) -> Result:
        """Look, and return how much is wrong."""
        raise NotImplementedError


class DoctorReport:
    """A report. A subclass has both methods."""

    def category(self) -> str:
        """Return the category of the check it belongs to."""
        raise NotImplementedError

    def report(self) -> Report:
        """Return what there is."""
        raise NotImplementedError


class Report:
    """A title with rows of names and values."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.items: list[tuple[str, Any]] = []

    def add_to_report(self, item_name: str, item_info: Any) -> None:
        """Add a row."""
        self.items.append((item_name, item_info))


class Result:
    """How many errors and warnings a check has found."""

    def __init__(self) -> None:
        self.error = 0
        self.warning = 0

    def add_error(self) -> None:
        """Count an error."""
        self.error += 1

    def add_warning(self) -> None:
        """Count a warning."""
        self.warning += 1


def own_check(category: str) -> type[DoctorCheck]:
    """Return the class of a check of `ros2 doctor`, by its category."""

    class OwnCheck(DoctorCheck):
        """A check of `ros2 doctor`."""

        def category(self) -> str:
            return category

        def check(self) -> Result:
            from day6_core.ros.ros2.cli.embedded import run

            result = Result()
            for finding in run(["doctor"], lambda session: doctor.findings(session, category)):
                (doctor_error if finding.is_error else doctor_warn)(finding.text)
                (result.add_error if finding.is_error else result.add_warning)()
            return result

    return OwnCheck


def own_report(title: str) -> type[DoctorReport]:
    """Return the class of a report of `ros2 doctor`, by its title."""

    class OwnReport(DoctorReport):
        """A report of `ros2 doctor`."""

        def category(self) -> str:
            return doctor.REPORTS[title][0]

        def report(self) -> Report:
            from day6_core.ros.ros2.cli.embedded import run

            made = Report(title)
            made.items = run(["doctor"], lambda session: doctor.rows(session, title))
            return made

    return OwnReport


def _all(own: Iterable[type[Any]], group: str) -> list[Any]:
    return [kind() for kind in (*own, *load_entry_points(group).values())]


def run_checks(*, include_warnings: bool = False, exclude_packages: bool = False) -> tuple[set[str], int, int]:
    """Run all checks; return the categories that fail, how many fail, and how many there are."""
    checks = _all(map(own_check, doctor.CHECKS), "ros2doctor.checks")
    chosen = [each for each in checks if not (exclude_packages and each.category() == "package")]
    results = [(each.category(), each.check()) for each in chosen]
    failed = [name for name, result in results if result.error or (include_warnings and result.warning)]
    return set(failed), len(failed), len(chosen)


def generate_reports(*, categories: Any = None, exclude_packages: bool = False) -> list[Report]:
    """Return all reports, or those of some categories."""
    reports = _all(map(own_report, doctor.reports()), "ros2doctor.report")
    return [
        each.report()
        for each in reports
        if (categories is None or each.category() in categories)
        and not (exclude_packages and each.category() == "package")
    ]


def get_topic_names(skip_topics: Iterable[str] = ()) -> list[str]:
    """Return the topics there are, without some."""
    skipped = set(skip_topics)
    with NodeStrategy(None) as node:
        return [name for name, _ in node.get_topic_names_and_types() if name not in skipped]
