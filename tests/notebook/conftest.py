"""A kernel for each test, where there is one."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.notebook.kernel import Kernel


@pytest.fixture
def kernel(short_folder: Path) -> Iterator[Kernel]:
    pytest.importorskip("jupyter_client", reason="there is no ipykernel here")
    pytest.importorskip("ipykernel", reason="there is no ipykernel here")
    from tests.notebook.kernel import Kernel

    made = Kernel(short_folder / "r")
    yield made
    made.close()
