"""The terrain that is visible from an eye, in full or inside the frame of a photograph."""
