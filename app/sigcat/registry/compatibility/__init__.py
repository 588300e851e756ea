"""Whether a version fits what is deployed, and who breaks."""
