#include "files/netcdf/netcdf_calls.h"

#include <H5Epublic.h>
#include <H5Fpublic.h>
#include <H5Ipublic.h>
#include <H5Ppublic.h>
#include <H5public.h>
#include <netcdf.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace fumon {

namespace {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// Keeps HDF5 from ending itself when the program does: it would close the files that it could not
/// close before, where the device failed, and crash. All others are closed by then.
void keep_until_exit() {
    [[maybe_unused]] static const int done = H5dont_atexit();
}

constexpr std::int64_t none = -1;

std::vector<hid_t> files_of_hdf5() {
    constexpr auto every_file = static_cast<hid_t>(H5F_OBJ_ALL);
    const auto count = std::max<ssize_t>(H5Fget_obj_count(every_file, H5F_OBJ_FILE), 0);
    std::vector<hid_t> ids(static_cast<std::size_t>(count));
    if (count > 0) H5Fget_obj_ids(every_file, H5F_OBJ_FILE, ids.size(), ids.data());
    return ids;
}

/// A second reference to the file that HDF5 has opened since; none where it has not.
std::int64_t hold_file_opened_since(const std::vector<hid_t>& before) {
    for (const hid_t file : files_of_hdf5()) {
        if (std::ranges::find(before, file) == before.end() && H5Iinc_ref(file) > 1) return file;
    }
    return none;
}

/// HDF5's handle of a file, which the NetCDF library's will share; none of a classic file.
/// `degree` must be the NetCDF library's, which has one or another by how it was built.
std::int64_t opened_by_hdf5(const std::filesystem::path& file, H5F_close_degree_t degree) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, degree);
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
    return opened < 0 ? none : opened;
}

}  // namespace

NetcdfLock::NetcdfLock()
    : lock_(library_mutex()),
      at_work_(
          "fumon: crashed in HDF5, as it does on a broken disk and where memory ends; if it is "
          "neither, please report it. Files under their final names are whole\n") {
    keep_until_exit();
    // HDF5 prints its errors, even those that NetCDF expects, in every thread but the first that
    // used NetCDF.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void check_netcdf(int status) {
    if (status == NC_ENOMEM) throw std::bad_alloc();
    if (status == NC_EHDFERR)
        throw NetcdfFault("HDF error: a checksum does not match, or the disk failed");
    if (status != NC_NOERR) throw NetcdfFault(nc_strerror(status));
}

NetcdfHandle NetcdfHandle::create(const std::filesystem::path& file) {
    const auto before = files_of_hdf5();
    NetcdfHandle made;
    check_netcdf(nc_create(file.c_str(), NC_NETCDF4 | NC_CLOBBER, &made.id_));
    made.hdf5_ = hold_file_opened_since(before);
    return made;
}

NetcdfHandle NetcdfHandle::open_to_read(const std::filesystem::path& file) {
    static std::vector<H5F_close_degree_t> degrees{H5F_CLOSE_WEAK, H5F_CLOSE_SEMI,
                                                   H5F_CLOSE_STRONG};
    int status = NC_NOERR;
    for (const H5F_close_degree_t degree : degrees) {
        NetcdfHandle opened;
        opened.hdf5_ = opened_by_hdf5(file, degree);
        status = nc_open(file.c_str(), NC_NOWRITE, &opened.id_);
        if (status != NC_NOERR) continue;
        if (opened.hdf5_ >= 0) degrees = {degree};  // found
        return opened;
    }
    check_netcdf(status);
    return {};
}

NetcdfHandle::NetcdfHandle(NetcdfHandle&& other) noexcept
    : id_(std::exchange(other.id_, -1)), hdf5_(std::exchange(other.hdf5_, none)) {}

NetcdfHandle& NetcdfHandle::operator=(NetcdfHandle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(hdf5_, other.hdf5_);
    return *this;
}

bool NetcdfHandle::close() {
    bool whole = true;
    if (id_ >= 0) whole = nc_close(std::exchange(id_, -1)) == NC_NOERR;
    if (hdf5_ >= 0) whole = H5Fclose(std::exchange(hdf5_, none)) >= 0 && whole;
    return whole;
}

}  // namespace fumon
