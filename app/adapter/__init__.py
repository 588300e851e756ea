"""Files for a platform, written from an integration model and nothing else."""
