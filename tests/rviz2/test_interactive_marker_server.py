"""The package interactive_markers as programs use it: what the clients are told, and who hears of feedback."""

from __future__ import annotations

from typing import Any

import pytest
from interactive_markers import InteractiveMarkerServer, MenuHandler
from interactive_markers.interactive_marker_server import InteractiveMarkerServer as SameServer
from interactive_markers.menu_handler import MenuHandler as SameHandler
from std_msgs.msg import Header
from visualization_msgs.msg import InteractiveMarker, InteractiveMarkerFeedback, InteractiveMarkerUpdate, MenuEntry
from visualization_msgs.srv import GetInteractiveMarkers

from tests.support.stepped_machine import SteppedMachine

Feedback = InteractiveMarkerFeedback


class Client:
    """What a client of the server `arm` hears, and what it says."""

    def __init__(self, machine: SteppedMachine) -> None:
        self.machine = machine
        node = machine.node
        self.updates: list[InteractiveMarkerUpdate] = []
        node.create_subscription(InteractiveMarkerUpdate, "/arm/update", self.updates.append, 100)
        self.say = node.create_publisher(Feedback, "/arm/feedback", 10)
        self.get = node.create_client(GetInteractiveMarkers, "/arm/get_interactive_markers")

    def tell(self, kind: int, name: str = "cup", who: str = "/rviz", **fields: Any) -> None:
        self.say.publish(Feedback(event_type=kind, marker_name=name, client_id=who, **fields))
        self.machine.advance(0.1)

    def newest(self) -> InteractiveMarkerUpdate:
        self.machine.advance(0.1)
        return self.updates[-1]

    def all(self) -> Any:
        future = self.get.call_async(GetInteractiveMarkers.Request())
        self.machine.advance(0.2)
        return future.result()


@pytest.fixture
def machine() -> Any:
    machine = SteppedMachine()
    yield machine
    machine.end()


@pytest.fixture
def server(machine: SteppedMachine) -> InteractiveMarkerServer:
    return InteractiveMarkerServer(machine.node, "arm")


@pytest.fixture
def client(machine: SteppedMachine, server: InteractiveMarkerServer) -> Client:
    client = Client(machine)
    machine.advance(0.2)
    return client


def cup(name: str = "cup") -> InteractiveMarker:
    marker = InteractiveMarker(name=name)
    marker.header.frame_id = "table"
    return marker


def test_both_names_of_the_classes_are_the_same() -> None:
    assert SameServer is InteractiveMarkerServer and SameHandler is MenuHandler


def test_nothing_is_told_before_applyChanges(server: InteractiveMarkerServer, client: Client) -> None:
    server.insert(cup())
    client.machine.advance(0.1)
    assert not client.updates and not client.all().markers
    assert server.get("cup").header.frame_id == "table"
    server.applyChanges()
    told = client.newest()
    assert (told.type, told.seq_num, [each.name for each in told.markers]) == (told.UPDATE, 1, ["cup"])
    assert client.all().sequence_number == 1
    server.applyChanges()  # nothing has changed
    client.machine.advance(0.1)
    assert len(client.updates) == 1


def test_a_pose_and_an_end_are_told(server: InteractiveMarkerServer, client: Client) -> None:
    pose = cup().pose
    pose.position.x = 2.0
    assert not server.setPose("cup", pose) and not server.erase("cup")
    server.insert(cup())
    assert not server.setPose("cup", pose)  # clients do not know it yet
    server.applyChanges()
    assert server.setPose("cup", pose)
    assert server.get("cup").pose.position.x == 2.0
    server.applyChanges()
    (moved,) = client.newest().poses
    assert (moved.name, moved.header.frame_id, moved.pose.position.x) == ("cup", "table", 2.0)
    assert server.setPose("cup", pose, Header(frame_id="floor"))
    server.applyChanges()
    assert client.newest().poses[0].header.frame_id == "floor"
    assert server.erase("cup") and server.get("cup") is None
    server.applyChanges()
    assert client.newest().erases == ["cup"] and not client.all().markers


def test_feedback_goes_to_the_callback_of_its_type_or_to_the_one_for_all(
    server: InteractiveMarkerServer, client: Client
) -> None:
    heard: list[str] = []
    server.insert(cup(), feedback_callback=lambda feedback: heard.append("all"))
    assert server.setCallback("cup", lambda feedback: heard.append("click"), Feedback.BUTTON_CLICK)
    assert not server.setCallback("no", None)
    server.applyChanges()
    client.machine.advance(2.0)
    client.tell(Feedback.MOUSE_DOWN)
    client.tell(Feedback.BUTTON_CLICK)
    client.tell(Feedback.BUTTON_CLICK, name="other")
    assert heard == ["all", "click"]
    server.setCallback("cup", None, Feedback.BUTTON_CLICK)
    client.tell(Feedback.BUTTON_CLICK)
    assert heard == ["all", "click", "all"]


def test_who_moves_a_marker_has_it_for_a_second(server: InteractiveMarkerServer, client: Client) -> None:
    server.insert(cup())
    server.applyChanges()
    client.machine.advance(2.0)
    pose = cup().pose
    for who, x in (("/one", 1.0), ("/two", 2.0)):
        pose.position.x = x
        client.tell(Feedback.POSE_UPDATE, who=who, pose=pose)
    assert [each.pose.position.x for each in client.newest().poses] == [1.0]
    client.machine.advance(1.0)
    client.tell(Feedback.POSE_UPDATE, who="/two", pose=pose)
    assert client.newest().poses[0].pose.position.x == 2.0 and server.get("cup").pose.position.x == 2.0


def test_a_callback_may_move_the_marker_elsewhere(server: InteractiveMarkerServer, client: Client) -> None:
    def snap(feedback: Feedback) -> None:
        feedback.pose.position.x = float(round(feedback.pose.position.x))
        server.setPose(feedback.marker_name, feedback.pose)

    server.insert(cup(), feedback_callback=snap, feedback_type=Feedback.POSE_UPDATE)
    server.applyChanges()
    client.machine.advance(2.0)
    pose = cup().pose
    pose.position.x = 1.3
    client.tell(Feedback.POSE_UPDATE, pose=pose)
    (moved,) = client.newest().poses
    assert moved.pose.position.x == 1.0


def test_a_menu_is_a_tree_whose_entries_call_functions(server: InteractiveMarkerServer, client: Client, capsys) -> None:
    chosen: list[str] = []
    menu = MenuHandler()
    first = menu.insert("lamp", callback=lambda feedback: chosen.append("lamp"))
    drive = menu.insert("drive")
    home = menu.insert("home", parent=drive, callback=lambda feedback: chosen.append("home"))
    assert (first, drive, home, menu.getTitle(drive), menu.getTitle(9)) == (1, 2, 3, "drive", None)
    assert menu.insert("lost", parent=77) is None
    assert capsys.readouterr().err == "Parent menu entry '77' not found\n"
    assert menu.setCheckState(first, MenuHandler.CHECKED) and menu.getCheckState(first) == MenuHandler.CHECKED
    assert not menu.setCheckState(77, 1) and menu.getCheckState(77) is None and not menu.setVisible(77, True)
    with pytest.raises(KeyError):
        menu.apply(server, "cup")
    server.insert(cup())
    server.applyChanges()
    assert menu.apply(server, "cup")
    server.applyChanges()
    entries = client.newest().markers[0].menu_entries
    assert [(each.id, each.parent_id, each.title) for each in entries] == [
        (1, 0, "[x] lamp"),
        (2, 0, "drive"),
        (3, 2, "home"),
    ]
    assert entries[0].command_type == MenuEntry.FEEDBACK
    client.machine.advance(2.0)
    client.tell(Feedback.MENU_SELECT, menu_entry_id=3)
    client.tell(Feedback.MENU_SELECT, menu_entry_id=99)
    assert chosen == ["home"]
    menu.setVisible(drive, False)
    menu.setCheckState(first, MenuHandler.UNCHECKED)
    assert menu.reApply(server)
    server.applyChanges()
    assert [each.title for each in client.newest().markers[0].menu_entries] == ["[ ] lamp"]
    server.erase("cup")
    server.applyChanges()
    assert not menu.reApply(server)


def test_shutdown_takes_everything_away(server: InteractiveMarkerServer, client: Client) -> None:
    server.insert(cup())
    server.applyChanges()
    server.shutdown()
    assert client.newest().erases == ["cup"]
    assert not client.machine.node.get_publishers_info_by_topic("/arm/update")
    server.shutdown()  # a second time is nothing
