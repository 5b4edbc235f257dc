#pragma once

#include <cstddef>
#include <string>

namespace fumon {

/// The arrays of a VTK XML file: appended raw, little-endian, with 64-bit headers, in blocks that
/// zlib compressed.
class VtkArrays {
  public:
    /// Adds an array: its element to `elements`, its bytes to those to be appended.
    void add(std::string& elements, const char* type, const std::string& name, int components,
             const std::string& values);

    /// The file of a data set ("StructuredGrid", "PolyData"), whose element holds `content`.
    [[nodiscard]] std::string file(const char* kind, const std::string& extent,
                                   const std::string& content) const;

  private:
    std::string bytes_;
};

}  // namespace fumon
