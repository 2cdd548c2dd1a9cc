"""The widgets of the Photo view; no geometry of the terrain."""
