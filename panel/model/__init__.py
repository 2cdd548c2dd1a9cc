"""The model of the Photo view: photographs, terrain, corrections and edits; no widgets."""
