// Runs a fuzz target without libFuzzer, as part of the tests under the sanitizers: every input of
// its corpus, then inputs mutated from them, in the same order each time, for two seconds at most.
// FUZZ_SECONDS goes on for longer, in another order for each FUZZ_SEED.
//
//   fuzz_TARGET FOLDER…
//   FUZZ_SECONDS=600 FUZZ_SEED=7 fuzz_TARGET FOLDER…

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
__attribute__((weak)) int LLVMFuzzerInitialize(int* count, char*** arguments);
__attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                          std::size_t most, unsigned seed);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
}

namespace {

using Bytes = std::vector<std::uint8_t>;

std::mt19937 generator(1);

/// A number below `count`, the same on every system.
std::size_t below(std::size_t count) {
    return generator() % std::max<std::size_t>(count, 1);
}

std::vector<Bytes> inputs_in(int count, char** folders) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < count; ++i)
        for (const auto& entry : std::filesystem::directory_iterator(folders[i]))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Bytes> inputs;
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(stream),
                            std::istreambuf_iterator<char>());
    }
    return inputs;
}

/// A number that the environment may name.
int number_of(const char* variable, int usual) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? usual : std::atoi(text);
}

/// Some bytes that stand where readers expect others.
std::string_view surprise() {
    using namespace std::string_view_literals;
    constexpr std::array texts{"-1"sv,
                               "0"sv,
                               "1e999"sv,
                               "nan"sv,
                               "18446744073709551616"sv,
                               "\""sv,
                               "1.7976931348623157e308"sv,
                               "-1.7976931348623157e308"sv,
                               "4.9e-324"sv,
                               "3.4028235e38"sv,
                               "-3.4028236e38"sv,
                               "2147483648"sv,
                               "-2147483649"sv,
                               "1000000.0001"sv,
                               "-0.0"sv,
                               "1e15"sv,
                               "\n"sv,
                               ","sv,
                               "\0"sv,
                               "]"sv,
                               "\xff\xff\xff\xff"sv,
                               "{"sv,
                               "\xc3"sv,
                               "="sv,
                               "[["sv,
                               "."sv,
                               "\x7f\xff\xff\xff"sv,
                               " "sv};
    return texts[below(texts.size())];
}

/// Puts `text` over what stands at `at`, or before it.
std::size_t put(std::uint8_t* data, std::size_t size, std::size_t most, std::size_t at,
                std::string_view text, bool before) {
    if (before && size + text.size() <= most) {
        std::memmove(data + at + text.size(), data + at, size - at);
        size += text.size();
    }
    const std::size_t fits = std::min(text.size(), size - at);
    if (fits > 0) std::memcpy(data + at, text.data(), fits);
    return size;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most) {
    if (size == 0) {
        if (most == 0) return 0;
        data[0] = static_cast<std::uint8_t>(below(256));
        return 1;
    }
    const std::size_t at = below(size);
    const std::size_t length = std::min(size - at, 1 + below(16));
    switch (below(5)) {
        case 0:
            data[at] = static_cast<std::uint8_t>(data[at] ^ (1U << below(8)));
            return size;
        case 1:
            data[at] = static_cast<std::uint8_t>(below(256));
            return size;
        case 2:  // what stands there goes
            std::memmove(data + at, data + at + length, size - at - length);
            return size - length;
        case 3: {  // what stands there comes once more
            const std::string again(reinterpret_cast<const char*>(data) + at, length);
            return put(data, size, most, below(size), again, true);
        }
        default:
            return put(data, size, most, at, surprise(), below(2) == 0);
    }
}

int main(int count, char** arguments) {
    if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&count, &arguments);
    const std::vector<Bytes> inputs = inputs_in(count, arguments);
    if (inputs.empty()) {
        std::fprintf(stderr, "%s: no inputs\n", arguments[0]);
        return 1;
    }
    for (const Bytes& input : inputs) LLVMFuzzerTestOneInput(input.data(), input.size());
    constexpr std::size_t room = 4096;  // that an input may grow by
    const int seconds = number_of("FUZZ_SECONDS", 2);
    const int most_inputs = std::getenv("FUZZ_SECONDS") == nullptr ? 5000 : INT_MAX;
    generator.seed(static_cast<unsigned>(number_of("FUZZ_SEED", 1)));
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    int mutated = 0;
    for (; mutated < most_inputs && std::chrono::steady_clock::now() < end; ++mutated) {
        Bytes input = inputs[below(inputs.size())];
        std::size_t size = input.size();
        input.resize(size + room);
        for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
            size = LLVMFuzzerCustomMutator != nullptr
                       ? LLVMFuzzerCustomMutator(input.data(), size, input.size(),
                                                 static_cast<unsigned>(generator()))
                       : LLVMFuzzerMutate(input.data(), size, input.size());
        }
        const Bytes exact(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(size));
        LLVMFuzzerTestOneInput(exact.data(), exact.size());
    }
    std::printf("%zu inputs, %d mutated\n", inputs.size(), mutated);
    return 0;
}
