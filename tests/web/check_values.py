"""Checks hub/values.yaml against the chart: python -m tests.web.check_values CHART

CHART is the folder `jupyterhub` of a checkout of Zero to JupyterHub. As helm does, the values are laid over the chart's own
before they are checked. Needs jsonschema.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import jsonschema
import yaml

VALUES = Path(__file__).resolve().parents[2] / "hub" / "values.yaml"


def merged(below: Any, above: Any) -> Any:
    if not (isinstance(below, dict) and isinstance(above, dict)):
        return above
    return {**below, **{key: merged(below.get(key), value) for key, value in above.items()}}


def main() -> None:
    chart = Path(sys.argv[1])
    schema, defaults = (
        yaml.safe_load((chart / name).read_text(encoding="utf-8")) for name in ("values.schema.yaml", "values.yaml")
    )
    values = yaml.safe_load(VALUES.read_text(encoding="utf-8"))
    errors = list(jsonschema.Draft7Validator(schema).iter_errors(merged(defaults, values)))
    for error in errors:
        print("/".join(map(str, error.path)), error.message)
    print(f"{len(errors)} errors")
    sys.exit(bool(errors))


if __name__ == "__main__":
    main()
