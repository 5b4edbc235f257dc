#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/netcdf/netcdf_calls.h"

namespace fumon {

inline constexpr std::size_t netcdf_signature_length = 8;  // bytes

/// Whether a file's first bytes are those of NetCDF: classic ("CDF") or version 4 (HDF5).
bool is_netcdf(std::string_view start);

/// A NetCDF file opened for reading: its root group. The caller holds the NetcdfLock for as long as
/// one lives. All calls throw NetcdfFault where the library fails.
class NetcdfInput {
  public:
    /// Throws InputError for a classic file that is cut short (see netcdf_classic.h), Error where
    /// too many files are open.
    explicit NetcdfInput(const std::filesystem::path& file);

    [[nodiscard]] int id() const { return file_.id(); }
    [[nodiscard]] const std::string& name() const { return name_; }  ///< the file's, for messages

    [[nodiscard]] int variables() const;
    [[nodiscard]] std::optional<int> find_variable(const std::string& name) const;
    [[nodiscard]] std::string variable_name(int variable) const;
    [[nodiscard]] int type(int variable) const;         ///< NC_DOUBLE …
    [[nodiscard]] bool is_numeric(int variable) const;  ///< an integer or a real of any size
    [[nodiscard]] std::vector<int> dimensions(int variable) const;
    [[nodiscard]] std::string dimension_name(int dimension) const;
    [[nodiscard]] std::size_t dimension_length(int dimension) const;

    /// How many values there are over dimensions. Throws InputError for more than the largest
    /// terrain has cells.
    [[nodiscard]] std::size_t values_over(std::span<const int> dimensions) const;

    /// A text attribute; nothing where there is none of this name or it is not text.
    [[nodiscard]] std::optional<std::string> text(int variable, const char* attribute) const;
    /// A numeric attribute; empty where there is none of this name or it is text.
    [[nodiscard]] std::vector<double> numbers(int variable, const char* attribute) const;

    /// Throws InputError "FILE: what; remedy".
    [[noreturn]] void refuse(std::string_view what, std::string_view remedy) const;

  private:
    std::string name_;
    NetcdfHandle file_;
};

}  // namespace fumon
