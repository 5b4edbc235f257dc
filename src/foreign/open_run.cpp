#include "foreign/open_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/field_files.h"
#include "foreign/file_numbers.h"
#include "foreign/netcdf_run.h"
#include "foreign/raster_series.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// Endings of formats that are not read, and the way in.
struct OtherFormat {
    std::string_view ending;
    std::string_view title;
    std::string_view way;
};

constexpr std::array<OtherFormat, 14> other_formats{{
    {".vtk", "VTK",
     "resample it to an image and write it as NetCDF (pvpython, or PyVista's sample)"},
    {".vtu", "VTK",
     "resample it to an image and write it as NetCDF (pvpython, or PyVista's sample)"},
    {".vti", "VTK", "write its scalars as NetCDF (PyVista and xarray)"},
    {".vts", "VTK",
     "resample it to an image and write it as NetCDF (pvpython, or PyVista's sample)"},
    {".vtp", "VTK",
     "resample it to an image and write it as NetCDF (pvpython, or PyVista's sample)"},
    {".pvd", "VTK", "resample it to images and write them as NetCDF (pvpython)"},
    {".xdmf", "XDMF", "resample it to an image and write it as NetCDF (pvpython)"},
    {".xmf", "XDMF", "resample it to an image and write it as NetCDF (pvpython)"},
    {".slf", "SELAFIN of TELEMAC",
     "lay it on a raster and write it as NetCDF (telapy, or QGIS's mesh export)"},
    {".grib", "GRIB", "write it as NetCDF (cdo -f nc copy, or cfgrib and xarray)"},
    {".grib2", "GRIB", "write it as NetCDF (cdo -f nc copy, or cfgrib and xarray)"},
    {".mat", "MATLAB", "write it as NetCDF (MATLAB's nccreate and ncwrite)"},
    {".npy", "NumPy", "write it as NetCDF (xarray.DataArray.to_netcdf), or open it in Python"},
    {".npz", "NumPy", "write it as NetCDF (xarray.Dataset.to_netcdf), or open it in Python"},
}};

const OtherFormat* other_format(const std::string& argument) {
    const std::string ending = fs::path(argument).extension().string();
    const auto found = std::ranges::find(other_formats, ending, &OtherFormat::ending);
    return found == other_formats.end() ? nullptr : &*found;
}

bool is_address(const std::string& argument) {
    return argument.find("://") != std::string::npos;
}

/// What an argument stands for: itself, or the files of its pattern.
std::vector<fs::path> files_of_argument(const std::string& argument) {
    std::error_code fault;
    if (fs::exists(argument, fault) || !is_pattern(argument)) return {argument};
    return files_of_pattern(argument);
}

bool is_netcdf_file(const fs::path& file) {
    std::error_code fault;
    const std::string ending = file.extension().string();
    if (!fs::is_regular_file(file, fault)) return false;
    return ending == ".nc" || ending == ".nc4" || ending == ".cdf" || ending == ".sww" ||
           is_netcdf(start_of_input_file(file, netcdf_signature_length));
}

}  // namespace

bool is_foreign_run(const std::string& argument) {
    std::error_code fault;
    if (is_address(argument) || is_zarr(argument)) return true;
    if (fs::is_directory(argument, fault)) return false;
    if (fs::exists(argument, fault)) return is_netcdf_file(argument) || other_format(argument);
    return is_pattern(argument);
}

std::vector<fs::path> files_of_foreign_run(const std::string& argument, const ForeignQuery& query) {
    std::vector<fs::path> files = files_of_argument(argument);
    for (const std::string& field : query.fields)
        for (fs::path& file : files_of_source(field_request(field).source))
            files.push_back(std::move(file));
    return files;
}

ForeignRun open_foreign_run(const std::string& argument, const ForeignQuery& query) {
    std::error_code fault;
    if (is_address(argument))
        throw InputError(
            fmt::format("{}: addresses are not read; copy it to a local file first "
                        "(xarray.open_dataset(…).to_netcdf(\"run.nc\"))",
                        argument));
    if (is_zarr(argument))
        throw InputError(
            fmt::format("{}: is Zarr, which is not read as a run; write it as NetCDF "
                        "(xarray.open_zarr(…).to_netcdf(\"run.nc\"))",
                        argument));
    const bool one = fs::exists(argument, fault);
    if (one) {
        if (const OtherFormat* other = other_format(argument))
            throw InputError(fmt::format("{}: is {}, which is not read; {}", argument, other->title,
                                         other->way));
    }
    const std::vector<fs::path> files =
        one ? std::vector{fs::path(argument)} : files_of_pattern(argument);
    return is_netcdf_file(files.front()) ? read_netcdf_run(argument, files, query)
                                         : read_raster_series(argument, files, query);
}

}  // namespace fumon
