"""Numbers of a report as people read them."""


def duration(nanoseconds: float) -> str:
    """Three digits, and the unit that fits."""
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if abs(nanoseconds) >= size * 0.9995:
            return f"{_three(nanoseconds / size)} {unit}"
    return f"{_three(nanoseconds)} ns"


def _three(value: float) -> str:
    digits = f"{value:.3g}"
    return signed(f"{value:.0f}" if "e" in digits else digits)


def signed(text: str) -> str:
    """Return numbers in a text with real minus signs."""
    return text.replace("-", "\u2212")


def memory(size: float) -> str:
    """In kB or MB."""
    return f"{size / 1e6:.1f} MB" if size >= 1e6 else f"{size / 1e3:.0f} kB"


def seconds(time: float) -> str:
    """A time in ns, in seconds."""
    return f"{time / 1e9:.3f}".rstrip("0").rstrip(".") + " s"


def percent(share: float) -> str:
    """Return a share of 1 as per cent."""
    return f"{share * 100:.2g} %" if abs(share) < 0.1 else f"{share * 100:.0f} %"


def counted(number: int, name: str) -> str:
    """`1 platform`, `2 platforms`."""
    return f"{number:,} {name}{'' if number == 1 else 's'}"
