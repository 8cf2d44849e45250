"""turtlesim_node: the turtles' world as a ROS node with a window (turtlesim/turtle_frame.cpp).

As in the original, one timer of 16 ms does everything: take the messages that are there, move every turtle, publish.
"""

from __future__ import annotations

import random
from functools import partial
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterEvent
from std_srvs.srv import Empty

from day6_core.ros.differences import value
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.turtlesim import model
from day6_core.ros.programs.turtlesim._turtle_interface import TurtleInterface
from day6_core.ros.programs.turtlesim_interfaces import Kill, Spawn
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from day6_core.session.session import Session

CHANNELS = {"background_r": "Red", "background_g": "Green", "background_b": "Blue"}

EVENTS_QOS = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)

TICKS_BETWEEN_LOOKS = 16
"""How often the graph is asked who drives the turtles."""

REST = 31
"""Ticks in which nothing can happen that are passed over at once, about half a second."""

GLIDE = 1
"""Ticks of a moving turtle, whom nobody hears, that are made up for at the next one: the eye sees no more than 30 a second."""


class TurtleFrame:
    """The node and its world; `tick()` is one period."""

    def __init__(self, session: Session) -> None:
        self.node = node = create_node(session, "turtlesim")
        # A turtle stops by the time that it moves by, not by the wall's: so a key press is 63 ticks on any machine.
        self._now_ns = partial(session.timer_ns, node)
        # The original seeds rand() with the second it starts in.
        choice = random.Random(session.clock.now_ns() // 1_000_000_000)
        name = node.get_fully_qualified_name()
        self.simulation = model.Simulation(choice.randrange, node_name=name)
        self._interfaces: dict[str, TurtleInterface] = {}
        for (parameter, colour), default in zip(CHANNELS.items(), model.DEFAULT_BACKGROUND, strict=True):
            descriptor = ParameterDescriptor(
                description=f"{colour} channel of the background color",
                integer_range=[IntegerRange(from_value=0, to_value=255, step=1)],
            )
            node.declare_parameter(parameter, default, descriptor)
        if value("turtlesim.holonomic"):
            node.declare_parameter(
                "holonomic", False, ParameterDescriptor(description="If true, then turtles will be holonomic")
            )
        self._paint_background()
        node.create_service(Empty, "clear", self._clear)
        node.create_service(Empty, "reset", self._reset)
        node.create_service(Spawn, "spawn", self._spawn)
        node.create_service(Kill, "kill", self._kill)
        node.create_subscription(ParameterEvent, "/parameter_events", self._parameters_changed, EVENTS_QOS)
        node.get_logger().info(f"Starting turtlesim with node name {name}")
        self._add_turtle("", *model.CENTRE, 0.0)

    def tick(self, now: int | None = None) -> None:
        """Move every turtle by one period and publish where it is. `now` is the time of a tick that is made up for."""
        interfaces = self._interfaces
        for interface in interfaces.values():
            interface.before_step()
        for turtle, step in self.simulation.tick(self._now_ns() if now is None else now):
            interfaces[turtle.name].publish(step)

    @property
    def patience(self) -> int:
        """How many ticks may pass before anybody could tell that they were not lived through one by one."""
        if any(each.is_attended for each in self._interfaces.values()):
            return 0
        if self.simulation.rests:
            return REST
        # Ticks that are made up for have the world's times.
        return GLIDE if self.simulation.glides(GLIDE + 1) and not self.node.get_clock()._is_simulated() else 0

    def make_up_for(self, ticks: range) -> None:
        """Live through ticks that have passed, given by their times; nobody has heard them."""
        if self.simulation.rests:
            for interface in self._interfaces.values():
                interface.publish_unheard(len(ticks))
        else:
            for now in ticks:
                self.tick(now)

    def look_around(self) -> None:
        """Let the window know who drives the turtles."""
        topics = {name: interface.topics() for name, interface in self._interfaces.items()}
        if topics != self.simulation.topics:
            self.simulation.topics = topics

    def _add_turtle(self, name: str, x: float, y: float, theta: float) -> str | None:
        simulation = self.simulation
        free = simulation.free_name(name)
        if free is None:
            return None
        x, y, theta = model.float32(x), model.float32(y), model.float32(theta)
        turtle = simulation.create(free, x, y, theta, self._now_ns())
        self._interfaces[free] = TurtleInterface(self.node, turtle, self._now_ns)
        simulation.add(turtle)
        self.node.get_logger().info(f"Spawning turtle [{free}] at x=[{x:f}], y=[{y:f}], theta=[{theta:f}]")
        return free

    def _spawn(self, request: Any, response: Any) -> Any:
        name = self._add_turtle(request.name, request.x, request.y, request.theta)
        if name is None:
            self.node.get_logger().error(f"A turtle named [{request.name}] already exists")
        response.name = name or ""
        return response

    def _kill(self, request: Any, response: Any) -> Any:
        if self.simulation.remove(request.name):
            self._interfaces.pop(request.name).destroy()
        else:
            self.node.get_logger().error(f"Tried to kill turtle [{request.name}], which does not exist")
        return response

    def _clear(self, _: Any, response: Any) -> Any:
        self.node.get_logger().info("Clearing turtlesim.")
        self.simulation.clear()
        return response

    def _reset(self, _: Any, response: Any) -> Any:
        self.node.get_logger().info("Resetting turtlesim.")
        for interface in self._interfaces.values():
            interface.destroy()
        self._interfaces.clear()
        self.simulation.remove_all()
        self._add_turtle("", *model.CENTRE, 0.0)
        self.simulation.clear()
        return response

    def _parameters_changed(self, event: ParameterEvent) -> None:
        if event.node == self.simulation.node_name:
            self._paint_background()

    def _paint_background(self) -> None:
        self.simulation.set_background(*(self.node.get_parameter(name).value for name in CHANNELS))


async def main(session: Session) -> int:
    frame = TurtleFrame(session)
    session.executor.add_node(frame.node)
    display = session.display
    window = None if display is None else display.open("turtlesim", "TurtleSim", frame.simulation)
    looked = -TICKS_BETWEEN_LOOKS
    ticks = session.every(model.TICK)
    try:
        async for tick in ticks:
            session.spin_some()
            frame.tick()
            if window is not None and tick - looked >= TICKS_BETWEEN_LOOKS:
                looked = tick
                frame.look_around()
            if patience := frame.patience:
                passed = await session.rest(ticks, patience)
                frame.make_up_for(passed)
                if len(passed) < patience:  # the graph may have changed
                    looked = -TICKS_BETWEEN_LOOKS
    except STOPPED:
        # Closing the window ends the node without a word; Ctrl-C is answered by rclcpp.
        if window is None or not window.closed:
            log_interrupt(session)
    return 0
