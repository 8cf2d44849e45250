"""Where a lesson leaves a pupil who made no mistake there is nothing to warn of: after every step of the six days.

Some steps leave something wrong on purpose, or half done for the next one: these are named, and then it has to be found.
"""

from __future__ import annotations

import pytest

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.document import Step
from day6_core.lessons.reading import read_lesson
from tests.inspector.lab import Lab
from tests.inspector.lesson_player import play

ON_PURPOSE = {
    ("day4", "not-found"): {"not_sourced"},  # the new package is not found before it is sourced
    ("day4", "wrong-place"): {"inner_package"},  # a package that was made in the wrong folder
    ("day5", "skeleton"): {"not_rebuilt"},  # written from here on, built in the step "run"
    ("day5", "publisher"): {"not_rebuilt"},
    ("day5", "timer"): {"not_rebuilt"},
    ("day5", "entry-point"): {"not_rebuilt"},
    ("day5", "no-rebuild"): {"not_rebuilt"},  # why did nothing change?
    ("day5", "listener"): {"not_rebuilt"},  # built in the next step
    ("day6", "start"): {"fixed_frame", "no_robot_model"},  # RViz is open: where is the car?
    ("day6", "frame"): {"no_robot_model"},  # the display comes in the next step
    ("day6", "model"): {"no_joint_states"},  # nobody turns the wheels yet
    ("day6", "spinner"): {"no_joint_states", "not_rebuilt"},  # who turns them is written, and built in the next step
    ("day6", "fight"): {"fight"},
}
"""Lesson and step -> the findings that belong to it."""

LOOKED = 2
"""Looks of the inspector after a step."""

DAYS = {path.stem: path for path in (HERE / "days").glob("*.md")}


@pytest.mark.process
@pytest.mark.virtual_time
@pytest.mark.parametrize("name", sorted(DAYS))
def test_after_a_step_there_is_no_alarm_but_what_the_step_is_about(lab: Lab, name: str) -> None:
    wrong: list[str] = []

    def look(step: Step) -> None:
        said, wanted = lab.stays_silent(LOOKED), ON_PURPOSE.get((name, step.name), set())
        wrong.extend(f"{step.name}: {key}: {text}" for key, text in said.items() if key not in wanted)
        missing = [key for key in wanted - set(said) if lab.finds(key)[0] is None]
        wrong.extend(f"{step.name}: {key} is not found" for key in missing)

    play(lab, read_lesson(DAYS[name]), look)
    assert not wrong, "\n".join(wrong)


def test_the_steps_on_purpose_are_there() -> None:
    assert set(ON_PURPOSE) <= {(name, step.name) for name, path in DAYS.items() for step in read_lesson(path).steps}
