#include "run/frame_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::size_t number_bytes = sizeof(std::uint64_t);
constexpr std::size_t record_bytes = 2 * number_bytes + std::tuple_size_v<Sha256>;
using FrameBytes = std::array<char, record_bytes>;

void put_number(std::uint64_t number, char* bytes) {
    for (std::size_t i = 0; i < number_bytes; ++i, number >>= 8U)
        bytes[i] = static_cast<char>(number & 0xFFU);
}

std::uint64_t number_at(const char* bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = number_bytes; i-- > 0;)
        number = number << 8U | static_cast<std::uint8_t>(bytes[i]);
    return number;
}

FrameBytes bytes_of_frame(const FrameRecord& frame) {
    FrameBytes bytes{};
    put_number(static_cast<std::uint64_t>(frame.step), bytes.data());
    put_number(std::bit_cast<std::uint64_t>(frame.time), bytes.data() + number_bytes);
    std::copy(frame.pixels.begin(), frame.pixels.end(), bytes.data() + 2 * number_bytes);
    return bytes;
}

FrameRecord frame_of_bytes(const FrameBytes& bytes) {
    FrameRecord frame;
    frame.step = static_cast<std::int64_t>(number_at(bytes.data()));
    frame.time = std::bit_cast<double>(number_at(bytes.data() + number_bytes));
    std::transform(bytes.data() + 2 * number_bytes, bytes.data() + record_bytes,
                   frame.pixels.begin(), [](char byte) { return static_cast<std::uint8_t>(byte); });
    return frame;
}

}  // namespace

FrameList::FrameList(const std::optional<std::filesystem::path>& file, std::int64_t frames) {
    if (!file) return;
    if (frames == 0) {
        file_.emplace(*file);
        return;
    }
    file_.emplace(*file, frames * static_cast<std::int64_t>(record_bytes));
    FrameListReader former(*file);
    for (std::int64_t k = 0; k < frames; ++k) count(former.next());
}

void FrameList::add(const FrameRecord& frame) {
    if (file_) {
        const FrameBytes bytes = bytes_of_frame(frame);
        file_->write(std::string_view(bytes.data(), bytes.size()));
    }
    count(frame);
}

void FrameList::count(const FrameRecord& frame) {
    const FrameBytes bytes = bytes_of_frame(frame);
    records_.add(bytes.data(), bytes.size());
    pixels_.add(frame.pixels.data(), frame.pixels.size());
    last_step_ = frame.step;
    ++frames_;
}

FrameCount FrameList::sync() {
    if (file_) file_->sync();
    return {frames_, records_.so_far()};
}

void FrameList::commit() {
    if (file_) file_->commit();
    file_.reset();
}

FrameListReader::FrameListReader(const std::filesystem::path& file)
    : file_(file), bytes_(temporary_name(file), std::ios::binary) {
    if (!bytes_) bytes_.open(file, std::ios::binary);
}

FrameRecord FrameListReader::next() {
    FrameBytes bytes{};
    if (!bytes_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        if (bytes_.bad()) refuse_to_read(file_, EIO);
        throw InputError(
            fmt::format("{}: the list of the run's frames ends after {}; bring it back, or run the "
                        "scene from its start with --force",
                        file_.string(), frames_));
    }
    FrameRecord frame = frame_of_bytes(bytes);
    frame.number = frames_++;
    return frame;
}

void check_frame_list(const std::filesystem::path& file, const FrameCount& counted) {
    if (counted.frames == 0) return;
    FrameListReader frames(file);
    Sha256Stream records;
    for (std::int64_t k = 0; k < counted.frames; ++k) {
        const FrameBytes bytes = bytes_of_frame(frames.next());
        records.add(bytes.data(), bytes.size());
    }
    if (records.finish() == counted.hash) return;
    throw InputError(
        fmt::format("{}: is damaged; take an untouched copy of it, or run the scene from its start "
                    "with --force",
                    file.string()));
}

}  // namespace fumon
