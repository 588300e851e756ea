"""Applications for AUTOSAR adaptive, generated and run."""
