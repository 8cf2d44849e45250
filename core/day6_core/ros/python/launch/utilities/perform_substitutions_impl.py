"""The text of a sequence of substitutions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from launch.substitution import Substitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Return their texts, concatenated. Raises SubstitutionFailure if one has no text."""
    return "".join([each.perform(context) for each in subs])
