"""The section of the deployment file that concerns AUTOSAR adaptive."""
