"""The pictures of the documentation: real screens, played by the scripts in docs/pictures. `python -m tests.pictures` makes them."""
