"""Shader sources: ``skin/`` is the library, ``generated/`` what `skinshade.codegen` makes of it."""
