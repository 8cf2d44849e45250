"""What the kitchen says of a cook or a belt: one sentence in the kitchen's words, one in ROS's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from day6_core.ros.programs.day6_kitchen.belts import Belt, Cook, Hand
from day6_core.ros.programs.day6_kitchen.dishes import Dishes
from day6_tui.appearance.look import Look


class KitchenWords:
    """Speaks the language of the look."""

    def __init__(self, look: Look) -> None:
        self._look = look

    def rate(self, rate: float | None) -> str:
        """Messages per second on a label: '62/s', '1.0/s'; '?/s' where it is not known, '' where nothing passes."""
        if rate is None:
            return "?/s"
        return "" if rate <= 0 else f"{rate:.0f}/s" if rate >= 9.95 else f"{rate:.1f}/s"

    def note(self, belt: Belt, left: int) -> str:
        """What is wrong with a belt, in two words, and how many dishes are left on it; '' if nothing is."""
        texts = self._look.texts
        key = belt.refusals[0].why if belt.refusals else belt.lonely
        told = texts(f"kitchen.note.{key}") if key else ""
        return texts("kitchen.note.left", note=told, count=left) if left else told

    def cook(self, cook: Cook) -> str:
        """Explain a cook."""
        texts = self._look.texts
        told = [texts("kitchen.cook", name=cook.command or cook.name)]
        if cook.gives:
            told.append(texts("kitchen.cook.gives", belts=self._list(cook.gives)))
        if cook.takes:
            told.append(texts("kitchen.cook.takes", belts=self._list(cook.takes)))
        if not cook.gives and not cook.takes:
            told.append(texts("kitchen.cook.idle"))
        if cook.count > 1:
            told.append(texts("kitchen.cook.twins", count=cook.count))
        ros = texts("kitchen.cook.ros", name=cook.name, gives=len(cook.gives), takes=len(cook.takes))
        return f"{texts('kitchen.space').join(told)}\n{ros}"

    def belt(self, belt: Belt, dishes: Dishes, rate: float | None, called: Mapping[str, str]) -> str:
        """Explain a belt; `rate` is None where it cannot be measured, `called` are cooks that people call otherwise."""
        texts = self._look.texts
        shape = self._list(
            dishes.of(kind).text for kind in dict.fromkeys(hand.type for hand in belt.givers or belt.takers)
        )
        sides = ((belt.givers, belt.unseen_givers), (belt.takers, belt.unseen_takers))
        givers, takers = (self._hands(hands, unseen, called) for hands, unseen in sides)
        if belt.refusals:
            refusal = belt.refusals[0]
            told = texts(
                f"kitchen.belt.{refusal.why}",
                belt=belt.topic,
                giver=called.get(refusal.giver.cook, refusal.giver.cook),
                taker=called.get(refusal.taker.cook, refusal.taker.cook),
                shape=dishes.of(refusal.giver.type).text,
                wanted=dishes.of(refusal.taker.type).text,
            )
            ros = texts(
                f"kitchen.belt.{refusal.why}.ros",
                belt=belt.topic,
                giver=refusal.giver.cook,
                taker=refusal.taker.cook,
                sent=refusal.giver.type,
                detail=refusal.detail,
            )
            return f"{told}\n{ros}"
        key = belt.lonely or "moves"
        told = texts(f"kitchen.belt.{key}", belt=belt.topic, shape=shape, givers=givers, takers=takers)
        givers, takers = (self._hands(hands, unseen, {}) for hands, unseen in sides)
        ros = texts("kitchen.belt.ros", belt=belt.topic, type=self._list(belt.types), givers=givers, takers=takers)
        if belt.lonely != "unfilled":
            measured = "unknown" if rate is None else "rate" if rate > 0 else "still"
            ros += texts("kitchen.space") + texts(f"kitchen.belt.{measured}", rate=f"{rate or 0.0:.1f}")
        return f"{told}\n{ros}"

    def _hands(self, hands: Iterable[Hand], unseen: int, called: Mapping[str, str]) -> str:
        names = [called.get(name, name) for name in dict.fromkeys(hand.cook for hand in hands)]
        if unseen:
            names.append(self._look.texts("kitchen.unseen", count=unseen))
        return self._list(names) or self._look.texts("kitchen.nobody")

    def _list(self, names: Iterable[str]) -> str:
        return self._look.texts("list.comma").join(names)
