"""Rule records (`interface_rules/*.yaml`) and a catalogue in, findings out.

The engine knows no files; linting puts files, suppressions, baselines and fixes around it.
"""
