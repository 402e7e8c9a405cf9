#define RIFT_INSTRUCTIONS avx2
#define RIFT_REGISTER_BYTES 32
#include "engine/ensemble/kernel_set.inc"
