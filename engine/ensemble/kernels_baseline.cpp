#define RIFT_INSTRUCTIONS baseline
#define RIFT_REGISTER_BYTES 16
#include "engine/ensemble/kernel_set.inc"
