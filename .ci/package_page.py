"""What the package's page shows: the project's addresses, and the README with links that work outside the repository.

A metadata hook of hatchling. Every address begins with `repository` in pyproject.toml.
"""

from __future__ import annotations

import re
from pathlib import Path, PurePosixPath
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

PLACES = {
    "Homepage": "",
    "Documentation": "/tree/main/docs",
    "Changelog": "/blob/main/CHANGELOG.md",
    "Issues": "/issues",
    "Source": "",
}
PICTURES = (".gif", ".jpg", ".png", ".svg", ".webp")
RELATIVE_LINK = re.compile(
    r"""
    ^(?P<fence>`{3,}|~{3,}) .*? ^(?P=fence)                             # a block of code stays as it is
    | (?P<before> \]\( | ^\[[^\]\n]+\]:[ ] | \b(?:href|src|srcset)=" )  # Markdown, its references, HTML
      (?!\w+:|\#|/) (?P<path>[^\s)"]+)
    """,
    re.DOTALL | re.MULTILINE | re.VERBOSE,
)


class PackagePage(MetadataHookInterface):
    """Fills in `readme` and `urls`."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Fill them in, linked to the files of this version."""
        repository = self.config["repository"]
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        metadata["urls"] = {name: repository + place for name, place in PLACES.items()}
        metadata["readme"] = {
            "content-type": "text/markdown",
            "text": with_absolute_links(text, repository, f"v{metadata['version']}"),
        }


def with_absolute_links(text: str, repository: str, revision: str) -> str:
    """Return the Markdown with each link to a file leading to that file at a revision of the repository."""

    def absolute(link: re.Match[str]) -> str:
        if link["fence"]:
            return link[0]
        suffix = PurePosixPath(link["path"].partition("#")[0]).suffix
        return f"{link['before']}{repository}/{'raw' if suffix in PICTURES else 'blob'}/{revision}/{link['path']}"

    return RELATIVE_LINK.sub(absolute, text)
