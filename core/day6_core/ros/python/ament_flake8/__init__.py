"""The style check that the tests of a new package run: flake8 if it is installed, else the most frequent rules."""
