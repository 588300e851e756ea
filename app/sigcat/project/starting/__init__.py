"""What a project starts with: a folder in; the texts of its files out."""
