#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fumon {

/// The rule by which every command writes, asked before it computes anything:
///
///   - what the command reads is never replaced, not even with --force;
///   - a file that is there is replaced if it is fumon's: it says so itself (outputs/own_file.h),
///   or
///     the run, sweep, figure or baseline beside it does;
///   - any other file is replaced with --force only;
///   - a path that cannot be written is refused at once.
///
/// A file under the temporary name of an output (NAME.part) counts as the output itself.
class OutputClaims {
  public:
    /// `force`: whether --force is given.
    explicit OutputClaims(bool force) : force_(force) {}

    /// Notes a file that the command reads; one that is not there, or "", is none.
    void reads(const std::filesystem::path& file);
    void reads(const std::vector<std::filesystem::path>& files);

    /// Whether a path leads to such a file: by its name, through a link, or as another name of it.
    [[nodiscard]] bool is_read(const std::filesystem::path& file) const;

    /// Claims a file to write. `listed`: what stands beside it says that it is fumon's. Throws
    /// InputError where the rule or another claimed output forbids it, Error where it cannot be
    /// written. Leaves no trace.
    void writes(const std::filesystem::path& file, bool listed = false);

    /// Throws InputError as writes(), without a look at whether it can be written.
    void check(const std::filesystem::path& file, bool listed) const;

    [[nodiscard]] bool force() const { return force_; }

  private:
    bool force_;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> inputs_;  ///< device and number there
    std::vector<std::filesystem::path> outputs_;
};

/// Throws InputError naming the endings if a file's name has none of them, in small letters or
/// capitals. Pipes and devices ("/dev/stdout") may be called as they are. `what`: "a picture".
void check_ending(const std::filesystem::path& file, std::string_view what,
                  std::span<const std::string_view> endings);

inline constexpr std::array<std::string_view, 1> png_ending{".png"};
inline constexpr std::array<std::string_view, 1> exr_ending{".exr"};
inline constexpr std::array<std::string_view, 7> picture_endings{".png", ".jpg",  ".jpeg", ".webp",
                                                                 ".tif", ".tiff", ".exr"};
/// Of these, those that hold pixels of 8 bits and that browsers show.
inline constexpr std::array<std::string_view, 4> pixel_endings{".png", ".jpg", ".jpeg", ".webp"};
inline constexpr std::array<std::string_view, 1> movie_ending{".mp4"};
inline constexpr std::array<std::string_view, 1> scene_ending{".toml"};
inline constexpr std::array<std::string_view, 1> table_ending{".csv"};
inline constexpr std::array<std::string_view, 1> junit_ending{".xml"};

/// A file's ending in small letters: ".png".
std::string small_ending(const std::filesystem::path& file);

/// Throws InputError for the root of the file system, a file and an empty path, Error where the
/// folder or, if it is not there yet, the first one above it cannot be written. Leaves no trace.
/// `what`: what the folder is for, "the run".
void check_output_folder(const std::filesystem::path& folder, std::string_view what);

/// Throws InputError "FILE is there already …; …--force replaces it".
[[noreturn]] void refuse_to_replace(const std::filesystem::path& file);
/// Throws InputError "FILE is read, and would be replaced; …".
[[noreturn]] void refuse_to_replace_input(const std::filesystem::path& file);

}  // namespace fumon
