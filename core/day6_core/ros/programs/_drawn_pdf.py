"""The PDF of a graph: by graphviz's `dot` where it is installed, as the real tools do, else by our own layout."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

from day6_core.reason import named_reason
from day6_core.ros.programs.rqt_graph.model.image import NO_COLOURS, write_image
from day6_core.ros.programs.rqt_graph.model.layout import layout
from day6_core.ros.programs.rqt_graph.model.pdf import written
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge, LaidOutGraph
from day6_core.session.session import Session
from day6_core.session.threads import in_thread
from day6_core.whole_file import replace_file
from day6_core.width import text_width

LIMIT_SECONDS = 60.0
"""How long `dot` may take."""

NO_PDF = "graphviz (dot) made no PDF"


async def write_pdf(
    session: Session,
    source: Path,
    graph: tuple[list[Box], list[Edge]],
    tell: Callable[[str], object],
    colours: dict[str, str] | None = None,
) -> None:
    """Draw the DOT file `source`, whose boxes and edges are `graph`, into a `.pdf` beside it; whole or not at all.

    `tell` is called with why `dot` could not do it. `colours` as for `write_image`; `dot` reads its own in the file.
    Raises OSError.
    """
    target = source.with_name(f"{source.name.removesuffix('.gv')}.pdf")
    dot = shutil.which("dot", path=session.env.get("PATH"))
    drawn = await _by_dot(session, dot, source, tell) if dot is not None else b""
    if drawn:
        await in_thread(lambda: replace_file(target, drawn))
    else:
        await in_thread(lambda: write_image(laid_out(*graph), target, colours or NO_COLOURS))


def laid_out(boxes: list[Box], edges: list[Edge]) -> LaidOutGraph:
    """Return the layout of a tree with everything in full, as wide as its texts are in a PDF."""
    return layout(boxes, edges, lambda text: text_width(written(text)), bundled=True)


async def _by_dot(session: Session, dot: str, source: Path, tell: Callable[[str], object]) -> bytes:
    """Return the PDF that graphviz makes, b"" if it makes none."""
    running: list[subprocess.Popen[bytes]] = []

    def run() -> tuple[bytes, bytes]:
        command = [dot, "-Tpdf", str(source)]
        pipe = subprocess.PIPE
        with subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe, cwd=session.cwd, env=dict(session.env)
        ) as process:
            running.append(process)
            try:
                return process.communicate(timeout=LIMIT_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
                raise

    try:
        drawn, said = await in_thread(run)
    except (OSError, subprocess.TimeoutExpired) as error:
        tell(f"{NO_PDF}: {named_reason(error)}")
        return b""
    finally:
        for process in running:
            process.kill()  # where the program was interrupted
    session.stderr.write(said.decode("utf-8", "surrogateescape"))
    if running[0].returncode == 0 and drawn.startswith(b"%PDF"):
        return drawn
    tell(f"{NO_PDF}: status {running[0].returncode}")
    return b""
