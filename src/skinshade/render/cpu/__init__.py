"""The CPU backend: the specification on a G-buffer."""
