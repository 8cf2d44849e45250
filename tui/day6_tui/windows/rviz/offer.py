"""The offer to look at a robot that has come and is small in the picture, as RViz's camera, 10 m away, shows most."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.status import OK
from day6_tui.windows.rviz.extent import extent, share_of_picture

SMALL = 0.4
"""A robot that takes less than this share of the picture is small."""


class FocusOffer:
    """Made once, for the first robot that is in its place; over when the camera moves."""

    def __init__(self, rviz: RViz) -> None:
        self._rviz = rviz
        self._seen = -1
        self._camera: int | None = None
        """The `view_version` for which the offer was made."""
        self._over = False

    @property
    def open(self) -> bool:
        return self._camera is not None and not self._over

    def pull(self, aspect: float) -> bool:
        """Look at the scene, whose picture is `aspect` times as wide as high; return whether the offer came or went."""
        rviz = self._rviz
        if self._over:
            return False
        if self._camera is not None:
            self._over = rviz.view_version != self._camera
            return self._over
        if rviz.version == self._seen:
            return False
        self._seen, scene = rviz.version, rviz.scene
        there = any(each.name for each in scene.shapes) or any(each.name for each in scene.triangles)
        found = extent(scene) if there and rviz.statuses.level == OK else None
        if found is None:
            return False
        if share_of_picture(rviz.view.camera(), *found, aspect) < SMALL:
            self._camera = rviz.view_version
        else:
            self._over = True
        return self.open
