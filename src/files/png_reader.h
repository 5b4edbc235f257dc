#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/image.h"

namespace fumon {

enum class PngColour { grey, grey_alpha, palette, rgb, rgb_alpha };

struct PngInfo {
    int width = 0;
    int height = 0;
    int bit_depth = 0;  ///< of a sample
    PngColour colour = PngColour::grey;
    bool transparent_colour = false;  ///< a tRNS chunk
};

/// Whether bytes start with the signature of a PNG file.
bool is_png(std::string_view bytes);

/// A PNG file in memory, read step by step. Every member but info() throws InputError "NAME: what;
/// remedy" where the file is no PNG, is damaged or truncated, or is larger than 65,535 on a side or
/// 2^28 pixels. A picture too large for its number of bytes is refused before memory is asked for.
class PngReader {
  public:
    /// Reads up to the picture. `bytes` must outlive the reader.
    PngReader(std::string_view bytes, std::string name);
    ~PngReader();
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    [[nodiscard]] const PngInfo& info() const;

    /// All samples as they are stored (16 bits: high byte first), top row first, rows packed.
    /// Call one of samples(), image() and texts(), once; texts_before_picture() before it.
    std::vector<std::uint8_t> samples();

    /// All pixels, with opacities where the file stores some.
    Image image();

    /// Keyword → text of all tEXt, zTXt and iTXt chunks, in the file's order; tEXt and zTXt, which
    /// are Latin-1, become UTF-8.
    std::vector<std::pair<std::string, std::string>> texts();

    /// Of these, those before the picture, which is not read for them.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> texts_before_picture() const;

  private:
    struct Parts;
    std::vector<std::uint8_t> read_rows();
    [[noreturn]] void refuse_damaged() const;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
