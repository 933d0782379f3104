/* The headers of samples/runtime as a game would build them. */
#define VOXPRITE_SVO_IMPLEMENTATION
#include "samples/runtime/voxprite_svo.h"

#define VOXPRITE_LATTICE_IMPLEMENTATION
#include "samples/runtime/voxprite_lattice.h"
