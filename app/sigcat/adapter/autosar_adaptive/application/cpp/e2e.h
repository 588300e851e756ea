// States of end-to-end protection. Some platforms declare them in ara/com/e2e/types.h, others in ara/com/types.h.

#ifndef APPLICATION_E2E_H
#define APPLICATION_E2E_H

#if __has_include("ara/com/e2e/types.h")
#include "ara/com/e2e/types.h"
#else
#include "ara/com/types.h"
#endif

#endif  // APPLICATION_E2E_H
