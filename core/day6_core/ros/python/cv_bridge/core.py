"""The class CvBridge (cv_bridge/python/cv_bridge/core.py)."""

from __future__ import annotations

import sys
from typing import Any

import sensor_msgs.msg

from cv_bridge.boost.cv_bridge_boost import (
    DEPTHS,
    CV_MAT_CNWrap,
    CV_MAT_DEPTHWrap,
    cvtColor2,
    getCvType,
    opencv,
)


class CvBridgeError(TypeError):
    """A conversion isn't possible; `str()` says why."""


class CvBridge:
    """Converts between images of messages and arrays: rows x columns for one channel, rows x columns x channels for more."""

    def __init__(self) -> None:
        kinds = list(enumerate(DEPTHS.items()))
        self.cvtype_to_name = {
            number + (channels - 1) * 8: f"{depth}C{channels}"
            for number, (depth, _) in kinds
            for channels in range(1, 5)
        }
        self.cvdepth_to_numpy_depth = {number: kind for number, (_, kind) in kinds}
        self.numpy_type_to_cvtype = {kind: depth for depth, kind in DEPTHS.items()} | DEPTHS

    def dtype_with_channels_to_cvtype2(self, dtype: Any, n_channels: int) -> str:
        """'8UC3' for numpy.uint8 and 3. Raises KeyError for numbers that OpenCV does not have."""
        return f"{self.numpy_type_to_cvtype[dtype.name]}C{n_channels}"

    def cvtype2_to_dtype_with_channels(self, cvtype: int) -> tuple[str, int]:
        """('uint8', 3) for OpenCV's number of 8UC3."""
        return self.cvdepth_to_numpy_depth[CV_MAT_DEPTHWrap(cvtype)], CV_MAT_CNWrap(cvtype)

    def encoding_to_cvtype2(self, encoding: str) -> int:
        """OpenCV's number for an encoding. Raises CvBridgeError for one that isn't known."""
        try:
            return getCvType(encoding)
        except RuntimeError as error:
            raise CvBridgeError(error) from None

    def encoding_to_dtype_with_channels(self, encoding: str) -> tuple[str, int]:
        """('uint8', 3) for 'bgr8'. Raises CvBridgeError for one that isn't known."""
        return self.cvtype2_to_dtype_with_channels(self.encoding_to_cvtype2(encoding))

    def imgmsg_to_cv2(self, img_msg: sensor_msgs.msg.Image, desired_encoding: str = "passthrough") -> Any:
        """The image of a message as an array that is its own, in the machine's byte order, or in another encoding.

        Raises:
            CvBridgeError: it has an unknown encoding, or cannot become `desired_encoding`.
            TypeError: its data are too few.
        """
        import numpy as np

        name, channels = self.encoding_to_dtype_with_channels(img_msg.encoding)
        kind = np.dtype(name).newbyteorder(">" if img_msg.is_bigendian else "<")
        data = np.asarray(img_msg.data, dtype=kind) if isinstance(img_msg.data, list) else img_msg.data
        shape: tuple[int, ...] = (img_msg.height, img_msg.step // kind.itemsize // channels)
        image = np.ndarray(shape if channels == 1 else (*shape, channels), kind, data)
        image = np.ascontiguousarray(image[: img_msg.height, : img_msg.width])
        if img_msg.is_bigendian == (sys.byteorder == "little"):
            image = image.astype(kind.newbyteorder("="))
        return (
            image if desired_encoding == "passthrough" else self._converted(image, img_msg.encoding, desired_encoding)
        )

    def cv2_to_imgmsg(self, cvim: Any, encoding: str = "passthrough", header: Any = None) -> sensor_msgs.msg.Image:
        """A message of an array. Raises TypeError for what is none, CvBridgeError if the encoding isn't that of its numbers."""
        _check_array(cvim)
        message = sensor_msgs.msg.Image()
        message.height, message.width = cvim.shape[0], cvim.shape[1]
        if header is not None:
            message.header = header
        kind = self.dtype_with_channels_to_cvtype2(cvim.dtype, 1 if len(cvim.shape) < 3 else cvim.shape[2])
        message.encoding = kind if encoding == "passthrough" else encoding
        if encoding != "passthrough" and self.cvtype_to_name[self.encoding_to_cvtype2(encoding)] != kind:
            raise CvBridgeError(f"encoding specified as {encoding}, but image has incompatible type {kind}")
        message.is_bigendian = int(cvim.dtype.byteorder == ">")
        message.data.frombytes(cvim.tobytes())
        message.step = len(message.data) // message.height
        return message

    def compressed_imgmsg_to_cv2(
        self, cmprs_img_msg: sensor_msgs.msg.CompressedImage, desired_encoding: str = "passthrough"
    ) -> Any:
        """The array of a compressed image, None if it cannot be read. Raises CvBridgeError without OpenCV."""
        import numpy as np

        cv2 = self._opencv("Reading a CompressedImage")
        image = cv2.imdecode(np.frombuffer(cmprs_img_msg.data, np.uint8)[None, :], cv2.IMREAD_UNCHANGED)
        return image if desired_encoding == "passthrough" else self._converted(image, "bgr8", desired_encoding)

    def cv2_to_compressed_imgmsg(self, cvim: Any, dst_format: str = "jpg") -> sensor_msgs.msg.CompressedImage:
        """A compressed message of an array. Raises TypeError for what is none, CvBridgeError without OpenCV."""
        _check_array(cvim)
        cv2 = self._opencv("A CompressedImage")
        message = sensor_msgs.msg.CompressedImage()
        message.format = dst_format
        message.data.frombytes(cv2.imencode(f".{dst_format}", cvim)[1].tobytes())
        return message

    @staticmethod
    def _opencv(what: str) -> Any:
        try:
            return opencv(what)
        except RuntimeError as error:
            raise CvBridgeError(error) from None

    @staticmethod
    def _converted(image: Any, encoding: str, wanted: str) -> Any:
        try:
            return cvtColor2(image, encoding, wanted)
        except RuntimeError as error:
            raise CvBridgeError(error) from None


def _check_array(cvim: Any) -> None:
    import numpy as np

    if not isinstance(cvim, np.ndarray | np.generic):
        raise TypeError("Your input type is not a numpy array")
