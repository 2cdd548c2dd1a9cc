"""The Processing provider of Skyline Viewshed."""
