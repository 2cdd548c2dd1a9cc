"""What photographs of one walk know about one another."""
