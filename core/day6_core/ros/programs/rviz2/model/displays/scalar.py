"""Temperature, RelativeHumidity, Illuminance and FluidPressure: one coloured point where the sensor is."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import INTENSITY, PointsDisplay


class _ScalarDisplay(PointsDisplay):
    """A number as the channel of a point in the sensor's origin (…/pointcloud/point_cloud_scalar_display.hpp)."""

    field = ""
    """Of the message; it is the channel, too."""
    least_value = 0.0
    most_value = 0.0
    inverted = False

    def build(self) -> None:
        super().build()
        self.channel.value, self.auto.value, self.invert.value = self.field, False, self.inverted
        self.least.value, self.most.value = self.least_value, self.most_value
        self.how.value = INTENSITY
        self._hide()

    def _hide(self) -> None:
        super()._hide()
        for each in (self.position, self.how, self.channel, self.auto):
            each.hidden = True
        self.invert.hidden = self.invert.hidden or self.inverted

    def show(self, message: Any) -> None:
        import numpy as np

        pose = self.place(message.header)
        if pose is not None:
            self.take(np.zeros((1, 3)), pose, {self.field: np.array([getattr(message, self.field)])}, None, ())


class TemperatureDisplay(_ScalarDisplay):
    """Degrees Celsius, from 0 (blue) to 100 (red)."""

    type, message_type = "Temperature", "sensor_msgs/msg/Temperature"
    field, most_value, inverted = "temperature", 100.0, True


class RelativeHumidityDisplay(_ScalarDisplay):
    """A share from 0 to 1."""

    type, message_type = "RelativeHumidity", "sensor_msgs/msg/RelativeHumidity"
    field, most_value = "relative_humidity", 1.0


class IlluminanceDisplay(_ScalarDisplay):
    """Lux, from 0 to 1000."""

    type, message_type = "Illuminance", "sensor_msgs/msg/Illuminance"
    field, most_value = "illuminance", 1000.0


class FluidPressureDisplay(_ScalarDisplay):
    """Pascal, around that of the air."""

    type, message_type = "FluidPressure", "sensor_msgs/msg/FluidPressure"
    field, least_value, most_value = "fluid_pressure", 98000.0, 105000.0
