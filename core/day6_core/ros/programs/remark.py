"""A remark in plain words about what is missing or odd: windows translate it by its id, other programs print the English."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

from day6_core.ros.remark_texts import TEXTS

AnyRemark = TypeVar("AnyRemark", bound="Remark")


@dataclass(frozen=True)
class Remark:
    """One remark; `level` is 'info', 'warning' or 'error'."""

    level: str
    id: str
    parameters: tuple[tuple[str, object], ...] = ()

    @classmethod
    def of(cls: type[AnyRemark], level: str, key: str, **parameters: object) -> AnyRemark:
        """Make one with the parameters its text names."""
        return cls(level, key, tuple(parameters.items()))

    @property
    def text(self) -> str:
        """The English words."""
        return TEXTS[self.id].format(**dict(self.parameters))
