"""Makes the pictures of the documentation: `python -m tests.pictures` plays docs/pictures/*.yaml, or those named."""

from __future__ import annotations

import argparse
import sys

from tests import conftest as surroundings  # first: it sets every variable

# isort: split
from tests.pictures.playing import drawn
from tests.pictures.script import LANGUAGES, names, picture_of


def main(words: list[str] | None = None) -> int:
    """Play and draw; the exit status is 1 if a script did not reach its screen."""
    parser = argparse.ArgumentParser(prog="python -m tests.pictures", description=__doc__)
    parser.add_argument("names", metavar="NAME", nargs="*", choices=[[], *names()], help="all of them without names")
    parser.add_argument("--lang", choices=LANGUAGES, action="append", help="both without it")
    options = parser.parse_args(words)
    surroundings.set_environment(surroundings.environment())
    failed = 0
    for lang in options.lang or LANGUAGES:
        for name in options.names or names():
            path = picture_of(name, lang)
            try:
                data = drawn(name, lang).encode()
            except AssertionError as error:
                failed += 1
                print(f"{path.name}: {error}", file=sys.stderr)
                continue
            path.write_bytes(data)
            print(f"{path.name}: {len(data) / 1000:.0f} kB", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
