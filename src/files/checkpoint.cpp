#include "files/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <system_error>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::size_t block = std::size_t{1} << 16;  // bytes, held back or hashed at once
constexpr std::size_t head_bytes = checkpoint_magic.size() + sizeof checkpoint_format;
constexpr std::size_t tail_bytes = sizeof(std::uint64_t) + std::tuple_size_v<Sha256>;
constexpr const char* remedy =
    "take an untouched copy of it, or run the scene from its start with --force";

template <class Unsigned>
std::array<char, sizeof(Unsigned)> little_endian(Unsigned value) {
    std::array<char, sizeof(Unsigned)> bytes{};
    for (char& byte : bytes) {
        byte = static_cast<char>(value & 0xFFU);
        value = static_cast<Unsigned>(value >> 8U);
    }
    return bytes;
}

template <class Unsigned, std::size_t size>
Unsigned number_of(const std::array<char, size>& bytes) {
    static_assert(size == sizeof(Unsigned));
    Unsigned value = 0;
    for (std::size_t i = size; i-- > 0;)
        value = static_cast<Unsigned>((value << 8U) | static_cast<std::uint8_t>(bytes[i]));
    return value;
}

template <std::size_t size>
std::string_view view_of(const std::array<char, size>& bytes) {
    return {bytes.data(), bytes.size()};
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::filesystem::path& file) : path_(file), file_(file) {
    put(checkpoint_magic);
    put(view_of(little_endian(checkpoint_format)));
}

void CheckpointWriter::values(std::string_view name, std::span<double> values) {
    write_numbers<double>('d', name, values);
}

void CheckpointWriter::values(std::string_view name, std::span<std::int64_t> values) {
    write_numbers<std::int64_t>('i', name, values);
}

void CheckpointWriter::list(std::string_view name, std::vector<double>& values) {
    write_numbers<double>('d', name, values);
}

void CheckpointWriter::list(std::string_view name, std::vector<std::int64_t>& values) {
    write_numbers<std::int64_t>('i', name, values);
}

void CheckpointWriter::text(std::string_view name, std::string& text) {
    write_header('t', name, text.size());
    put(text);
}

void CheckpointWriter::refuse(const std::string& why) const {
    throw Error(fmt::format("cannot write {}: {}", path_.string(), why));
}

template <class Number>
void CheckpointWriter::write_numbers(char kind, std::string_view name,
                                     std::span<const Number> values) {
    write_header(kind, name, values.size());
    if constexpr (std::endian::native == std::endian::little) {
        put({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    } else {
        for (const Number value : values)
            put(view_of(little_endian(std::bit_cast<std::uint64_t>(value))));
    }
}

void CheckpointWriter::write_header(char kind, std::string_view name, std::size_t count) {
    if (name.size() > std::numeric_limits<std::uint16_t>::max()) refuse("a name is too long");
    put({&kind, 1});
    put(view_of(little_endian(static_cast<std::uint16_t>(name.size()))));
    put(name);
    put(view_of(little_endian(static_cast<std::uint64_t>(count))));
}

void CheckpointWriter::put(std::string_view bytes) {
    hash_.add(bytes.data(), bytes.size());
    length_ += bytes.size();
    if (held_back_.size() + bytes.size() > block) flush();
    if (bytes.size() > block) {
        file_.write(bytes);
    } else {
        held_back_ += bytes;
    }
}

void CheckpointWriter::flush() {
    file_.write(held_back_);
    held_back_.clear();
}

void CheckpointWriter::commit() {
    put(view_of(little_endian(length_)));
    const Sha256 hash = hash_.finish();
    flush();
    file_.write(hash);
    file_.sync();
    file_.commit();
    sync_folder_of(path_);
}

CheckpointReader::CheckpointReader(std::unique_ptr<std::istream> bytes, std::string name)
    : bytes_(std::move(bytes)), name_(std::move(name)) {
    check();
}

CheckpointReader::~CheckpointReader() = default;

void CheckpointReader::check() {
    bytes_->seekg(0, std::ios::end);
    const auto end = static_cast<std::streamoff>(bytes_->tellg());
    const std::uint64_t size = end > 0 ? static_cast<std::uint64_t>(end) : 0;
    bytes_->seekg(0);
    left_ = size;
    std::array<char, checkpoint_magic.size()> magic{};
    if (size >= magic.size()) take(magic.data(), magic.size());
    if (view_of(magic) != checkpoint_magic)
        throw InputError(fmt::format("{}: is not a checkpoint of fumon; {}", name_, remedy));
    std::array<char, sizeof checkpoint_format> format{};
    if (size < head_bytes + tail_bytes) refuse("is cut short");
    take(format.data(), format.size());
    if (number_of<std::uint32_t>(format) != checkpoint_format)
        throw InputError(
            fmt::format("{}: has format {}, but this fumon reads format {}; resume with the "
                        "version that wrote it",
                        name_, number_of<std::uint32_t>(format), checkpoint_format));

    Sha256Stream hash;
    hash.add(magic.data(), magic.size());
    hash.add(format.data(), format.size());
    std::vector<char> buffer(block);
    for (std::uint64_t rest = size - head_bytes - tail_bytes; rest > 0;) {
        const std::size_t some = static_cast<std::size_t>(std::min<std::uint64_t>(rest, block));
        take(buffer.data(), some);
        hash.add(buffer.data(), some);
        rest -= some;
    }
    std::array<char, sizeof(std::uint64_t)> length{};
    take(length.data(), length.size());
    hash.add(length.data(), length.size());
    Sha256 written{};
    take(written.data(), written.size());
    if (hash.finish() != written) {
        if (number_of<std::uint64_t>(length) != size - tail_bytes)
            refuse("is cut short or damaged");
        refuse("is damaged: its SHA-256 does not match");
    }
    if (number_of<std::uint64_t>(length) != size - tail_bytes) refuse("has a wrong length");
    bytes_->seekg(static_cast<std::streamoff>(head_bytes));
    left_ = size - head_bytes - tail_bytes;
}

void CheckpointReader::values(std::string_view name, std::span<double> values) {
    if (read_header('d', name, sizeof(double)) != values.size())
        refuse(fmt::format("its {} has a different size", name));
    read_numbers(values);
}

void CheckpointReader::values(std::string_view name, std::span<std::int64_t> values) {
    if (read_header('i', name, sizeof(std::int64_t)) != values.size())
        refuse(fmt::format("its {} has a different size", name));
    read_numbers(values);
}

void CheckpointReader::list(std::string_view name, std::vector<double>& values) {
    values.resize(read_header('d', name, sizeof(double)));
    read_numbers(std::span(values));
}

void CheckpointReader::list(std::string_view name, std::vector<std::int64_t>& values) {
    values.resize(read_header('i', name, sizeof(std::int64_t)));
    read_numbers(std::span(values));
}

void CheckpointReader::text(std::string_view name, std::string& text) {
    text.resize(read_header('t', name, 1));
    take(text.data(), text.size());
}

void CheckpointReader::refuse(const std::string& why) const {
    throw InputError(fmt::format("{}: {}; {}", name_, why, remedy));
}

void CheckpointReader::finish() {
    if (left_ != 0) refuse("has unexpected data at its end");
}

/// The number of values that follow, of `size` bytes each: no more than there are bytes for.
std::size_t CheckpointReader::read_header(char kind, std::string_view name, std::size_t size) {
    char found_kind = 0;
    std::array<char, sizeof(std::uint16_t)> length{};
    take(&found_kind, 1);
    take(length.data(), length.size());
    std::string found(number_of<std::uint16_t>(length), '\0');
    take(found.data(), found.size());
    std::array<char, sizeof(std::uint64_t)> count{};
    take(count.data(), count.size());
    if (found != name || found_kind != kind)
        refuse(fmt::format("holds \"{}\" where \"{}\" was expected", found, name));
    if (number_of<std::uint64_t>(count) > left_ / size)
        refuse(fmt::format("its {} is cut short", name));
    return static_cast<std::size_t>(number_of<std::uint64_t>(count));
}

template <class Number>
void CheckpointReader::read_numbers(std::span<Number> values) {
    take(values.data(), values.size_bytes());
    if constexpr (std::endian::native != std::endian::little) {
        for (Number& value : values)
            value = std::bit_cast<Number>(
                number_of<std::uint64_t>(std::bit_cast<std::array<char, sizeof(Number)>>(value)));
    }
}

void CheckpointReader::take(void* to, std::size_t count) {
    if (count > left_) refuse("is cut short");
    bytes_->read(static_cast<char*>(to), static_cast<std::streamsize>(count));
    if (bytes_->bad()) refuse_to_read(name_, EIO);
    if (!*bytes_) refuse("cannot be read");
    left_ -= count;
}

std::unique_ptr<CheckpointReader> open_checkpoint(const std::filesystem::path& file) {
    std::error_code fault;
    auto stream = std::make_unique<std::ifstream>();
    const bool there = std::filesystem::is_regular_file(file, fault);
    if (there) stream->open(file, std::ios::binary);
    if (there && !stream->is_open()) refuse_to_read(file, errno);
    if (!there) {
        throw InputError(fmt::format("{}: cannot be read: {}; run the scene from its start",
                                     file.string(),
                                     fault ? fault.message() : "there is no such file"));
    }
    return std::make_unique<CheckpointReader>(std::move(stream), file.string());
}

}  // namespace fumon
