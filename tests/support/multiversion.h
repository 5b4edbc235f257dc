#pragma once

/// Marks a loop to be compiled for several x86-64 levels, one of which is chosen at run time.
/// All give the same bits, since contraction is off. Sanitizers and other processors take the plain
/// function.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(FUMON_SANITIZED)
#define FUMON_MULTIVERSION __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define FUMON_MULTIVERSION
#endif
