#pragma once

/// Compiles a function twice, for every x86-64 machine and for those with AVX2; the better one is taken when
/// the program starts. Without contraction both give the same results to the bit.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define STILLMAP_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define STILLMAP_VECTOR_CLONES
#endif
