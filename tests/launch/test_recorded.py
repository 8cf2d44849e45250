"""Every recorded launch of the real `ros2 launch`, against ours."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor

import pytest

from tests.launch.launch_cases import Case, Outcome, differences, load_cases, our_command, play
from tests.support.short_folder import make_short_folder

KNOWN = {
    "no_such_executable": "the real one prints the address of an object where ours names the executable",
}
"""Cases that differ, with the reason."""

CASES = load_cases()
pytestmark = [
    pytest.mark.process,
    pytest.mark.skipif(os.name == "nt", reason="recorded where there are signals and a sh"),
]


@pytest.fixture(scope="module")
def outcomes(request: pytest.FixtureRequest) -> Iterator[dict[str, Future]]:
    """Play the cases that will be asked for, some at a time: a launch waits for its processes most of the time.

    In a folder without blanks, as where they were recorded: commands of launch files name files below it.
    """
    folder = make_short_folder()
    wanted = [item.callspec.params["case"] for item in request.session.items if item.module is request.module]
    command, environment = our_command()

    def start(case: Case, domain: int) -> Outcome:
        return play(case, folder / case.name, command, {**environment, "ROS_DOMAIN_ID": str(domain)})

    with ThreadPoolExecutor(4) as pool:
        yield {case.name: pool.submit(start, case, domain) for domain, case in enumerate(wanted, 20)}
    shutil.rmtree(folder, ignore_errors=True)


@pytest.mark.parametrize("case", [pytest.param(case, id=case.name) for case in CASES])
def test_a_launch_goes_as_with_the_real_one(case: Case, outcomes: dict[str, Future]) -> None:
    assert case.expected is not None
    found = differences(case.expected, outcomes[case.name].result())
    if case.name in KNOWN:
        assert found, f"{case.name} is equal now, although: {KNOWN[case.name]}"
        pytest.xfail(KNOWN[case.name])
    assert not found, found
