"""A function declared once: read, resolved against the catalogue, checked, and written as Function JSON."""
