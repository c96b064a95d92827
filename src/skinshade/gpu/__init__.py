"""The runtime on a GPU, for any renderer; needs wgpu."""
