"""Stands for a player: writes down what it is given, and says what functions would send."""

import os
import sys
import time
from pathlib import Path

folder = Path(sys.argv[1]).parent
header = sys.stdin.readline()
columns = header.strip().split("\t")[1:]
words = os.environ.get("PLAYER", "")
if "late" in words:
    (folder / "player_waits").touch()
    while not (folder / "player_goes_on").exists():
        time.sleep(0.01)
print("unknown Vehicle.CurbWeight", flush=True)
if "dies" in words:
    sys.exit("player: Not every component runs.")
print("ready", flush=True)
count = 0
with (folder / "given.csv").open("w") as given:
    given.write(header)
    for line in sys.stdin:
        given.write(line)
        time_ns, *cells = line.rstrip("\n").split("\t")
        for name, cell in zip(columns, cells, strict=True):
            if cell and name != "Vehicle.CurbWeight":
                count += 1
                if name == "Vehicle.Speed":
                    print(f'{time_ns},Vehicle.Wish,"{float(cell) * 2}"', flush=True)
        if "breaks" in words:
            sys.exit("player: It breaks.")
print(f"unheard {count - 1 if 'alone' in words else 0}", flush=True)
print(f"sent {count - ('loses' in words)}", flush=True)
