/* Standard types of a desk: the vendor's stand here on an ECU. */
#ifndef STD_TYPES_H
#define STD_TYPES_H

#include "Platform_Types.h"

typedef uint8 Std_ReturnType;

#ifndef E_OK
#define E_OK ((Std_ReturnType)0U)
#endif
#ifndef E_NOT_OK
#define E_NOT_OK ((Std_ReturnType)1U)
#endif

#endif /* STD_TYPES_H */
