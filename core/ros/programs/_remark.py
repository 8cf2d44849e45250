"""A remark in plain words about what is missing or odd: a window says it in its language by the id, others in English."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeVar

AnyRemark = TypeVar("AnyRemark", bound="Remark")


@dataclass(frozen=True)
class Remark:
    """One remark; `level` is 'info', 'warning' or 'error'. A derived class has `TEXTS`: the English texts by id."""

    level: str
    id: str
    parameters: tuple[tuple[str, object], ...] = ()

    TEXTS: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def of(cls: type[AnyRemark], level: str, key: str, **parameters: object) -> AnyRemark:
        """Make one with the parameters its text names."""
        return cls(level, key, tuple(parameters.items()))

    @property
    def text(self) -> str:
        """The English words."""
        return self.TEXTS[self.id].format(**dict(self.parameters))
