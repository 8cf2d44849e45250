"""The car of day 6: `wheel_spinner` turns its wheels, `car_view` shows it from above."""
