/* Part of selvage.h, which is what to include: how its functions are declared. */
#ifndef SELVAGE_API_H
#define SELVAGE_API_H

#if defined(SELVAGE_SHARED) && defined(_WIN32)
#define SELVAGE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define SELVAGE_API __attribute__((visibility("default")))
#else
#define SELVAGE_API
#endif

#endif
