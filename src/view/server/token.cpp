#include "view/server/token.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "base/error.h"

namespace fumon {

std::string random_token() {
    constexpr std::size_t bytes = 16;
    std::array<std::uint8_t, bytes> random{};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> source(std::fopen("/dev/urandom", "rb"),
                                                                 &std::fclose);
    if (!source || std::fread(random.data(), 1, bytes, source.get()) != bytes)
        throw Error("/dev/urandom gives no random numbers, without which no viewer is safe");
    std::string token;
    for (const std::uint8_t byte : random) token += fmt::format("{:02x}", byte);
    return token;
}

bool same_secret(std::string_view first, std::string_view second) {
    if (first.size() != second.size()) return false;
    unsigned differs = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        differs |= static_cast<unsigned>(static_cast<unsigned char>(first[i])) ^
                   static_cast<unsigned>(static_cast<unsigned char>(second[i]));
    }
    return differs == 0;
}

}  // namespace fumon
