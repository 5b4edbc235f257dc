#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Vector instructions. The hot loops are written for vectors of any width (Highway) and compiled
/// for several instruction sets, targets, of which the best that the processor has is taken. Every
/// target gives the same bits.
namespace fumon::vectors {

/// The targets that this processor has, the best one first: of "avx512", "avx2", "sse4" and "plain"
/// (what every processor has) on x86-64, "neon" on arm64.
std::vector<std::string> targets();

/// The target in use.
std::string target();

/// Takes this target from now on; no loop may be at work. Throws InputError for one that the
/// processor does not have, naming those that it has.
void use_target(std::string_view name);

/// Takes the target that the environment variable FUMON_VECTOR_TARGET names, where it is set.
/// Throws as use_target().
void use_target_of_environment();

}  // namespace fumon::vectors
