"""InteractiveMarkers: what a server describes is drawn, what the mouse does with it is told to the server."""

from __future__ import annotations

import math
from typing import Any

import pytest
from geometry_msgs.msg import Pose
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
    Marker,
    MenuEntry,
)
from visualization_msgs.srv import GetInteractiveMarkers

from day6_core.ros.programs.rviz2.model.displays.control_drag import facing, turn_between
from day6_core.ros.programs.rviz2.model.tools.tool import Hit, Pointer
from day6_urdf.kinematics import rotate
from tests.rviz2.rviz_machine import RVizMachine, lines
from tests.rviz2.rviz_walk import drag, run, walking

DOWN = (0.0, 0.0, -1.0)


def control(name: str, mode: int, **fields: Any) -> InteractiveMarkerControl:
    made = InteractiveMarkerControl(name=name, interaction_mode=mode, **fields)
    made.orientation.w = 1.0
    return made


def marker(*controls: InteractiveMarkerControl, name: str = "thing") -> InteractiveMarker:
    message = InteractiveMarker(name=name, description="a thing", controls=controls, scale=1.0)
    message.header.frame_id = "stand"
    message.pose.orientation.w = 1.0
    return message


def about_z(made: InteractiveMarkerControl) -> InteractiveMarkerControl:
    """Its x looks along z."""
    made.orientation.w, made.orientation.y = math.sqrt(0.5), -math.sqrt(0.5)
    return made


class Server:
    """What interactive_markers' server does, as far as a client sees it."""

    def __init__(self, machine: RVizMachine) -> None:
        self.machine, self.number = machine, 0
        self.markers: list[InteractiveMarker] = []
        self.feedback: list[InteractiveMarkerFeedback] = []
        self.service: Any = None
        self.open()
        machine.node.create_subscription(InteractiveMarkerFeedback, "/srv/feedback", self.feedback.append, 100)

    def open(self) -> None:
        node = self.machine.node
        self.service = node.create_service(GetInteractiveMarkers, "/srv/get_interactive_markers", self.answer)

    def close(self) -> None:
        self.machine.node.destroy_service(self.service)

    def answer(self, request: Any, response: Any) -> Any:
        response.sequence_number, response.markers = self.number, self.markers
        return response

    def update(self, **fields: Any) -> None:
        self.number += 1
        message = InteractiveMarkerUpdate(seq_num=self.number, type=InteractiveMarkerUpdate.UPDATE, **fields)
        self.machine.publish("/srv/update", message)

    def events(self) -> list[int]:
        found = [each.event_type for each in self.feedback]
        self.feedback.clear()
        return found


@pytest.fixture
def server(machine: RVizMachine) -> Server:
    machine.open()
    machine.fix("map")
    machine.transform("map", "stand", (10.0, 0.0, 0.0))
    return Server(machine)


def shown(machine: RVizMachine, *markers: InteractiveMarker) -> Any:
    """The display, connected to a server with these markers; the server is set up by the fixture."""
    display = machine.add("InteractiveMarkers", "/srv/update")
    machine.settle(3.0)
    return display


def use(machine: RVizMachine, *pointers: tuple[str, Pointer]) -> None:
    """Press, drag and release with the tool Interact, each told as the window tells it."""
    tool = machine.rviz.tools.current
    for act, pointer in pointers:
        machine.do(
            lambda act=act, pointer=pointer: machine.rviz.tools.use(tool, lambda used: getattr(used, act)(pointer))
        )


def at(x: float, y: float, display: Any = None, name: str = "") -> Pointer:
    """A look straight down on a place at height 0; on a control of `thing`, if it is one."""
    hit = Hit((x, y, 0.0), display, ("thing", name)) if display is not None else None
    return Pointer((x, y, 5.0), DOWN, hit)


def test_what_the_server_has_is_drawn_in_its_frame_and_its_updates_follow(machine: RVizMachine, server: Server) -> None:
    server.markers = [marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))]
    display = shown(machine)
    assert display.namespace.value == "/srv"
    assert lines(display) == {
        "Interactive Marker Client": ("Ok", "Change state to: 2"),
        "thing": ("Ok", "Locked to frame stand"),
    }
    # Two arrows along x, from 0.5 to 0.9 on both sides; a cone and a shaft each.
    places = [shape.pose.xyz[0] for shape in machine.rviz.scene.shapes]
    assert len(places) == 4 and min(places) < 9.5 and max(places) > 10.5
    assert machine.rviz.scene.shapes[0].colour == (1.0, 0.0, 0.0, 0.5)
    (label,) = machine.rviz.scene.labels
    assert label.text == "a thing"
    moved = InteractiveMarkerPose(name="thing", pose=Pose())
    moved.header.frame_id, moved.pose.position.x = "stand", 5.0
    server.update(poses=[moved])
    assert min(shape.pose.xyz[0] for shape in machine.rviz.scene.shapes) > 14.0
    server.update(erases=["thing"])
    assert not machine.rviz.scene.shapes and "thing" not in lines(display)


def test_dragging_along_an_axis_tells_the_server_each_pose(machine: RVizMachine, server: Server) -> None:
    server.markers = [marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))]
    display = shown(machine)
    use(machine, ("press", at(10.7, 0.0, display, "axis")))
    assert machine.rviz.tools.current.status == "Left-Click: Move."
    down = server.feedback[-1]
    assert server.events() == [InteractiveMarkerFeedback.POSE_UPDATE, InteractiveMarkerFeedback.MOUSE_DOWN]
    assert down.mouse_point_valid and down.mouse_point.x == pytest.approx(0.7)
    use(machine, ("drag", at(12.7, 1.0)))
    told = server.feedback[-1]
    assert server.events() == [InteractiveMarkerFeedback.POSE_UPDATE]
    assert (told.marker_name, told.control_name, told.client_id) == ("thing", "axis", "/rviz")
    # In the marker's frame, and only along its axis.
    assert told.header.frame_id == "stand"
    assert (told.pose.position.x, told.pose.position.y) == (pytest.approx(2.0), pytest.approx(0.0))
    use(machine, ("release", at(12.7, 1.0)))
    assert server.events() == [InteractiveMarkerFeedback.POSE_UPDATE, InteractiveMarkerFeedback.MOUSE_UP]


def test_a_pose_of_the_server_waits_until_the_user_lets_go(machine: RVizMachine, server: Server) -> None:
    server.markers = [marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))]
    display = shown(machine)
    use(machine, ("press", at(10.7, 0.0, display, "axis")), ("drag", at(11.7, 0.0)))
    back = InteractiveMarkerPose(name="thing", pose=Pose())
    back.header.frame_id = "stand"
    server.update(poses=[back])
    assert display.markers["thing"].pose.xyz[0] == pytest.approx(1.0)
    use(machine, ("release", at(11.7, 0.0)))
    assert display.markers["thing"].pose.xyz[0] == 0.0


def test_a_plane_moves_both_ways_and_a_ring_turns(machine: RVizMachine, server: Server) -> None:
    plane = about_z(control("plane", InteractiveMarkerControl.MOVE_PLANE))
    ring = about_z(control("ring", InteractiveMarkerControl.ROTATE_AXIS))
    server.markers = [marker(plane, ring)]
    display = shown(machine)
    use(machine, ("press", at(10.5, 0.0, display, "plane")), ("drag", at(11.5, 2.0)), ("release", at(11.5, 2.0)))
    assert display.markers["thing"].pose.xyz == pytest.approx((1.0, 2.0, 0.0))
    use(machine, ("press", at(12.0, 2.0, display, "ring")), ("drag", at(11.0, 3.0)), ("release", at(11.0, 3.0)))
    x, y, _ = rotate(display.markers["thing"].pose.rotation, (1.0, 0.0, 0.0))
    assert (x, y) == (pytest.approx(0.0, abs=1e-6), pytest.approx(1.0))
    assert display.markers["thing"].pose.xyz == pytest.approx((1.0, 2.0, 0.0))


def test_a_button_is_clicked(machine: RVizMachine, server: Server) -> None:
    cube = Marker(type=Marker.CUBE)
    cube.color.a = 1.0
    server.markers = [marker(control("knob", InteractiveMarkerControl.BUTTON, markers=[cube], always_visible=True))]
    display = shown(machine)
    use(machine, ("press", at(10.0, 0.0, display, "knob")), ("release", at(10.0, 0.0, display, "knob")))
    kinds = InteractiveMarkerFeedback
    assert server.events() == [
        kinds.POSE_UPDATE,
        kinds.MOUSE_DOWN,
        kinds.BUTTON_CLICK,
        kinds.POSE_UPDATE,
        kinds.MOUSE_UP,
    ]
    # Another tool hides what is not always visible.
    assert machine.rviz.scene.shapes
    machine.do(lambda: machine.rviz.tools.choose(machine.rviz.tools.with_key("m")))
    assert machine.rviz.scene.shapes
    server.update(markers=[marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))])
    assert not machine.rviz.scene.shapes


def test_a_server_that_goes_and_comes_is_asked_again(machine: RVizMachine, server: Server) -> None:
    server.markers = [marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))]
    display = shown(machine)
    assert display.markers
    server.close()
    machine.settle(3.0)
    assert not display.markers
    assert "Server not available while running, resetting" in machine.running.errors
    server.open()
    machine.settle(3.0)
    assert display.markers
    server.number += 1
    server.update()
    assert "Update sequence number is out of order" not in machine.running.errors
    server.number += 1
    server.update()
    text = "Update sequence number is out of order. 3 (expected) vs. 4 (received)"
    assert text in machine.running.errors


def test_what_cannot_be_is_told(machine: RVizMachine, server: Server) -> None:
    display = machine.add("InteractiveMarkers")
    assert lines(display)["Interactive Marker Client"] == ("Error", "Error connecting: empty namespace")
    bad = marker(control("axis", InteractiveMarkerControl.MOVE_AXIS))
    bad.pose.position.x = math.nan
    lost = marker(control("axis", InteractiveMarkerControl.MOVE_AXIS), name="lost")
    lost.header.frame_id = "nowhere"
    server.markers = [bad, lost]
    display = shown(machine)
    assert lines(display)["thing"] == ("Error", "Marker contains invalid floats!")
    assert lines(display)["lost"] == ("Error", "For frame [nowhere]: Frame [nowhere] does not exist")
    server.update(poses=[InteractiveMarkerPose(name="other")])
    assert lines(display)["other"] == ("Error", "Pose received for non-existing marker 'other")


def test_a_control_that_faces_the_view_does() -> None:
    forward, up = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    turn = facing((0.0, 0.0, 0.0, 1.0), forward, up, 0.0)
    assert rotate(turn, (1.0, 0.0, 0.0)) == pytest.approx(forward)
    assert rotate(turn, (0.0, 0.0, 1.0)) == pytest.approx(up)
    back = turn_between((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0))
    assert rotate(back, (1.0, 0.0, 0.0)) == pytest.approx((-1.0, 0.0, 0.0))


def test_the_mouse_drags_a_control_and_beside_it_the_view(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.fix("stand")
            machine.transform("stand", "other")
            server = Server(machine)
            square = Marker(type=Marker.CUBE)
            square.scale.x = square.scale.y = square.scale.z = 4.0
            square.color.r = square.color.a = 1.0
            plane = about_z(control("plane", InteractiveMarkerControl.MOVE_PLANE, markers=[square]))
            server.markers = [marker(plane)]
            machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))
            display = shown(machine)
            await at.until(lambda: display.markers and machine.rviz.scene.shapes)
            at.pane.status_bar.hurry()
            await at.settle()
            assert "InteractiveMarkers: interactive markers: 1" in " ".join(at.screen().split())
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            scale = machine.rviz.view.child("Scale").value
            await drag(at, middle, (middle[0] + 8, middle[1]))
            first, *_, last = server.feedback
            assert (first.event_type, last.event_type) == (1, InteractiveMarkerFeedback.MOUSE_UP)
            assert first.mouse_point_valid and first.mouse_point.z == pytest.approx(2.0, abs=0.1)
            assert last.pose.position.x > 0.1 and last.pose.position.y == pytest.approx(0.0, abs=1e-6)
            server.feedback.clear()
            await drag(at, (1, 1), (9, 5))
            assert not server.feedback and machine.rviz.view.child("Scale").value == scale
            assert machine.rviz.view.child("Angle").value != 0.0

    run(walk())


def with_menu(*controls: InteractiveMarkerControl) -> InteractiveMarker:
    message = marker(*controls)
    message.menu_entries = [
        MenuEntry(id=1, title="[x] lamp", command_type=MenuEntry.FEEDBACK),
        MenuEntry(id=2, title="go", command_type=MenuEntry.FEEDBACK),
        MenuEntry(id=3, parent_id=2, title="home", command_type=MenuEntry.FEEDBACK),
        MenuEntry(id=4, title="shell", command="rm", command_type=MenuEntry.ROSRUN),
        MenuEntry(id=5, parent_id=5, title="ring", command_type=MenuEntry.FEEDBACK),
    ]
    return message


def test_a_menu_opens_by_the_right_button_and_its_choice_is_told(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.fix("stand")
            machine.transform("stand", "other")
            server = Server(machine)
            cube = Marker(type=Marker.CUBE)
            cube.scale.x = cube.scale.y = cube.scale.z = 4.0
            cube.color.a = 1.0
            server.markers = [with_menu(control("knob", InteractiveMarkerControl.MENU, markers=[cube]))]
            machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))
            display = shown(machine)
            await at.until(lambda: display.markers and machine.rviz.scene.shapes)
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            await drag(at, middle, button=3)
            await at.settle()
            assert "☑ lamp" in at.screen() and "go ▸ home" in at.screen() and "shell" not in at.screen()
            await at.press("down", "enter")
            told = server.feedback[-1]
            kinds = InteractiveMarkerFeedback
            assert (told.event_type, told.menu_entry_id, told.control_name) == (kinds.MENU_SELECT, 3, "knob")
            # The left button opens it, too, where the control is a menu.
            await drag(at, middle)
            await at.settle()
            assert server.feedback[-1].event_type == kinds.MOUSE_UP and "☑ lamp" in at.screen()

    run(walk())
