"""Services of the set: which there are, their elements, and who uses them."""
