"""skinshade in other people's renderers; each module needs the one it is named after."""
