"""Datagrams by hand: sends those that the lines of its input say, and tells those that come.

Run in the network of a test: python datagrams.py ADDRESS PORT; lines: ADDRESS PORT HEX.
A line `fuzz SEED COUNT ADDRESS PORT HEX...` sends so many that are made of the given ones by changing, cutting and joining.
"""

import os
import random
import socket
import sys
import threading
import time

LONGEST = 4096


def tell(line: str) -> None:
    """Print a line in one write: `print` would write its end separately, and a line of another thread could be between."""
    os.write(sys.stdout.fileno(), f"{line}\n".encode())


def listen(own: socket.socket) -> None:
    while True:
        data, (address, port) = own.recvfrom(65536)
        tell(f"{address} {port} {data.hex()}")


def spoilt(samples: list[bytes], chance: random.Random) -> bytes:
    """Datagrams that a broken or hostile sender might make from valid ones."""
    data = bytearray(chance.choice(samples))
    for _ in range(chance.randrange(1, 5)):
        at = chance.randrange(len(data)) if data else 0
        way = chance.randrange(6)
        if way == 0 and data:
            data[at] = chance.randrange(256)
        elif way == 1 and data:
            data[at] ^= 1 << chance.randrange(8)
        elif way == 2:
            del data[at:]
        elif way == 3:
            data[at:at] = chance.randbytes(chance.randrange(20))
        elif way == 4:
            data += chance.choice(samples)
        else:
            data[at : at + 4] = chance.choice([b"\xff" * 4, b"\x00" * 4, b"\x7f\xff\xff\xff", b"\x00\x00\x00\x08"])
    return bytes(data[:LONGEST])


def fuzz(own: socket.socket, seed: str, count: str, address: str, port: str, *samples: str) -> None:
    chance = random.Random(int(seed))
    kinds = [bytes.fromhex(sample) for sample in samples]
    for number in range(int(count)):
        own.sendto(spoilt(kinds, chance), (address, int(port)))
        if number % 50 == 49:
            time.sleep(0.004)  # the receiver's buffer holds so many
    tell(f"sent {count}")


def main() -> None:
    own = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    own.bind((sys.argv[1], int(sys.argv[2])))
    threading.Thread(target=listen, args=[own], daemon=True).start()
    tell("ready")
    for line in sys.stdin:
        words = line.split()
        if words[0] == "quit":
            break
        if words[0] == "fuzz":
            fuzz(own, *words[1:])
        else:
            own.sendto(bytes.fromhex(words[2]), (words[0], int(words[1])))
    os._exit(0)


main()
