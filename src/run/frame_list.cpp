#include "run/frame_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <string_view>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::size_t number_bytes = sizeof(std::uint64_t);
constexpr std::size_t hash_bytes = std::tuple_size_v<Sha256>;
constexpr std::size_t record_bytes = 2 * number_bytes + 2 * hash_bytes;
using FrameBytes = std::array<char, record_bytes>;

void append_number(std::uint64_t number, char* bytes) {
    for (std::size_t i = 0; i < number_bytes; ++i, number >>= 8U)
        bytes[i] = static_cast<char>(number & 0xFFU);
}

std::uint64_t number_at(const char* bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = number_bytes; i-- > 0;)
        number = number << 8U | static_cast<std::uint8_t>(bytes[i]);
    return number;
}

Sha256 hash_at(const char* bytes) {
    Sha256 hash{};
    std::transform(bytes, bytes + hash_bytes, hash.begin(),
                   [](char byte) { return static_cast<std::uint8_t>(byte); });
    return hash;
}

FrameBytes bytes_of_frame(const FrameRecord& frame) {
    FrameBytes bytes{};
    append_number(static_cast<std::uint64_t>(frame.step), bytes.data());
    append_number(std::bit_cast<std::uint64_t>(frame.time), bytes.data() + number_bytes);
    char* pixels = bytes.data() + 2 * number_bytes;
    std::copy(frame.pixels.begin(), frame.pixels.end(), pixels);
    std::copy(frame.file.begin(), frame.file.end(), pixels + hash_bytes);
    return bytes;
}

FrameRecord frame_of_bytes(const FrameBytes& bytes) {
    FrameRecord frame;
    frame.step = static_cast<std::int64_t>(number_at(bytes.data()));
    frame.time = std::bit_cast<double>(number_at(bytes.data() + number_bytes));
    const char* pixels = bytes.data() + 2 * number_bytes;
    frame.pixels = hash_at(pixels);
    frame.file = hash_at(pixels + hash_bytes);
    return frame;
}

FileBeginning beginning_of(const FrameCount& counted) {
    return {counted.frames * static_cast<std::int64_t>(record_bytes), counted.hash};
}

}  // namespace

FrameList::FrameList(const std::optional<std::filesystem::path>& file, const FrameCount& previous) {
    if (!file) return;
    if (previous.frames == 0) {
        file_.emplace(*file);
        return;
    }
    file_.emplace(*file, beginning_of(previous));
    FrameListReader frames(*file);
    while (frames_ < previous.frames) count(frames.next());
}

void FrameList::add(const FrameRecord& frame) {
    if (file_) {
        const FrameBytes bytes = bytes_of_frame(frame);
        file_->write(std::string_view(bytes.data(), bytes.size()));
    }
    count(frame);
}

void FrameList::count(const FrameRecord& frame) {
    pixels_.add(frame.pixels.data(), frame.pixels.size());
    last_step_ = frame.step;
    ++frames_;
}

FrameCount FrameList::sync() {
    FrameCount counted{frames_};
    if (file_) counted.hash = file_->sync().hash;
    return counted;
}

void FrameList::commit() {
    if (file_) file_->commit();
    file_.reset();
}

FrameListReader::FrameListReader(const std::filesystem::path& file)
    : file_(surviving_file(file)), bytes_(file_, std::ios::binary) {
    if (!bytes_.is_open()) reason_ = errno;
}

FrameRecord FrameListReader::next() {
    FrameBytes bytes{};
    if (!bytes_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        if (bytes_.bad()) refuse_to_read(file_, EIO);
        if (reason_ != 0 && reason_ != ENOENT) refuse_to_read(file_, reason_);
        throw InputError(
            fmt::format("{}: the list of the run's frames ends after {}; restore it, or run the "
                        "scene from its start with --force",
                        file_.string(), frames_));
    }
    FrameRecord frame = frame_of_bytes(bytes);
    frame.number = frames_++;
    return frame;
}

std::string difference(const std::filesystem::path& file, const FrameCount& counted) {
    return counted.frames == 0 ? "" : difference(file, beginning_of(counted));
}

}  // namespace fumon
