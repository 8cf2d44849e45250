"""The turtles, their trail and their world as plain Python: no node, no clock of its own, no screen.

Time comes in as nanoseconds and goes on in steps of 16 ms. `Simulation` is what the TurtleSim window draws.
"""

from day6_core.ros.programs.turtlesim.model.simulation import (
    CENTRE,
    DEFAULT_BACKGROUND,
    Simulation,
    TurtleScene,
    TurtleTopics,
    TurtleView,
    kinds,
)
from day6_core.ros.programs.turtlesim.model.square import Square
from day6_core.ros.programs.turtlesim.model.trail import PIXELS_PER_METRE, SIZE, Segment, Trail
from day6_core.ros.programs.turtlesim.model.turtle import (
    HEIGHT,
    TICK,
    WIDTH,
    Pose,
    Rotation,
    Turtle,
    TurtleStep,
    float32,
)

__all__ = [
    "CENTRE",
    "DEFAULT_BACKGROUND",
    "HEIGHT",
    "PIXELS_PER_METRE",
    "SIZE",
    "TICK",
    "WIDTH",
    "Pose",
    "Rotation",
    "Segment",
    "Simulation",
    "Square",
    "Trail",
    "Turtle",
    "TurtleScene",
    "TurtleStep",
    "TurtleTopics",
    "TurtleView",
    "float32",
    "kinds",
]
