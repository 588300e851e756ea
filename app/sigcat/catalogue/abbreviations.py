"""Abbreviations of the field that trees write out: whoever searches for one means its words, too."""

from collections.abc import Mapping

ABBREVIATIONS: Mapping[str, tuple[str, ...]] = {
    "abs": ("anti lock", "antilock"),
    "acc": ("adaptive cruise",),
    "adas": ("advanced driver assist", "driver assist"),
    "aeb": ("emergency brak",),
    "bms": ("battery management", "traction battery"),
    "bsd": ("blind spot",),
    "dms": ("driver monitor", "driver distraction"),
    "dtc": ("diagnostic trouble",),
    "eba": ("emergency brake assist",),
    "ebd": ("brake force distribution",),
    "esc": ("stability control",),
    "esp": ("stability control", "stability program"),
    "ev": ("electric vehicle", "battery electric"),
    "gps": ("gnss", "current location"),
    "hv": ("high voltage",),
    "hvac": ("air conditioning", "climate"),
    "ice": ("combustion engine",),
    "lka": ("lane keep", "lane departure"),
    "odo": ("odometer",),
    "rpm": ("revolutions minute", "rotational speed", "engine speed"),
    "soc": ("state charge",),
    "soh": ("state health",),
    "swa": ("steering angle", "steering wheel angle"),
    "tcs": ("traction control",),
    "tpms": ("tire pressure",),
    "vin": ("vehicle identification number",),
}
"""Texts whose words, each a beginning, stand for the abbreviation."""
