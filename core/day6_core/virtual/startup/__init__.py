"""The folder on PYTHONPATH of every process in virtual time."""
