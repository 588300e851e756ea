// Logger and CreateLogger. Some platforms declare both in ara/log/logger.h, others the function in ara/log/logging.h.

#ifndef APPLICATION_LOG_H
#define APPLICATION_LOG_H

#include "ara/log/logger.h"

#if __has_include("ara/log/logging.h")
#include "ara/log/logging.h"
#endif

#endif  // APPLICATION_LOG_H
