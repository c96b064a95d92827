"""Base of all layers: errors, units, array checks, files, progress."""
