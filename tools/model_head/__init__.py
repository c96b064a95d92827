"""Modeller of the built-in head: signed distance fields, meshing and unwrapping."""
