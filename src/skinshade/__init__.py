"""skinshade: film-like skin for any renderer."""
