"""Select: what is clicked, or dragged over, is listed under `Selection` (rviz_default_plugins/tools/select)."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.tools.tool import SCREEN, Pointer, Tool


class Select(Tool):
    """Shift adds to the selection, Ctrl takes away."""

    type, title, short, key = "Select", "Select", "Select", "s"
    arrows = SCREEN
    needs_hit = True

    @property
    def status(self) -> str:
        return self.rviz.selection.summary or "Click and drag to select objects on the screen."

    def release(self, pointer: Pointer) -> bool:
        picked = pointer.inside
        if not picked and (hit := pointer.hit) is not None:
            picked = ((hit.owner, hit.owner.thing_at(hit.key, hit.point)),)
        if pointer.shift:
            self.rviz.selection.add_things(picked)
        elif pointer.control:
            self.rviz.selection.remove_things(picked)
        else:
            self.rviz.selection.replace(picked)
        return False
