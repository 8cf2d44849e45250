"""The dishes: what those of a message type look like, and where on their way the moving ones are. Pure.

Shape, letter and colour all say the same, the type: whoever cannot tell colours apart sees the letter, and who stands far away
the shape. A dish moves only because a message passed; where many pass, only some of them are drawn.
"""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import NamedTuple


class Ware(NamedTuple):
    """A kind of dish, for the message types that match one of `types` (patterns of shell)."""

    edges: str
    """Left and right of the letter where a dish is three characters."""
    fine: tuple[str, str]
    """Where a dish is two lines of five: with block characters; `?` is the letter."""
    plain: tuple[str, str]
    """The same in ASCII."""
    types: tuple[str, ...]


WARES = (
    # A plate: what somebody is to do.
    Ware("()", ("  ?  ", "▀███▀"), ("  ?  ", "(___)"), ("*/Twist*", "*/Accel*", "*/Wrench*", "*/AckermannDrive*")),
    # A bowl: words.
    Ware("{}", ("▖ ? ▗", "▜███▛"), ("{ ? }", "{___}"), ("*/String", "*/Char", "*/Log", "*/UInt8MultiArray")),
    # A box: numbers.
    Ware("[]", ("▛▀▀▀▜", "▙▄?▄▟"), (".___.", "[_?_]"), ("std_msgs/*", "*_interfaces/msg/Num*")),
    # A cover: places.
    Ware(
        "<>",
        (" ▗▀▖ ", "▟▌?▐▙"),
        ("  ^  ", "<_?_>"),
        ("*/Pose*", "*/Point*", "geometry_msgs/*", "tf2_msgs/*", "nav_msgs/*"),
    ),
    # A frame: what one sees.
    Ware("##", ("█▀▀▀█", "█▄?▄█"), ("#===#", "#_?_#"), ("*Image", "*/CameraInfo", "*/Color*", "*/Marker*")),
    # A cup: what was measured.
    Ware("\\/", ("▌▁▁▁▐", "▝▙?▟▘"), ("\\   /", " \\?/ "), ("sensor_msgs/*", "*/Clock", "*/Time", "*/BatteryState")),
    # A parcel: types of one's own, and all others.
    Ware("==", ("▄▄█▄▄", "█▄?▄█"), ("==+==", "|_?_|"), ("*",)),
)
"""The shapes of all dishes: the first ware that a type matches is its."""

LETTERS = {"String": "S", "Twist": "T", "Pose": "P", "Int32": "I", "JointState": "J"}
"""Types that everybody meets have the same letter every time."""

TRAVEL_SECONDS = 1.8
"""How long a dish is on its way."""

GAP_SECONDS = 0.45
"""Between two dishes from one cook: at 62 messages a second the eye could not follow them."""

WAITING = 2
"""Most dishes that wait for their turn; of what passes meanwhile nothing is drawn."""


class Dish(NamedTuple):
    """How the dishes of a type look: three characters, and the number of its ware in WARES, which is that of its colour."""

    text: str
    ware: int

    def lines(self, *, fine: bool) -> tuple[str, str]:
        """The dish in two lines of five cells."""
        ware = WARES[self.ware]
        top, bottom = ware.fine if fine else ware.plain
        return top.replace("?", self.text[1]), bottom.replace("?", self.text[1])


class Dishes:
    """Gives every type its looks, for as long as the window is open: the shape of its kind, and a letter of its own."""

    def __init__(self) -> None:
        self._looks: dict[str, Dish] = {}

    def of(self, type_name: str) -> Dish:
        """The looks of a type, like `geometry_msgs/msg/Twist`."""
        dish = self._looks.get(type_name)
        if dish is None:
            number, ware = next(
                (number, ware)
                for number, ware in enumerate(WARES)
                if any(fnmatchcase(type_name, pattern) for pattern in ware.types)
            )
            text = f"{ware.edges[0]}{self._letter(type_name)}{ware.edges[1]}"
            dish = self._looks[type_name] = Dish(text, number)
        return dish

    def _letter(self, type_name: str) -> str:
        """A letter of the type's own name that no other type has; then a digit, then its first letter after all."""
        name = type_name.rsplit("/", 1)[-1]
        taken = {dish.text[1] for dish in self._looks.values()}
        if (own := LETTERS.get(name)) and own not in taken:
            return own
        letters = [letter for letter in name.upper() if letter.isascii() and letter.isalnum()]
        free = [each for each in (*letters, *"123456789") if each not in taken]
        others = [each for each in free if each not in LETTERS.values()]
        return next(iter((*others, *free)), letters[0] if letters else "?")


Lane = tuple[str, str]
"""A topic and the cook whose dishes these are."""


class Conveyor:
    """The dishes that are on their way. Times are seconds of a monotonic clock."""

    def __init__(self) -> None:
        self._began: dict[Lane, list[float]] = {}
        self._waiting: dict[Lane, int] = {}

    def put(self, lane: Lane, count: int) -> None:
        """So many messages have passed on a lane."""
        if count > 0:
            self._waiting[lane] = min(self._waiting.get(lane, 0) + count, WAITING)

    def advance(self, now: float) -> None:
        """Let waiting dishes begin their way, and take away those that have arrived."""
        for lane in list(self._waiting):
            began = self._began.setdefault(lane, [])
            if not began or now - began[-1] >= GAP_SECONDS:
                began.append(now)
                self._waiting[lane] -= 1
                if not self._waiting[lane]:
                    del self._waiting[lane]
        for lane, began in list(self._began.items()):
            began[:] = [each for each in began if now - each <= TRAVEL_SECONDS]
            if not began:
                del self._began[lane]

    def clear(self) -> None:
        """Take all dishes away."""
        self._began.clear()
        self._waiting.clear()

    def on_the_way(self, lane: Lane, now: float) -> list[float]:
        """How far (0 to 1) the dishes of a lane are, the first one first."""
        return [(now - began) / TRAVEL_SECONDS for began in self._began.get(lane, ())]

    @property
    def moving(self) -> int:
        """How many dishes are on their way or wait for it."""
        return sum(map(len, self._began.values())) + sum(self._waiting.values())
