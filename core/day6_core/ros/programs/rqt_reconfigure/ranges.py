"""The numbers that a descriptor's range allows, as the places of a slider."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterDescriptor

DIVISIONS = 100
"""Places of a slider without steps (param_editors.py of rqt_reconfigure: `scale = 100 / range`)."""

ROUNDING = 1e-9
"""Parts of a step by which a sum of steps may be off."""


@dataclass(frozen=True, slots=True)
class Range:
    """From `minimum` to `maximum`, finite and in this order; `step` is 0 where every number between them is allowed."""

    minimum: float
    maximum: float
    step: float
    whole: bool
    """Whether only integers are meant."""

    def place(self, value: float) -> float:
        """Where a value lies, from 0 to 1; those outside lie at the ends, what isn't a number at the lower one."""
        if not value > self.minimum:
            return 0.0
        return (min(value, self.maximum) - self.minimum) / (self.maximum - self.minimum)

    def at(self, place: float) -> float:
        """The allowed value next to a place from 0 to 1."""
        return self.next_to(self.minimum + min(max(place, 0.0), 1.0) * (self.maximum - self.minimum))

    def next_to(self, value: float) -> float:
        """The allowed value next to another one: both ends, and whole steps from the lower one."""
        value = min(max(value, self.minimum), self.maximum)
        if self.step:
            stepped = self.minimum + round((value - self.minimum) / self.step) * self.step
            value = min(stepped, self.maximum, key=lambda each: abs(each - value))
        # Steps of 0.1 add up to 0.30000000000000004.
        return min(round(value), round(self.maximum)) if self.whole else float(f"{min(value, self.maximum):.12g}")

    def moved(self, value: float, steps: int) -> float:
        """The allowed value so many steps on, at most the end; from between two steps the first one leads to the next of them."""
        start = min(max(value, self.minimum), self.maximum) if value == value else self.minimum
        step, way = self.step or (self.maximum - self.minimum) / DIVISIONS, start - self.minimum
        if self.whole:
            before, after = way // step, -(-way // step)
        else:
            before, after = math.floor(way / step + ROUNDING), math.ceil(way / step - ROUNDING)
        goal = self.minimum + ((before if steps > 0 else after) + steps) * step
        goal = min(max(goal, self.minimum), self.maximum)
        return goal if self.whole else float(f"{goal:.12g}")

    @property
    def tenth(self) -> int:
        """The steps that are about a tenth of the whole way."""
        return max(1, round((self.maximum - self.minimum) / (self.step * 10))) if self.step else DIVISIONS // 10


def range_of(descriptor: ParameterDescriptor) -> Range | None:
    """The range of a number as a slider; None if there is none, or one that says nothing: inverted, empty, not finite."""
    for given, whole in ((descriptor.integer_range, True), (descriptor.floating_point_range, False)):
        if given:
            low, high, step = given[0].from_value, given[0].to_value, given[0].step
            if not (math.isfinite(low) and math.isfinite(high) and low < high and math.isfinite(high - low)):
                return None
            step = step if math.isfinite(step) and step > 0 else 0
            return Range(low, high, step or (1 if whole else 0), whole)
    return None
