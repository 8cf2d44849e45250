"""The window on a desktop whose frames the test draws, with the bags of a stepped machine."""

from __future__ import annotations

import pytest
from std_msgs.msg import Float64

from day6_core.ros.programs.rqt_bag.model.view import TimeSpan, divisions, size_text, whole
from tests.rqt_bag.bag_desk import SECOND, START, write_bag, write_images
from tests.tui.screens import ToolWindow, use_window

SIZE = (110, 30)


class BagWindow(ToolWindow):
    """rqt_bag's window; `desk` is the machine that its program runs on."""

    desk = None

    async def go(self, *keys: str) -> None:
        """Press keys, and let the program do what they ask for."""
        for key in keys:
            await self.press(key)
            await self.settle()

    async def settle(self) -> None:
        self.desk.arrive()
        self.desk.machine.until(lambda: not self.desk.model._looks.is_set())
        await self.press()
        await self.draw()

    async def draw(self) -> None:
        from tests.tui.screens import step

        await step(self.app, self.pilot)

    def row(self, topic: str) -> str:
        return next(line for line in self.text.splitlines() if topic in line)


def use(desk, act, size=SIZE, **options):
    BagWindow.desk = desk
    use_window(("rqt_bag", "Bag", desk.model), act, size, BagWindow, **options)


@pytest.fixture
def bag(desk):
    write_bag(desk.folder / "bag")
    desk.open("bag")
    return desk


def test_every_topic_has_a_line_with_marks_where_its_messages_are(bag):
    async def act(tool):
        await tool.settle()
        text = tool.text
        assert "0m00s" in text and "0m05s" in text and "100" in tool.row("/number") and "10 Hz" in tool.row("/number")
        place = tool.pane._place()
        marks = {topic: tool.row(topic)[1 + place.left :][: place.columns] for topic in ("/number", "/word")}
        assert len(marks["/number"].replace(" ", "")) > 40
        assert len(marks["/word"].replace(" ", "")) == 11, "ten messages and the playhead"
        assert "0.000s  Jul 22 2023" in text

    use(bag, act, glyphs="ascii")


def test_keys_choose_publish_and_move_the_playhead(bag):
    numbers = bag.watch(Float64, "/number")

    async def act(tool):
        await tool.go("enter")
        assert "[x] /number" in tool.text
        await tool.go(".", ".", ",")
        assert [each.data for each in numbers] == [0.0, 1.0, 2.0, 1.0]
        await tool.go("end")
        assert "9.900s" in tool.text and numbers[-1].data == 99.0
        await tool.go("home", "down", "enter")
        assert bag.model.player.publishing == {"/number", "/static"}
        await tool.go("a", "a")
        assert bag.model.player.publishing == set()
        await tool.go("shift+right")
        assert 0.05 < bag.playhead < 0.5

    use(bag, act)


def test_playing_shows_its_speed_and_doubles_it(bag):
    async def act(tool):
        await tool.go("space")
        assert " > " in tool.text and bag.model.player.playhead.speed == 1.0
        await tool.go("+")
        assert ">> 2x" in tool.text
        await tool.go("-", "-")
        assert "> 1/2x" in tool.text
        await tool.go("space")
        assert bag.model.player.playhead.speed == 0.0

    use(bag, act, glyphs="ascii")


def test_a_region_is_selected_at_the_playhead_and_goes_with_escape(bag):
    async def act(tool):
        bag.jump(2.0)
        await tool.go("[")
        bag.jump(4.0)
        await tool.go("]")
        assert bag.model.player.region == (START + 2 * SECOND, START + 4 * SECOND)
        assert "=====" in tool.text
        await tool.go("escape")
        assert bag.model.player.region is None

    use(bag, act, glyphs="ascii")


def test_the_mouse_scrubs_selects_zooms_and_ticks(bag):
    async def act(tool):
        await tool.settle()
        pane = tool.pane
        place = pane._place()
        row, left = 1 + 2, 1 + place.left
        await tool.pilot.mouse_down(pane, offset=(left + place.columns // 2, row))
        await tool.settle()
        assert bag.playhead == pytest.approx(5.0, abs=0.2)
        await tool.pilot.hover(pane, offset=(left + place.columns // 4, row))
        await tool.settle()
        assert bag.playhead == pytest.approx(2.5, abs=0.2)
        await tool.pilot.mouse_up(pane, offset=(left + place.columns // 4, row))
        await tool.pilot.mouse_down(pane, offset=(left, 2))
        await tool.pilot.hover(pane, offset=(left + place.columns // 2, 2))
        await tool.pilot.mouse_up(pane, offset=(left + place.columns // 2, 2))
        await tool.settle()
        begin, end = bag.model.player.region
        assert (begin - START) / SECOND == pytest.approx(0.0, abs=0.2)
        assert (end - START) / SECOND == pytest.approx(5.0, abs=0.2)
        await tool.pilot.click(pane, offset=(2, row + 1))
        await tool.settle()
        assert bag.model.player.publishing == {"/static"}

    use(bag, act)


def test_zooming_keeps_the_playhead_in_its_place_and_zero_shows_everything(bag):
    async def act(tool):
        bag.jump(5.0)
        await tool.settle()
        place = tool.pane._place()
        before = tool.pane._playhead_column(place)
        await tool.go("pageup", "pageup")
        assert tool.pane.view.span < 3 * SECOND
        assert tool.pane._playhead_column(place) == pytest.approx(before, abs=1)
        await tool.go("right", "0")
        assert tool.pane.view == whole(START, START + 99 * SECOND // 10)

    use(bag, act)


def test_the_message_of_the_chosen_topic_is_shown_and_its_field_can_be_plotted(bag):
    chosen = []

    async def act(tool):
        await tool.go("v")
        bag.jump(4.2)
        await tool.settle()
        assert "data: 42.0" in tool.text
        await tool.go("tab")
        post = tool.pane.post_message
        tool.pane.post_message = lambda message: chosen.append(message) or post(message)
        await tool.press("g")

    use(bag, act)
    assert any(getattr(each, "command", "") == "ros2 run rqt_plot rqt_plot /number/data" for each in chosen)


def test_topics_are_chosen_for_a_new_bag(bag):
    async def act(tool):
        await tool.go("w")
        assert "Which topics should be exported?" in tool.text and tool.text.count("[x]") == 4
        await tool.go("space", "down", "space", "enter")
        assert "Save selected region" in tool.text
        for _ in range(30):
            await tool.press("backspace")
        await tool.press(*"part", "enter")
        bag.machine.until(lambda: "messages in" in bag.model.status)
        await tool.draw()
        assert '100 messages in "part"' in tool.text

    use(bag, act)


def test_a_long_reason_is_told_whole_and_gives_way_to_the_topic(bag):
    async def act(tool):
        bag.model.tell("Loading 'x' failed due to: " + "a reason that goes on " * 5 + "to its end", failed=True)
        await tool.settle()
        assert "to its end" in tool.text
        await tool.go("down")
        assert "to its end" not in tool.text and "std_msgs/msg/String" in tool.text

    use(bag, act, size=(80, 24))


@pytest.mark.parametrize(("lang", "text"), (("en", "'bag' is incomplete"), ("zh", "'bag' 不完整")))
def test_what_rqt_bag_has_no_words_for_is_told_in_the_users_language(desk, lang, text):
    file = write_bag(desk.folder / "bag") / "bag_0.mcap"
    file.write_bytes(file.read_bytes()[:-500])
    desk.open("bag")

    async def act(tool):
        await tool.settle()
        assert text in tool.text

    use(desk, act, lang=lang)


def test_without_a_bag_the_window_says_what_to_do(desk):
    desk.open(topics=0)

    async def act(tool):
        assert "No bag is open" in tool.text

    use(desk, act)


# -- images ------------------------------------------------------------------------------------------------------------


def colours_of(tool, lines):
    """The colours of the cells of these lines of the pane."""
    found = set()
    for line in lines:
        for segment in tool.pane._strip(line):
            if segment.text.strip("│┃") and segment.style is not None and segment.style.bgcolor is not None:
                triplet = segment.style.bgcolor.triplet
                found.add(triplet.hex if triplet is not None else "")
    return found


async def pictures(tool, desk):
    """Let the images be read that the window asks for."""
    for _ in range(3):
        await tool.draw()
        desk.machine.until(lambda: not desk.model._missing)
        desk.machine.until(lambda: not desk.model._wanted_pictures.is_set())
    await tool.draw()


def test_thumbnails_of_images_lie_along_the_line_of_their_topic(desk):
    write_images(desk.folder / "bag")
    desk.open("bag", topics=1)

    async def act(tool):
        await tool.go("t")
        desk.machine.until(lambda: desk.model._pictures)
        await pictures(tool, desk)
        desk.machine.until(lambda: len(desk.model._pictures) >= 5)
        await pictures(tool, desk)
        assert {"#ff0000", "#00ff00"} <= colours_of(tool, range(3, 7))

    use(desk, act)


def test_the_image_at_the_playhead_is_shown_below_the_timeline(desk):
    write_images(desk.folder / "bag")
    desk.open("bag", topics=1)

    async def act(tool):
        await tool.go("v")
        desk.machine.until(lambda: desk.model._pictures)
        await pictures(tool, desk)
        place = tool.pane._place()
        below = range(4 + place.rows, 4 + place.rows + 5)
        assert "#ff0000" in colours_of(tool, below)
        desk.jump(8.0)
        await tool.settle()
        await pictures(tool, desk)
        desk.machine.until(lambda: len(desk.model._pictures) >= 2)
        await pictures(tool, desk)
        assert "#00ff00" in colours_of(tool, below)
        await tool.go("tab")
        assert "encoding: rgb8" in tool.text

    use(desk, act)


def test_an_image_of_an_unknown_encoding_is_told_and_nothing_hangs(desk):
    write_images(desk.folder / "bag", "strange")
    desk.open("bag", topics=1)

    async def act(tool):
        await tool.go("v")
        desk.machine.until(lambda: desk.model.failed)
        await tool.draw()
        assert "Unsupported image format: strange" in tool.text

    use(desk, act)


# -- recording ---------------------------------------------------------------------------------------------------------


def test_a_recording_is_started_from_the_list_of_topics_and_stopped_with_r(desk):
    publisher = desk.machine.node.create_publisher(Float64, "/number", 10)
    desk.open(topics=0)

    async def act(tool):
        await tool.press("r")
        assert "Select the topics you want to record" in tool.text and "[x] /number" in tool.text
        await tool.press("enter", "enter")
        desk.machine.until(lambda: desk.model.recorder is not None)
        desk.machine.advance(0.2)
        publisher.publish(Float64(data=1.0))
        desk.machine.advance(0.2)
        await tool.draw()
        assert "recording: " in tool.text
        await tool.press("r")
        desk.machine.until(lambda: desk.model.bags and not desk.model.loading)
        assert "/number" in desk.model.topics

    use(desk, act)


def test_a_new_recording_is_seen_whole_however_the_last_bag_was_looked_at(bag):
    publisher = bag.machine.node.create_publisher(Float64, "/fresh", 10)

    async def act(tool):
        await tool.go("pageup", "pageup", "v")
        bag.model.record("new", None)
        bag.machine.until(lambda: bag.model.recorder is not None)
        bag.machine.advance(0.2)
        publisher.publish(Float64(data=1.0))
        bag.machine.advance(0.2)
        bag.model.stop_recording()
        bag.machine.until(lambda: bag.model.bags and not bag.model.loading and "/fresh" in bag.model.topics)
        await tool.settle()
        timeline = bag.model.timeline
        assert tool.pane.view == whole(timeline.start_ns, timeline.end_ns)
        assert "data: " not in tool.text and bag.model.player.watched == set()

    use(bag, act)


# -- the axis ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("seconds", "columns", "labels"),
    (
        (10, 60, ["0m00s", "0m05s", "0m10s"]),
        (0.1, 50, ["0.00s", "0.05s", "0.10s"]),
        (3600 * 5, 60, ["0h", "1h", "2h", "3h", "4h", "5h"]),
        (1200, 60, ["0m", "5m", "10m", "15m", "20m"]),
        (400 * 86400, 40, ["0w", "15w", "30w", "45w"]),
    ),
)
def test_the_axis_is_labelled_as_in_rqt_bag(seconds, columns, labels):
    view = TimeSpan(START, START + round(seconds * SECOND) + 1)
    assert [text for _, text in divisions(view, START, columns, 10)] == labels


def test_sizes_are_written_as_in_rqt_bag():
    assert [size_text(size) for size in (0, 512, 1536, 3 << 20)] == ["0 B", "512.0 B", "1.5 KB", "3.0 MB"]


def test_the_view_follows_a_playhead_that_leaves_it():
    view = TimeSpan(0, 100)
    assert view.following(50, 0, 1000) == view
    assert view.following(110, 0, 1000) == TimeSpan(85, 185)
    assert view.following(1000, 0, 1000) == TimeSpan(900, 1000)
    assert TimeSpan(500, 600).following(490, 0, 1000) == TimeSpan(415, 515)
