"""The dishes: what those of a message type look like, and where on their way the moving ones are. Pure.

Shape, letter and colour all say the same, the type: whoever cannot tell colours apart sees the letter, and who stands far away
the shape. A dish moves only because a message passed; where many pass, only some of them are drawn.
"""

from __future__ import annotations

from typing import NamedTuple

SHAPES = (("(", ")"), ("[", "]"), ("<", ">"), ("{", "}"))
"""Left and right edge of a dish."""

COLOURS = 4
"""How many colours a window has to tell types apart."""

TRAVEL_SECONDS = 1.8
"""How long a dish is on its way."""

GAP_SECONDS = 0.45
"""Between two dishes from one cook: at 62 messages a second the eye could not follow them."""

WAITING = 2
"""Most dishes that wait for their turn; of what passes meanwhile nothing is drawn."""


class Dish(NamedTuple):
    """How the dishes of a type look: three characters, and the number of a colour."""

    text: str
    colour: int


class Dishes:
    """Gives every type its looks, for as long as the window is open; the first types are alike in nothing."""

    def __init__(self) -> None:
        self._looks: dict[str, Dish] = {}

    def of(self, type_name: str) -> Dish:
        """The looks of a type, like `geometry_msgs/msg/Twist`."""
        dish = self._looks.get(type_name)
        if dish is None:
            number = len(self._looks)
            left, right = SHAPES[number % len(SHAPES)]
            dish = self._looks[type_name] = Dish(f"{left}{self._letter(type_name)}{right}", number % COLOURS)
        return dish

    def _letter(self, type_name: str) -> str:
        """A letter of the type's own name that no other type has; then a digit, then its first letter after all."""
        name = type_name.rsplit("/", 1)[-1]
        taken = {dish.text[1] for dish in self._looks.values()}
        letters = [letter for letter in name.upper() if letter.isascii() and letter.isalnum()]
        return next((each for each in (*letters, *"123456789") if each not in taken), letters[0] if letters else "?")


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
