"""A list of substitutions from any value that stands for a text."""

from __future__ import annotations

from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """Return the substitutions that make up the text. Raises TypeError for anything but strings and substitutions."""
    if isinstance(subs, (str, Substitution)):
        return [_substitution(subs)]
    return [_substitution(each) for each in subs]


def _substitution(item: Any) -> Substitution:
    from launch.substitutions.text_substitution import TextSubstitution

    if isinstance(item, Substitution):
        return item
    if isinstance(item, str):
        return TextSubstitution(text=item)
    raise TypeError(
        f"Failed to normalize given item of type '{type(item)}', when only 'str' or 'launch.Substitution' were expected."
    )
