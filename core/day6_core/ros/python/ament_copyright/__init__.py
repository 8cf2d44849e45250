"""The check for copyright notices that the tests of a new package run."""
