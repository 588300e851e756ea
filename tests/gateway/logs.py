"""A database, mappings of its signals, and messages for logs."""

import struct

import can

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Motion: 8 Gateway
 SG_ Speed : 0|16@1+ (0.01,0) [0|250] "km/h" Gateway
 SG_ Gear : 16|3@1+ (1,0) [0|0] "" Gateway
 SG_ Acceleration : 32|32@1- (1,0) [0|0] "m/s^2" Gateway
BO_ 2147484160 Display: 4 Gateway
 SG_ Page M : 0|8@1+ (1,0) [0|0] "" Gateway
 SG_ Mass m0 : 8|16@1+ (1,0) [0|0] "kg" Gateway
 SG_ Other m1 : 8|16@1+ (1,0) [0|0] "" Gateway
SIG_VALTYPE_ 256 Acceleration : 1;
VAL_ 256 Gear 0 "PARK" 1 "DRIVE" 7 "SNA" ;
"""


MAPPINGS = """\
Vehicle.Speed: {type: sensor, datatype: float, network_serialization: {signal: Speed, on_change: false}}
Vehicle.Acceleration.Longitudinal: {type: sensor, datatype: float, dbc2vss: {signal: Acceleration, interval_ms: 0}}
Vehicle.Powertrain.Transmission.CurrentGear:
  type: sensor
  datatype: int8
  dbc2vss: {signal: Gear, on_change: true, transform: {mapping: [{from: PARK, to: 0}, {from: DRIVE, to: 1}]}}
Vehicle.CurbWeight: {type: attribute, datatype: uint16, network_serialization: {signal: Mass}}
"""


PATHS = (
    "Vehicle.Acceleration.Longitudinal",
    "Vehicle.CurbWeight",
    "Vehicle.Powertrain.Transmission.CurrentGear",
    "Vehicle.Speed",
)
"""In this order tests see the columns."""


def motion(speed, gear=1, acceleration=0.5):
    return struct.pack("<HBBf", speed, gear, 0, acceleration)


def message(time, data, identifier=256, **more):
    return can.Message(timestamp=time, arbitration_id=identifier, is_extended_id=identifier > 0x7FF, data=data, **more)
