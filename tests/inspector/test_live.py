"""Every finding where it really happens: nodes on a graph, the inspector's own node among them, and its window."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped, Twist, Vector3
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Header, String
from tf2_msgs.msg import TFMessage

from day6_core.graph.endpoints import EndpointKind
from day6_core.graph.names import OBSERVER_PREFIX
from day6_core.ros.programs.day6_inspector.model import Inspector
from day6_core.ros.programs.day6_inspector.pace import LOOKS
from day6_core.ros.programs.day6_inspector.transforms import STILL
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_urdf import shipped_model
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from tests.support.stepped_machine import Running, SteppedMachine
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_text, step

WHEELS = ["left_wheel_joint", "right_wheel_joint"]


class Lab(SteppedMachine):
    """A machine on which a test makes nodes, and the inspector looking on."""

    def __init__(self) -> None:
        super().__init__()
        self.inspector = Inspector(self.make(f"{OBSERVER_PREFIX}_inspector_1"), self.clock, self.graph)
        self.node.destroy_node()

    def make(self, name: str) -> Any:
        """A node that spins."""
        session = Session(self.scheduler, self.graph, [name])
        node = session.create_node(name)
        self._programs.append(Program(session, lambda session: session.spin(node)))
        return node

    def says(self, topic: type, name: str, node: str, qos: Any = 10) -> Any:
        return self.make(node).create_publisher(topic, name, qos)

    def hears(self, topic: type, name: str, node: str, qos: Any = 10) -> Any:
        return self.make(node).create_subscription(topic, name, lambda message: None, qos)

    def robot(self) -> Running:
        return self.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))

    def turn(self, publisher: Any, names: list[str], times: int = 10, every: float = 0.02) -> None:
        """Publish joint states as wheel_spinner does, while the inspector looks."""
        self.inspector.refresh()
        for turn in range(times):
            stamp = Time(nanoseconds=self.clock.now_ns()).to_msg()
            position = [0.02 * turn] * len(names)
            publisher.publish(JointState(header=Header(stamp=stamp), name=names, position=position))
            self.advance(every)

    def findings(self) -> dict[str, str]:
        """What the inspector says now: id without its prefix -> text; of several alike the last."""
        for _ in range(2):  # it sees a publisher at one look, and has heard it at the next
            self.advance(0.1)
            self.inspector.refresh()
        return {finding.id.removeprefix("inspector."): finding.text for finding in self.inspector.findings}


@pytest.fixture
def lab() -> Iterator[Lab]:
    lab = Lab()
    yield lab
    lab.end()


def test_an_empty_graph_is_well(lab: Lab) -> None:
    assert lab.findings() == {}


def test_looking_on_makes_no_topic(lab: Lab) -> None:
    """Section 6.2: that /robot_description is not there shows that robot_state_publisher does not run."""

    def topics() -> set[str]:
        return {name for name, _ in lab.graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)}

    lab.findings()
    assert not topics() & {"/joint_states", "/robot_description"}
    robot = lab.robot()
    lab.findings()
    assert {"/joint_states", "/robot_description"} <= topics()
    robot.program.interrupt()
    lab.findings()
    assert not topics() & {"/joint_states", "/robot_description"}


def test_talker_and_listener_are_well(lab: Lab) -> None:
    lab.says(String, "chatter", "talker")
    lab.hears(String, "chatter", "listener")
    assert lab.findings() == {}


def test_a_world_that_lost_time_lately_is_told_until_it_keeps_up_again(lab: Lab) -> None:
    lab.inspector.refresh()
    lab.clock.lost_ns += 300_000_000
    assert lab.findings() == {}, "a program that starts may take a moment"
    lab.advance(1.8)
    lab.clock.lost_ns += 1_700_000_000
    said = "this computer is too slow for everything running here: time passes at 0.52x instead of 1x"
    assert lab.findings()["late"].startswith(said)
    for _ in range(LOOKS // 2):
        found = lab.findings()
    assert found == {}


def test_a_topic_name_with_a_slip_is_named_with_the_other(lab: Lab) -> None:
    lab.says(Twist, "/turtle1/cmd_vle", "driver")
    lab.hears(Twist, "/turtle1/cmd_vel", "turtlesim")
    found = lab.findings()
    assert set(found) == {"near"} and "/turtle1/cmd_vle" in found["near"] and "/turtle1/cmd_vel" in found["near"]


def test_one_sided_topics_are_named_with_their_node(lab: Lab) -> None:
    lab.says(String, "/news", "talker")
    lab.hears(Twist, "/cmd_vel", "base")
    assert lab.findings() == {
        "unsaid": "/cmd_vel: /base subscribes, but nobody publishes",
        "unheard": "/news: /talker publishes, but nobody subscribes",
    }


def test_a_wrong_message_type_on_joint_states_is_an_error(lab: Lab) -> None:
    """Section 6.3 of the article: Float64MultiArray on /joint_states."""
    lab.robot()
    lab.says(Float64MultiArray, "/joint_states", "wheel_spinner")
    found = lab.findings()
    assert "/wheel_spinner sends std_msgs/msg/Float64MultiArray" in found["types"]
    assert "/robot_state_publisher wants sensor_msgs/msg/JointState" in found["types"]
    assert lab.inspector.findings[0].level == "error"


@pytest.mark.parametrize(
    ("offer", "request_", "policy"),
    [
        (QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT), QoSProfile(depth=1), "reliability"),
        (QoSProfile(depth=1), QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL), "durability"),
    ],
    ids=["best effort", "volatile"],
)
def test_qos_that_do_not_suit_are_an_error(lab: Lab, offer: Any, request_: Any, policy: str) -> None:
    lab.says(String, "/scan", "lidar", offer)
    lab.hears(String, "/scan", "mapper", request_)
    assert lab.findings() == {
        "qos": f"/scan: the QoS of /lidar is incompatible with /mapper ({policy}); nothing arrives",
    }


def test_sliders_and_wheel_spinner_fight(lab: Lab) -> None:
    """Section 5.4 of the article."""
    lab.robot()
    lab.says(JointState, "joint_states", "joint_state_publisher")
    lab.turn(lab.says(JointState, "joint_states", "wheel_spinner"), WHEELS)
    found = lab.findings()
    assert set(found) == {"fight"} and "/joint_state_publisher, /wheel_spinner" in found["fight"]


def test_two_nodes_of_one_name_are_noticed(lab: Lab) -> None:
    lab.make("talker")
    lab.make("talker")
    assert "twins" in lab.findings()


def test_wheel_left_joint_is_not_left_wheel_joint(lab: Lab) -> None:
    """Section 6.3 of the article, its most frequent slip."""
    lab.robot()
    lab.turn(lab.says(JointState, "joint_states", "wheel_spinner"), ["wheel_left_joint", "right_wheel_joint"])
    found = lab.findings()
    assert "wheel_left_joint" in found["unknown_joint_near"] and "left_wheel_joint?" in found["unknown_joint_near"]
    assert "/wheel_spinner" in found["unknown_joint_near"] and "silent_joint" not in found
    assert lab.inspector.findings[0].level == "error"


def test_a_joint_of_quite_another_robot_is_named_alone(lab: Lab) -> None:
    lab.robot()
    lab.turn(lab.says(JointState, "joint_states", "arm"), [*WHEELS, "gripper"])
    found = lab.findings()
    assert set(found) == {"unknown_joint"} and "gripper" in found["unknown_joint"]


def test_one_message_a_second_is_too_slow_for_the_eye(lab: Lab) -> None:
    """Section 6.3 of the article, its last cause."""
    lab.robot()
    publisher = lab.says(JointState, "joint_states", "wheel_spinner")
    lab.turn(publisher, WHEELS, times=5, every=1.0)
    assert lab.findings() == {"slow": "/joint_states arrives 1 times a second; the eye needs about 20"}
    lab.turn(publisher, WHEELS, times=30)
    assert lab.findings() == {}


def test_frames_that_nobody_sends_any_more_go(lab: Lab) -> None:
    hearing = lab.inspector._hearing
    publisher = lab.says(TFMessage, "/tf", "broadcaster")
    fixed = lab.says(TFMessage, "/tf_static", "shelf", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    fixed.publish(TFMessage(transforms=[transform("world", "shelf")]))

    def heard(*frames: str, looks: int = 3) -> frozenset[str]:
        for _ in range(looks):
            hearing.look()
            publisher.publish(TFMessage(transforms=[transform("/world", frame) for frame in frames]))
        return hearing.facts()["frames"]

    assert heard("cup") == {"world", "shelf", "cup"}
    assert heard("fork") == {"world", "shelf", "cup", "fork"}
    assert heard("fork", looks=STILL) == {"world", "shelf", "fork"}
    publisher.destroy()
    hearing.look()
    assert hearing.facts()["frames"] == {"world", "shelf"}


def transform(parent: str, child: str) -> TransformStamped:
    return TransformStamped(header=Header(frame_id=parent), child_frame_id=child)


def test_without_a_window_it_prints_what_it_looked_at_and_what_not(lab: Lab) -> None:
    lab.hears(Twist, "/cmd_vel", "base")
    publisher = lab.says(Twist, "/cmd_vel", "driver")
    told = []
    for speed in (1.0, float("nan")):
        inspector = lab.start("day6_inspector", "inspector")
        for _ in range(20):
            publisher.publish(Twist(linear=Vector3(x=speed)))
            lab.advance(0.1)
        lab.until(lambda inspector=inspector: inspector.program.status is not None)
        told.append(inspector.output.splitlines())
    well, broken = told
    assert well[0] == "no fault found in what was looked at" and broken[0].startswith(
        "error: /cmd_vel: /driver sends nan"
    )
    for lines in told:
        (looked,) = (line for line in lines if line.startswith("looked at: "))
        assert "nodes 2" in looked and "messages " in looked and "frames" not in looked
        assert any(line.startswith("not there, so not looked at: ") and "frames" in line for line in lines)
        assert "not looked at: the terminals (they exist only on the desktop)" in lines


def test_what_was_put_right_is_no_longer_said(lab: Lab) -> None:
    talker = lab.make("talker")
    publisher = talker.create_publisher(String, "news", 10)
    assert "unheard" in lab.findings()
    talker.destroy_publisher(publisher)
    assert lab.findings() == {}


@pytest.mark.parametrize("size", [(40, 10), (80, 24), (120, 40)])
@pytest.mark.parametrize("language", ["zh", "en"])
def test_the_window_says_it_in_the_users_language_at_every_size(lab: Lab, size: tuple[int, int], language: str) -> None:
    lab.robot()
    lab.turn(lab.says(JointState, "joint_states", "wheel_spinner"), ["wheel_left_joint", "right_wheel_joint"])
    lab.says(String, "/news", "talker")
    lab.findings()

    async def look() -> str:
        desk = FakeDesk()
        window = desk.display.open("inspector", "Inspector", lab.inspector)
        async with opened(desk, *size, scene="empty", lang=language) as (app, pilot):
            await step(app, pilot)
            app.desktop.focus_pane(app.desktop.panes[window.number])
            await step(app, pilot)
            seen = screen_text(app)
            for _ in lab.inspector.findings:
                await pilot.press("down")
                await step(app, pilot)
                seen += screen_text(app)
            return seen

    text = asyncio.run(look())
    assert "wheel_left_joint" in text and "/news" in text
    assert ("关节" if language == "zh" else "joint") in text


def test_f6_opens_the_inspector_and_f6_closes_it() -> None:
    async def press() -> None:
        desk = FakeDesk()
        opened_tools: list[str] = []
        async with opened(desk, 80, 24, scene="empty", lang="en") as (app, pilot):
            app.machine.run_tool = lambda package, executable: opened_tools.append(executable)
            await pilot.press("f6")
            assert opened_tools == ["inspector"]
            lab = Lab()
            window = desk.display.open("inspector", "Inspector", lab.inspector)
            await step(app, pilot)
            assert "no fault found in what was looked at" in screen_text(app)
            await pilot.press("f6")
            await step(app, pilot)
            assert window.closed and opened_tools == ["inspector"]
            lab.end()

    asyncio.run(press())
