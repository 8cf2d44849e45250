"""The program and the window of the image view: topics, the newest image, clicks, files, and every kind of terminal."""

from __future__ import annotations

import re
from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from geometry_msgs.msg import Point
from sensor_msgs.msg import Image
from std_msgs.msg import String

from day6_core.ros.programs.image_tools.shown_image import ShownImage
from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_image_view.decoding import ImageRequest, Undecodable
from day6_core.ros.programs.rqt_image_view.model import ImageView
from day6_core.ros.programs.rqt_image_view.rqt_image_view import ImageViewPlugin
from day6_tui.locale import catalogue
from tests.support.rqt_machine import RqtMachine
from tests.support.waiting import until
from tests.tui.screens import ToolWindow, step, step_until, use_window


def image(value: int = 0, width: int = 8, height: int = 6, encoding: str = "mono8") -> Image:
    data = np.full(width * height, value, np.uint8).tobytes()
    return Image(height=height, width=width, encoding=encoding, step=width, data=data)


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[RqtMachine]:
    found = RqtMachine("rqt_image_view", tmp_path)
    yield found
    found.end()


def test_topics_with_images_are_listed_and_one_that_is_named_is_shown_as_soon_as_it_is_there(machine) -> None:
    machine.open("/camera")
    machine.node.create_publisher(String, "chatter", 1)
    publisher = machine.node.create_publisher(Image, "camera", 1)
    machine.advance(0.3)
    assert dict(machine.model.topics) == {"/camera": "sensor_msgs/msg/Image"} and machine.model.topic == "/camera"
    assert machine.own.startswith("/rqt_gui_cpp_node_")
    publisher.publish(image(77))
    machine.advance(0.1)
    assert machine.model.picture(ImageRequest(8, 6)).pixels[0, 0].tolist() == [77] * 3


def test_only_the_newest_image_is_kept_and_another_topic_begins_anew(machine) -> None:
    publisher = machine.node.create_publisher(Image, "one", 1)
    machine.node.create_publisher(Image, "two", 1)
    machine.open("/one")
    for value in range(100):
        publisher.publish(image(value))
    assert machine.model.received == 100
    assert machine.model.picture(ImageRequest(1, 1)).pixels[0, 0, 0] == 99
    machine.do("choose", "/two")
    assert machine.model.received == 0 and machine.model.picture(ImageRequest(1, 1)) is None
    assert machine.node.count_subscribers("/one") == 0 and machine.node.count_subscribers("/two") == 1


def test_an_image_of_another_process_is_decoded_when_it_is_looked_at(machine, monkeypatch) -> None:
    from day6_core.interfaces import serialize
    from day6_core.ros.programs.rqt_image_view import model

    machine.node.create_publisher(Image, "one", 1)
    machine.open("/one")
    read: list[bytes] = []
    deserialize = model.deserialize
    monkeypatch.setattr(model, "deserialize", lambda data, kind: read.append(data) or deserialize(data, kind))
    for value in range(50):
        machine.model._receive(serialize(image(value)))
    assert read == []
    for _ in range(3):
        assert machine.model.picture(ImageRequest(1, 1)).pixels[0, 0, 0] == 49
    assert len(read) == 1
    machine.model._receive(b"\0\1\0\0 broken")
    with pytest.raises(Undecodable):
        machine.model.picture(ImageRequest(1, 1))


def test_an_image_has_the_window_drawn_anew_though_nothing_else_goes_on(machine) -> None:
    machine.node.create_publisher(Image, "one", 1)
    machine.open("/one", seconds=2.0)
    drawn: list[int] = []
    machine.scheduler.on_activity = lambda: drawn.append(machine.model.received)
    until(lambda: machine.scheduler.run(lambda: bool(drawn), timeout=0.01))
    machine.model._receive(image(1))  # as the link's thread does
    until(lambda: machine.scheduler.run(lambda: 1 in drawn, timeout=0.01))


def test_clicks_are_published_beside_the_topic_when_wanted(machine) -> None:
    machine.node.create_publisher(Image, "camera", 1)
    machine.open("/camera")
    clicks = machine.watch(Point, "/camera_mouse_left")
    machine.do("click", 3, 4)
    assert clicks == [] and machine.node.count_publishers("/camera_mouse_left") == 0
    machine.do("publish_clicks", True)
    machine.do("click", 3, 4)
    assert clicks == [Point(x=3.0, y=4.0)]
    machine.do("publish_clicks", False)
    assert machine.node.count_publishers("/camera_mouse_left") == 0


def test_the_whole_image_is_saved_turned_as_it_is_seen(machine) -> None:
    from PIL import Image as Picture

    publisher = machine.node.create_publisher(Image, "camera", 1)
    machine.open("/camera")
    with pytest.raises(ValueError, match="no image"):
        machine.model.save("a.png", ImageRequest(2, 2))
    publisher.publish(image(9))
    path = machine.model.save("a.png", ImageRequest(2, 2, rotation=1))
    assert path == machine.folder / "a.png"
    with Picture.open(path) as saved:
        assert saved.size == (6, 8) and saved.getpixel((0, 0)) == (9, 9, 9)
    with pytest.raises(ValueError, match="png"):
        machine.model.save("a.exe", ImageRequest(2, 2))
    with pytest.raises(OSError, match="nowhere"):
        machine.model.save("nowhere/a.png", ImageRequest(2, 2))
    assert [each.name for each in machine.folder.iterdir()] == ["a.png"]


def test_a_name_that_is_no_topic_is_not_listened_to(machine) -> None:
    running = machine.open("/no//topic")
    assert machine.model.topic == "" and running.program.status is None


def test_a_perspective_keeps_how_images_are_shown_and_nonsense_is_passed_over(machine) -> None:
    kept = {
        "topic": "/camera",
        "publish_click_location": True,
        "zoom1": True,
        "rotate": 3,
        "dynamic_range": True,
        "max_range": 2.5,
    }
    session = machine.other("rqt_gui_cpp_node_1").session
    assert ImageViewPlugin(PluginPlace(session, machine.node, settings=kept)).settings() == kept
    nonsense = dict.fromkeys(kept, "\x1b[2J//") | {"rotate": 2**70 + 1, "max_range": float("nan")}
    plain = ImageViewPlugin(PluginPlace(session, machine.node)).settings()
    assert ImageViewPlugin(PluginPlace(session, machine.node, settings=nonsense)).settings() == plain | {"rotate": 1}


class Model:
    """A model with one image; it writes down what the window requests."""

    def __init__(self, message: Image | None) -> None:
        self.topics = {"/camera": "sensor_msgs/msg/Image", "/other": "sensor_msgs/msg/Image"}
        self.topic = "/camera"
        self.view = ImageRequest(0, 0)
        self.received = 1
        self.version = 1
        self.publishes_clicks = False
        self.mouse_topic = "/camera_mouse_left"
        self.message = message
        self.requests: list[tuple[Any, ...]] = []
        self.seen: list[ImageRequest] = []

    picture = ImageView.picture

    def path(self, name: str) -> Path:
        return Path("/nowhere") / name

    def _message(self) -> Any:
        return self.message

    def __getattr__(self, name: str) -> Callable[..., object]:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *given: self.requests.append((name, *given))


def use(
    model: Model, act: Callable[[ToolWindow], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any
) -> None:
    use_window(("rqt_image_view", "Image View", model), act, size, ToolWindow, **options)


def halves() -> Image:
    """Black at the left, white at the right."""
    data = np.zeros((40, 40), np.uint8)
    data[:, 20:] = 255
    return Image(height=40, width=40, encoding="mono8", step=40, data=data.tobytes())


def test_size_and_encoding_are_told_and_a_click_finds_its_pixel() -> None:
    async def act(window: ToolWindow) -> None:
        assert "40x40 mono8" in window.text
        # 78 x 19 cells of two pixels, below the bar, the frame and a line: the image has 38 x 38 of them, from column 20 on.
        await window.pilot.click(offset=(1 + 20, 3))
        await window.pilot.click(offset=(1 + 20 + 37, 21))
        assert window.model.requests == [("click", 0, 0), ("click", 39, 38)]
        await window.pilot.click(offset=(5, 5))
        assert len(window.model.requests) == 2

    use(Model(halves()), act)


def test_keys_choose_a_topic_zoom_rotate_and_save() -> None:
    async def act(window: ToolWindow) -> None:
        await window.press("t", "down", "enter", "m", "r", "1", "d")
        assert window.model.requests == [("choose", "/other"), ("publish_clicks", True)]
        assert "90°" in window.text and "1:1" in window.text and "dynamic range" in window.text
        await window.press("R", "x", "end", "0", "0", "0", "enter")
        assert "A number from 0.01 to 100." in window.text
        await window.press("backspace", "backspace", "enter", "ctrl+s", "enter")
        assert "100" not in window.text and window.model.requests[-1][:2] == ("save", "image.png")

    use(Model(halves()), act)


@pytest.mark.parametrize("key", ["w", "ctrl+s"])
@pytest.mark.parametrize(("language", "title"), [("en", "Save as image"), ("zh", "把图像保存为")])
def test_w_saves_as_in_the_other_windows_of_rqt(key: str, language: str, title: str) -> None:
    async def act(window: ToolWindow) -> None:
        await window.press(key)
        assert title in window.text
        await window.press("enter")
        assert window.model.requests[-1][:2] == ("save", "image.png")

    use(Model(halves()), act, lang=language)


@pytest.mark.parametrize(
    ("message", "topic", "told"),
    [
        (image(encoding="\x1b]0;T\x07"), "/camera", "Unrecognized image encoding [^[]0;T^G]"),
        (None, "/camera", "Waiting for an image on /camera."),
        (None, "/gone", "Nobody publishes /gone."),
        (None, "", "t chooses a topic."),
    ],
)
def test_the_truth_is_told_where_there_is_no_picture(message, topic, told) -> None:
    model = Model(message)
    model.topic = topic

    async def act(window: ToolWindow) -> None:
        assert told in window.text.replace("┃\n┃ ", "").replace("  ", "")

    use(model, act, (120, 24))


def test_the_last_image_of_a_camera_that_has_gone_is_marked_as_such() -> None:
    model = Model(halves())

    async def act(window: ToolWindow) -> None:
        assert "Nobody publishes" not in window.text
        model.topics = {}
        model.version += 1
        await step(window.app, window.pilot)
        assert "40x40 mono8" in window.text and "Nobody publishes /camera." in window.text

    use(model, act)


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_the_controls_stand_above_with_their_keys_also_beside_a_long_name(size: tuple[int, int], lang: str) -> None:
    model = Model(halves())
    model.topic = "/robot/sensors/front/left/camera/image_raw/of_great_length"

    async def act(window: ToolWindow) -> None:
        head = window.text.split("\n")[2]
        assert "…" in head or size[0] == 120
        assert all(each in head for each in ("t /robot", "▾", "1 [ ] 1:1", "r 0°", "d [ ]", "m [ ]")) or size[0] == 120
        assert catalogue(lang)["images.mouse"] in head

    use(model, act, size, lang=lang)


def test_without_colours_or_utf8_brightness_is_a_letter() -> None:
    async def act(window: ToolWindow) -> None:
        row = next(line for line in window.text.splitlines() if "@" in line)
        assert "@" * 15 in row and row.index("@") >= 35

    use(Model(halves()), act, glyphs="ascii")


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (12, 4), (120, 40)])
@pytest.mark.parametrize(
    "options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}, {"glyphs": "cell"}, {"glyphs": "braille"}]
)
def test_it_is_drawn_at_every_size(size, options) -> None:
    async def act(window: ToolWindow) -> None:
        await window.press("1", "right", "down", "r", "r", "1")
        window.model.message = image(3, 3840, 2160)
        window.model.received += 1
        await step(window.app, window.pilot)
        assert "Error" not in window.text

    use(Model(halves()), act, size, **options)


# -- showimage, which draws in the same way ----------------------------------------------------------------------------


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_showimage_draws_the_image_from_the_first_line_on(size: tuple[int, int], lang: str) -> None:
    shown = ShownImage()

    async def act(window: ToolWindow) -> None:
        assert "▀" not in window.text
        shown.take(halves())
        await step_until(window.app, window.pilot, lambda: "40x40 mono8" in window.text)
        assert "/image" in window.text
        # All rows inside the frame; the left half is black, the right one white.
        rows = [line for line in window.pane._lines if line]
        assert len(rows) == (size[1] - 4) and [segment.cell_length for segment in rows[0]] == [size[1] - 4] * 2
        await window.pilot.hover(offset=(size[0] // 2, size[1] // 2))
        await step(window.app, window.pilot)
        assert re.search(r"x \d+  y \d+", window.text)

    use_window(("showimage", "/image", shown), act, size, ToolWindow, lang=lang)


def test_showimage_tells_what_it_cannot_draw() -> None:
    shown = ShownImage()

    async def act(window: ToolWindow) -> None:
        shown.take(image(0, encoding="rgb8"))
        await step_until(window.app, window.pilot, lambda: "┃ Image is wrongly formed: step < width" in window.text)

    use_window(("showimage", "/image", shown), act, (80, 24), ToolWindow)
