"""The notebook that a class begins with (hub/first_steps.ipynb), from its first cell to its last."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.notebook.kernel import Kernel

FILE = Path(__file__).resolve().parents[2] / "hub" / "first_steps.ipynb"


def cells() -> list[str]:
    found: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))["cells"]
    return ["".join(each["source"]) for each in found if each["cell_type"] == "code"]


@pytest.mark.process
def test_every_cell_does_what_the_text_above_it_says(kernel: Kernel) -> None:
    load, init, talker, listener, nodes, topic, stop, driver, pose, end = cells()
    assert "ROS 2 is ready" in kernel.run(load)
    assert kernel.run(init) == ""
    assert "does nothing" in kernel.run(init)
    talks, hears = kernel.start(talker), kernel.start(listener)
    kernel.wait(lambda: "said hello 2" in kernel.shown[talks], talks)
    kernel.wait(lambda: "I heard hello" in kernel.shown[hears], hears)
    assert {"/listener", "/talker"} <= set(kernel.run(nodes).split())
    assert "Publisher count: 1" in kernel.run(topic)
    assert "messages" in kernel.run(stop)
    assert kernel.run("%ros2 node list --no-daemon").split() == []

    kernel.run(driver)
    assert kernel.run(pose) == "None\n"  # as the text says of a graph without a turtle
    turtle = kernel.start("%ros2 run turtlesim turtlesim_node &")  # in place of the tile's
    kernel.wait(lambda: "Spawning turtle" in kernel.shown[turtle], turtle)
    kernel.run(driver)
    kernel.until("driver.pose is not None and driver.pose.theta != 0.0")
    assert kernel.run(pose).startswith("turtlesim.msg.Pose(x=")
    assert kernel.run(end) == ""
    assert kernel.run("print(rclpy.ok())") == "False\n"
    assert kernel.run(init) == ""


def test_it_is_kept_without_outputs() -> None:
    found = json.loads(FILE.read_text(encoding="utf-8"))["cells"]
    code = [each for each in found if each["cell_type"] == "code"]
    assert code and not [each for each in code if each["outputs"] or each["execution_count"]]
