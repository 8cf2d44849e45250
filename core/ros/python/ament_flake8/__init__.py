"""The style check that the tests of a new package call: flake8 where it is installed, else the rules a beginner breaks most."""
