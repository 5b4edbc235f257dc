#include "files/hash.h"

#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <span>

#include "files/input_file.h"
#include "support/error.h"

namespace fumon {

namespace {

/// SHA-256 (FIPS 180-4) fed piece by piece.
class Hasher {
  public:
    Hasher() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
        check(context_ != nullptr);
        check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
    }

    void add(const void* bytes, std::size_t count) {
        check(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
    }

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

    void add_doubles(std::span<const double> values) {
        if constexpr (std::endian::native == std::endian::little) {
            add(values.data(), values.size_bytes());
        } else {
            for (const double value : values)
                add_little_endian(std::bit_cast<std::uint64_t>(value));
        }
    }

    Sha256 finish() {
        Sha256 hash{};
        unsigned length = 0;
        check(EVP_DigestFinal_ex(context_.get(), hash.data(), &length) == 1);
        check(length == hash.size());
        return hash;
    }

  private:
    static void check(bool worked) {
        if (!worked) throw Error("the SHA-256 of OpenSSL's libcrypto does not work here");
    }

    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

Sha256 pixel_hash(const Image& image) {
    Hasher hasher;
    hasher.add_little_endian(static_cast<std::uint32_t>(image.width));
    hasher.add_little_endian(static_cast<std::uint32_t>(image.height));
    hasher.add(image.rgb.data(), image.rgb.size());
    return hasher.finish();
}

Sha256 state_hash(const Model& model) {
    Hasher hasher;
    hasher.add(model.name().data(), model.name().size());
    hasher.add_little_endian(static_cast<std::uint64_t>(model.steps_done()));
    for (const StateField& field : model.state()) hasher.add_doubles(field.values);
    return hasher.finish();
}

Sha256 text_hash(std::string_view text) {
    Hasher hasher;
    hasher.add(text.data(), text.size());
    return hasher.finish();
}

Sha256 file_hash(const std::filesystem::path& file) {
    return text_hash(read_input_file(file));
}

std::string hex(const Sha256& hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    text.reserve(2 * hash.size());
    for (const std::uint8_t byte : hash) {
        text += digits[byte >> 4U];
        text += digits[byte & 0xFU];
    }
    return text;
}

}  // namespace fumon
