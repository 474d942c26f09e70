/* Part of selvage.h, which is what to include: its version, and how its functions are declared. */
#ifndef SELVAGE_API_H
#define SELVAGE_API_H

/* Of this header; selvage_version() tells the library's. Until 1.0 a program and the library that
 * it runs with must be of one minor version: structures may grow from one to the next. */
#define SELVAGE_VERSION_MAJOR 0
#define SELVAGE_VERSION_MINOR 1
#define SELVAGE_VERSION_PATCH 0

#if defined(SELVAGE_SHARED) && defined(_WIN32)
#define SELVAGE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define SELVAGE_API __attribute__((visibility("default")))
#else
#define SELVAGE_API
#endif

#endif
