"""A robot's windows: the car from above, the sliders of its joints."""
