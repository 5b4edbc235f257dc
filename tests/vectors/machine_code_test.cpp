#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace fumon::test {
namespace {

/// Of a loop, how many of its instructions multiply, add, subtract and divide its numbers.
struct Arithmetic {
    int on_vectors = 0;  ///< on whole registers of the target
    int on_less = 0;     ///< on a single number or narrower ones, as for the last cells of a row
    int fused = 0;
};

struct Target {
    const char* scope;      ///< of its functions, as Highway calls it
    const char* registers;  ///< as objdump calls them
};

constexpr std::array targets{Target{"N_SSE4::", "%xmm"}, Target{"N_AVX2::", "%ymm"},
                             Target{"N_AVX3::", "%zmm"}};
constexpr std::array loops{"tanh_of_differences(",
                           "hop_linearly(",
                           "hop_linearly_truncated(",
                           "exponential_lengths(",
                           "creep_inside(",
                           "stress_row(",
                           "downhill_row(",
                           "direct_row(",
                           "diverge_row(",
                           "incise_downhill_row(",
                           "settle_downhill_row(",
                           "hold_between_neighbours(",
                           "green_ampt_row(",
                           "limited_half_slopes(",
                           "shore_half_slopes(",
                           "means_to_faces(",
                           "largest_invariants(",
                           "speed_bounds(",
                           "face_fluxes(",
                           "update(",
                           "advect_row(",
                           "advect_velocities(",
                           "accelerate_row(",
                           "accelerate_row_steep(",
                           "accelerate_row_as_published(",
                           "turn_gradient_row(",
                           "turn_velocity_gradients(",
                           "thin_row(",
                           "through_faces(",
                           "settle_row(",
                           "concentrate_row(",
                           "advect_load_row(",
                           "pick_up<",
                           "hold_above_row(",
                           "cross_rows(",
                           "predict_upwind(",
                           "predict_second_order(",
                           "diverge(",
                           "correct(",
                           "multiply(",
                           "load_cells(",
                           "fastest(",
                           "advance_stokes(",
                           "advance_schiller_naumann("};
/// Whose vectors hold four numbers at most.
constexpr std::array loops_of_four{"butterflies_of_four(", "butterflies_of_five(", "butterflies(",
                                   "rotate_points(",       "split_spectra(",       "merge_spectra(",
                                   "eliminate(",           "substitute_back("};

#ifdef FUMON_HAS_PICTURES
constexpr std::array loops_of_pictures{"warp_along_ray(", "project_vertices(", "evaluate("};
constexpr std::array loops_on_floats{"sweep_shadow(", "add_sky(",      "multiply_by_normal(",
                                     "pack_texels(",  "take_roots(",   "mix_means_along(",
                                     "shade_row(",    "classify_row(", "resolve_positions("};
constexpr std::array loops_on_whole_numbers{"add_squares(", "halve("};
#else
constexpr std::array<const char*, 0> loops_of_pictures{};
constexpr std::array<const char*, 0> loops_on_floats{};
constexpr std::array<const char*, 0> loops_on_whole_numbers{};
#endif

/// The instructions that work on a loop's numbers.
struct Instructions {
    std::vector<std::string_view> on_several;
    std::vector<std::string_view> on_one;
};

Instructions instructions_of(std::string_view loop) {
    if (std::ranges::find(loops_on_floats, loop) != loops_on_floats.end())
        return {{"mulps ", "addps ", "subps ", "divps "}, {"mulss ", "addss ", "subss ", "divss "}};
    if (std::ranges::find(loops_on_whole_numbers, loop) != loops_on_whole_numbers.end())
        return {{"pmulld ", "paddd "}, {}};
    return {{"mulpd ", "addpd ", "subpd ", "divpd "}, {"mulsd ", "addsd ", "subsd ", "divsd "}};
}

std::string_view registers_of(const Target& target, std::string_view loop) {
    const bool four = std::ranges::find(loops_of_four, loop) != loops_of_four.end();
    return four && std::string_view(target.registers) == "%zmm" ? "%ymm" : target.registers;
}

std::vector<std::string_view> all_loops() {
    std::vector<std::string_view> all(loops.begin(), loops.end());
    all.insert(all.end(), loops_of_four.begin(), loops_of_four.end());
    all.insert(all.end(), loops_of_pictures.begin(), loops_of_pictures.end());
    all.insert(all.end(), loops_on_floats.begin(), loops_on_floats.end());
    all.insert(all.end(), loops_on_whole_numbers.begin(), loops_on_whole_numbers.end());
    return all;
}

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The instructions of the functions of some libraries, by objdump.
std::string machine_code() {
    const std::string command =
        "objdump -dC --no-show-raw-insn " FUMON_LIBRARIES_OF_LOOPS " 2> /dev/null";
    const auto close = [](std::FILE* pipe) { pclose(pipe); };
    const std::unique_ptr<std::FILE, decltype(close)> pipe(popen(command.c_str(), "r"), close);
    std::string text;
    std::array<char, 1 << 16> some{};
    while (const std::size_t count = std::fread(some.data(), 1, some.size(), pipe.get()))
        text.append(some.data(), count);
    return text;
}

void count(std::string_view instruction, const Instructions& known, std::string_view registers,
           Arithmetic& found) {
    const auto is_one_of = [&](const std::vector<std::string_view>& names) {
        return std::ranges::any_of(names, [&](auto name) { return has(instruction, name); });
    };
    if (is_one_of({"vfmadd", "vfmsub", "vfnmadd", "vfnmsub"})) ++found.fused;
    if (is_one_of(known.on_one)) ++found.on_less;
    if (is_one_of(known.on_several))
        ++(has(instruction, registers) ? found.on_vectors : found.on_less);
}

TEST(MachineCode, HotLoopsWorkOnWholeVectorsAndFuseNothing) {
#if !defined(__x86_64__) || defined(FUMON_SANITIZED)
    GTEST_SKIP() << "the instructions are those of x86-64";
#endif
    const std::string text = machine_code();
    if (text.empty()) GTEST_SKIP() << "there is no objdump";
    std::map<std::string, Arithmetic> found;  // by "N_AVX2::linear("
    Arithmetic* now = nullptr;
    std::string_view registers;
    Instructions known;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.ends_with(">:")) {
            now = nullptr;
            for (const Target& target : targets) {
                for (const std::string_view loop : all_loops()) {
                    const std::string name = target.scope + std::string(loop);
                    if (!has(line, name)) continue;
                    now = &found[name];
                    registers = registers_of(target, loop);
                    known = instructions_of(loop);
                }
            }
        } else if (now != nullptr) {
            count(line, known, registers, *now);
        }
    }
    for (const Target& target : targets) {
        for (const std::string_view loop : all_loops()) {
            const std::string name = target.scope + std::string(loop);
            const Arithmetic& there = found[name];
            SCOPED_TRACE(name);
            EXPECT_GT(there.on_vectors, 0);
            // The largest of a vector's numbers is found by halves, by GCC 14 for each way out.
            const int halves = loop == "fastest(" ? 6 : 2;
            EXPECT_LE(there.on_less, halves * there.on_vectors);
            EXPECT_EQ(there.fused, 0);
        }
    }
}

}  // namespace
}  // namespace fumon::test
