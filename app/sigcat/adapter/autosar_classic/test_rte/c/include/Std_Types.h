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

/* Result of a transformer, such as that of end-to-end protection. */
typedef uint8 Std_TransformerErrorCode;
typedef uint8 Std_TransformerClass;

#define STD_TRANSFORMER_UNSPECIFIED ((Std_TransformerClass)0x00U)
#define STD_TRANSFORMER_SERIALIZER ((Std_TransformerClass)0x01U)
#define STD_TRANSFORMER_SAFETY ((Std_TransformerClass)0x02U)
#define STD_TRANSFORMER_SECURITY ((Std_TransformerClass)0x03U)
#define STD_TRANSFORMER_CUSTOM ((Std_TransformerClass)0xFFU)

typedef struct {
    Std_TransformerErrorCode errorCode;
    Std_TransformerClass transformerClass;
} Std_TransformerError;

#endif /* STD_TYPES_H */
