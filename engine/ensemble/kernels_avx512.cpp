#define RIFT_INSTRUCTIONS avx512
#define RIFT_REGISTER_BYTES 64
#include "engine/ensemble/kernel_set.inc"
