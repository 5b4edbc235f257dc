#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "base/sha256.h"
#include "base/state_archive.h"
#include "files/atomic_file.h"

namespace fumon {

/// A checkpoint file, all numbers little-endian:
///
///     "FUMONCKP"                     8 bytes
///     format                         uint32, checkpoint_format
///     entries, one after the other   kind ('d' float64, 'i' int64, 't' UTF-8 bytes), length of the
///                                    name (uint16), name, count of values (uint64), values
///     length of all before           uint64
///     SHA-256 of all before          32 bytes
///
/// What the entries are is up to who carries them (run/run_checkpoint.h).
inline constexpr std::string_view checkpoint_magic = "FUMONCKP";
inline constexpr std::uint32_t checkpoint_format = 3;

/// Writes one entry after the other, under a temporary name until commit(). Members throw Error on
/// a full disk or any failed write.
class CheckpointWriter : public StateArchive {
  public:
    explicit CheckpointWriter(const std::filesystem::path& file);

    void values(std::string_view name, std::span<double> values) override;
    void values(std::string_view name, std::span<std::int64_t> values) override;
    void list(std::string_view name, std::vector<double>& values) override;
    void list(std::string_view name, std::vector<std::int64_t>& values) override;
    void text(std::string_view name, std::string& text) override;
    [[noreturn]] void refuse(const std::string& why) const override;

    /// Puts the file on disk (fsync) and then gives it its name; a checkpoint of that name stays
    /// until then.
    void commit();

  private:
    template <class Number>
    void write_numbers(char kind, std::string_view name, std::span<const Number> values);
    void write_header(char kind, std::string_view name, std::size_t count);
    void put(std::string_view bytes);
    void flush();

    std::filesystem::path path_;
    AtomicFile file_;
    std::string held_back_;
    Sha256Stream hash_;
    std::uint64_t length_ = 0;
};

/// Reads the entries back in their order. Memory is asked for only as far as the file has bytes
/// for it.
class CheckpointReader : public StateArchive {
  public:
    /// Reads all bytes once and throws InputError "NAME: WHY; …" where they are no checkpoint, one
    /// of another format, cut short or damaged.
    CheckpointReader(std::unique_ptr<std::istream> bytes, std::string name);
    ~CheckpointReader() override;

    void values(std::string_view name, std::span<double> values) override;
    void values(std::string_view name, std::span<std::int64_t> values) override;
    void list(std::string_view name, std::vector<double>& values) override;
    void list(std::string_view name, std::vector<std::int64_t>& values) override;
    void text(std::string_view name, std::string& text) override;
    [[noreturn]] void refuse(const std::string& why) const override;

    /// Throws InputError where entries are left.
    void finish();

  private:
    template <class Number>
    void read_numbers(std::span<Number> values);
    std::size_t read_header(char kind, std::string_view name, std::size_t size);
    void take(void* to, std::size_t count);
    void check();

    std::unique_ptr<std::istream> bytes_;
    std::string name_;
    std::uint64_t left_ = 0;  ///< bytes of entries that have not been taken
};

/// A checkpoint file. Throws as CheckpointReader, and where the file cannot be read.
std::unique_ptr<CheckpointReader> open_checkpoint(const std::filesystem::path& file);

}  // namespace fumon
