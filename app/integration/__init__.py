"""From functions to what a platform needs: one pure `derive` for each platform, over one datatype table."""
