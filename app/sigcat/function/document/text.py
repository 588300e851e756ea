"""Free text of documents: descriptions, names of people and organizations, conditions that people read."""

Text = str
"""Text with any characters, which reaches generated files through filters alone."""
