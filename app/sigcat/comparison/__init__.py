"""Input: functions, a deployment, a trace, and the platforms that are installed.
Output: sent values, durations of calls and resources of each platform, side by side.
"""
