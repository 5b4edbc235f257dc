#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

struct evp_md_ctx_st;

namespace fumon {

using Sha256 = std::array<std::uint8_t, 32>;

/// SHA-256 (FIPS 180-4) fed piece by piece.
class Sha256Stream {
  public:
    /// Throws Error where OpenSSL's libcrypto does not work; so do the others.
    Sha256Stream();

    void add(const void* bytes, std::size_t count);

    /// The lowest `sizeof(Unsigned)` bytes, least significant first.
    template <class Unsigned>
    void add_little_endian(Unsigned value) {
        std::array<std::uint8_t, sizeof(Unsigned)> bytes{};
        for (std::uint8_t& byte : bytes) {
            byte = static_cast<std::uint8_t>(value & 0xFFU);
            value = static_cast<Unsigned>(value >> 8U);
        }
        add(bytes.data(), bytes.size());
    }

    /// The hash of all that was added so far.
    [[nodiscard]] Sha256 so_far() const;
    /// The same; nothing can be added any more.
    Sha256 finish();

  private:
    struct Free {
        void operator()(evp_md_ctx_st* context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

}  // namespace fumon
