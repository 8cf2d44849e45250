"""What the window of showimage shows: the newest image.

Messages are kept as they come; of the newest one the window reads only the pixels that there is room for.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rqt_image_view.decoding import DecodedImage, ImageRequest, Undecodable, picture_of

if TYPE_CHECKING:
    from day6_core.session.display import Window
    from day6_core.session.session import Session


class ShownImage:
    """The model of a window with nothing but an image, which is fitted in."""

    version = 0
    view = ImageRequest(0, 0)

    def __init__(self) -> None:
        self.received = 0
        self._newest: Any = None

    def take(self, message: Any) -> None:
        """Show another sensor_msgs/Image."""
        self._newest = message
        self.received += 1

    def picture(self, view: ImageRequest) -> DecodedImage | None:
        """Return the newest image as it is to be shown; None while there is none. Raises Undecodable."""
        message = self._newest
        try:
            return None if message is None else picture_of(message, view)
        except Undecodable as error:
            raise Undecodable(error.reason) from error  # the words around it are those of rqt_image_view


class ImageWindow:
    """cv::imshow: the first image opens the window, which has its name as title."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._image = ShownImage()
        self._window: Window[ShownImage] | None = None

    def show(self, name: str, message: Any) -> None:
        """Show an image, if there is a screen."""
        self._image.take(message)
        if self._window is None and self._session.display is not None:
            self._window = self._session.display.open("showimage", name, self._image)

    @property
    def closed(self) -> bool:
        """Whether somebody has closed the window, which ends the program."""
        return self._window is not None and self._window.closed
