#include "mesh/vtk_arrays.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/error.h"
#include "mesh/little_endian.h"

namespace fumon {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20;

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
};

/// As vtkZLibDataCompressor has it: the number of blocks, the bytes of one and of a shorter last
/// one (0: there is none) before compression, those of each after it, and the blocks.
std::string compressed(const std::string& values) {
    constexpr int level = 6;
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (compressor == nullptr) throw std::bad_alloc();
    const std::size_t blocks = (values.size() + block_bytes - 1) / block_bytes;
    std::string header;
    std::string bytes;
    append_number<std::uint64_t>(header, blocks);
    append_number<std::uint64_t>(header, block_bytes);
    append_number<std::uint64_t>(header, values.size() % block_bytes);
    std::vector<char> room(libdeflate_zlib_compress_bound(compressor.get(), block_bytes));
    for (std::size_t begin = 0; begin < values.size(); begin += block_bytes) {
        const std::size_t length = std::min(block_bytes, values.size() - begin);
        const std::size_t made = libdeflate_zlib_compress(compressor.get(), values.data() + begin,
                                                          length, room.data(), room.size());
        if (made == 0) throw Error("a block of a VTK file could not be compressed");
        append_number<std::uint64_t>(header, made);
        bytes.append(room.data(), made);
    }
    return header + bytes;
}

}  // namespace

void VtkArrays::add(std::string& elements, const char* type, const std::string& name,
                    int components, const std::string& values) {
    elements += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, bytes_.size());
    bytes_ += compressed(values);
}

std::string VtkArrays::file(const char* kind, const std::string& extent,
                            const std::string& content) const {
    return fmt::format(
               "<?xml version=\"1.0\"?>\n"
               "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
               "<{0}{1}>\n{2}</{0}>\n"
               "<AppendedData encoding=\"raw\">\n_",
               kind, extent, content) +
           bytes_ + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace fumon
