"""Positions of photographs from a track and the times of both."""
