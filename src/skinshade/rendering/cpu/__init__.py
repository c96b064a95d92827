"""The CPU backend: the specification evaluated on a G-buffer."""
