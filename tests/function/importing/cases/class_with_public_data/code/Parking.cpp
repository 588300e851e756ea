#include "Parking.h"

namespace assist {
Parking::P_Parking_T Parking::Parking_P{
  0.3
};

void Parking::step()
{
  Parking_Y.Warn = Parking_U.VehSpd < 10.0 && Parking_U.ObjDst[0] < Parking_P.Limit;
}

void Parking::initialize()
{
}

void Parking::terminate()
{
}

Parking::Parking() : Parking_U(), Parking_Y(), Parking_DW() {}
Parking::~Parking() = default;
}
