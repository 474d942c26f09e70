// The parser of Wavefront files, compiled like the fuzz targets themselves.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
