"""The Photo view: a panel beside the map to look at oriented photographs, correct them, measure and draw in them."""
