"""The pictures of the documentation: real screens, played by docs/pictures/*.yaml. `python -m tests.pictures` makes them."""
