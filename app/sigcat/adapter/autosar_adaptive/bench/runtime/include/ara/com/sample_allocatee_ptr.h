// A sample to be filled and sent (SWS_CM_00308).
#ifndef ARA_COM_SAMPLE_ALLOCATEE_PTR_H_
#define ARA_COM_SAMPLE_ALLOCATEE_PTR_H_

#include <memory>

namespace ara::com {

template <typename T>
using SampleAllocateePtr = std::unique_ptr<T>;

}  // namespace ara::com

#endif  // ARA_COM_SAMPLE_ALLOCATEE_PTR_H_
