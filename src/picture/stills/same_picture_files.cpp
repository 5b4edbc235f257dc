#include "picture/stills/same_picture_files.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "picture/stills/picture_file.h"

namespace fumon {

namespace {

std::uint32_t big_endian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
           std::uint32_t{bytes[2]} << 8U | bytes[3];
}

/// The chunks of a PNG file as its bytes come: whether each has the checksum that it ends with, and
/// the last is IEND, with nothing after it (PNG standard, clause 5.3).
class PngChunks {
  public:
    void add(std::span<const std::uint8_t> bytes) {
        while (!bytes.empty() && good_) {
            const std::size_t taken = in_data_ > 0 ? take_data(bytes) : take_field(bytes);
            bytes = bytes.subspan(taken);
        }
    }
    [[nodiscard]] bool whole() const { return good_ && ended_; }

  private:
    /// Fields of a known length: the signature, then in turn length with type, and checksum.
    std::size_t take_field(std::span<const std::uint8_t> bytes) {
        if (ended_) good_ = false;  // bytes after the end
        const std::size_t taken = std::min(bytes.size(), wanted_ - held_);
        std::memcpy(field_.data() + held_, bytes.data(), taken);
        held_ += taken;
        if (held_ < wanted_) return taken;
        held_ = 0;
        if (part_ == Part::signature) {
            part_ = Part::head;
        } else if (part_ == Part::head) {
            begin_data();
        } else {
            good_ = big_endian(field_.data()) == checksum_;
            ended_ = last_;
            part_ = Part::head;
            wanted_ = 8;
        }
        return taken;
    }

    void begin_data() {
        in_data_ = big_endian(field_.data());
        last_ = std::memcmp(field_.data() + 4, "IEND", 4) == 0;
        checksum_ = libdeflate_crc32(0, field_.data() + 4, 4);
        part_ = Part::checksum;
        wanted_ = 4;
    }

    std::size_t take_data(std::span<const std::uint8_t> bytes) {
        const std::size_t taken = std::min<std::size_t>(bytes.size(), in_data_);
        checksum_ = libdeflate_crc32(checksum_, bytes.data(), taken);
        in_data_ -= static_cast<std::uint32_t>(taken);
        return taken;
    }

    enum class Part { signature, head, checksum };
    Part part_ = Part::signature;
    std::array<std::uint8_t, 8> field_{};
    std::size_t held_ = 0;
    std::size_t wanted_ = 8;
    std::uint32_t in_data_ = 0;  ///< bytes of the chunk that are still to come
    std::uint32_t checksum_ = 0;
    bool last_ = false;
    bool ended_ = false;
    bool good_ = true;
};

/// Whether a file that begins and ends so, and whose PNG chunks are these, is whole.
bool is_whole(std::string_view head, std::string_view tail, std::uint64_t length,
              const PngChunks& chunks) {
    if (head.starts_with("\x89PNG")) return chunks.whole();
    if (head.starts_with("\xFF\xD8")) return tail == "\xFF\xD9";
    if (!head.starts_with("RIFF")) return false;
    std::uint64_t riff = 0;  // bytes after the eighth, least significant first
    for (std::size_t i = 8; i-- > 4;) riff = riff << 8U | static_cast<std::uint8_t>(head[i]);
    return length == 8 + riff + riff % 2;
}

}  // namespace

bool same_picture_files(const std::filesystem::path& first, const std::filesystem::path& second) {
    constexpr std::size_t least = 12;  // bytes of a picture
    std::error_code fault;
    for (const auto& file : {first, second}) {
        if (!std::filesystem::is_regular_file(file, fault)) return false;
    }
    const std::uintmax_t length = std::filesystem::file_size(first, fault);
    if (fault || length < least || std::filesystem::file_size(second, fault) != length || fault)
        return false;
    std::filebuf a;
    std::filebuf b;
    for (std::filebuf* file : {&a, &b}) file->pubsetbuf(nullptr, 0);  // blocks are large enough
    const auto how = std::ios::in | std::ios::binary;
    if (a.open(first, how) == nullptr || b.open(second, how) == nullptr) return false;
    constexpr std::size_t block = std::size_t{1} << 18U;
    std::vector<char> left(block);
    std::vector<char> right(block);
    std::string head;
    std::string tail;
    PngChunks chunks;
    for (std::uintmax_t at = 0; at < length;) {
        const auto count =
            static_cast<std::streamsize>(std::min<std::uintmax_t>(block, length - at));
        if (a.sgetn(left.data(), count) != count || b.sgetn(right.data(), count) != count)
            return false;
        const auto bytes = static_cast<std::size_t>(count);
        if (std::memcmp(left.data(), right.data(), bytes) != 0) return false;
        if (at == 0) {  // of 12 bytes at least
            head.assign(left.data(), std::min(bytes, least));
            if (!is_picture(head)) return false;
        }
        if (head.starts_with("\x89PNG"))
            chunks.add({reinterpret_cast<const std::uint8_t*>(left.data()), bytes});
        const std::size_t last = std::min<std::size_t>(bytes, 2);
        tail.append(left.data() + (bytes - last), last);
        tail.erase(0, tail.size() - 2);
        at += bytes;
    }
    return is_whole(head, tail, length, chunks);
}

}  // namespace fumon
