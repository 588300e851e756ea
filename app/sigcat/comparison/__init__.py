"""What comes in: functions, a deployment, a trace, and the platforms that are installed.
What goes out: what each platform sent, how long its calls took and what it cost, side by side.
"""
