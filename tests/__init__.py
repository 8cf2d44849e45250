"""The tests. README.md says which there are; what they share has names of this package (`tests.support.waiting`)."""
