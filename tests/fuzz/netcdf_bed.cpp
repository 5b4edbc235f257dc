// NetCDF files: as a bed and as a run's fields.

#include "files/terrain/netcdf_bed.h"

#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_record.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const std::string_view bytes = fuzz::as_text(data, size);
    // Only the classic format: HDF5 has faults of its own on damaged files.
    if (!is_netcdf(bytes) || !bytes.starts_with("CDF")) return -1;
    const fuzz::MemoryFile file(bytes);
    fuzz::taken([&] { read_netcdf_bed(file.path(), {}); });
    fuzz::taken([&] { read_fields_record(file.path()); });
    Snapshot outline;
    outline.bed = Grid(4, 3);
    outline.nodata = Mask(4, 3);
    outline.fields.push_back({"bed_height", "", "", {}});
    outline.numbers.push_back({"time", "", 0.0});
    fuzz::taken([&] { read_fields_snapshot(file.path(), 0, outline); });
    return 0;
}
