"""A list of substitutions from whatever may stand for a text."""

from __future__ import annotations

from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """Return substitutions that give the text together; TypeError for what is neither string nor substitution."""
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
