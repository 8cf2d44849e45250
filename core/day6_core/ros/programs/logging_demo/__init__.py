"""The executable and the components of logging_demo."""
