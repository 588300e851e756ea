// What end-to-end protection says of a sample (SWS_CM_90421).
#ifndef ARA_COM_E2E_TYPES_H_
#define ARA_COM_E2E_TYPES_H_

#include <cstdint>

namespace ara::com::e2e {

enum class ProfileCheckStatus : std::uint8_t { kOk, kRepeated, kWrongSequence, kError, kNotAvailable, kNoNewData, kCheckDisabled };

}  // namespace ara::com::e2e

#endif  // ARA_COM_E2E_TYPES_H_
