"""The window of image_tools' showimage, OpenCV's in real ROS: the newest image and nothing else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.windows.images.picture_pane import PicturePane

if TYPE_CHECKING:
    from day6_core.ros.programs.image_tools.shown_image import ShownImage


class ShowImagePane(PicturePane["ShownImage"]):
    """Draws the newest image."""

    model: ShownImage
