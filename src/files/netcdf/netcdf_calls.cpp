#include "files/netcdf/netcdf_calls.h"

#include <H5Epublic.h>
#include <netcdf.h>

namespace fumon {

namespace {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

NetcdfLock::NetcdfLock() : lock_(library_mutex()) {
    // HDF5 prints its errors, even those that NetCDF expects, in every thread but the first that
    // used NetCDF.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void check_netcdf(int status) {
    if (status != NC_NOERR) throw NetcdfFault(nc_strerror(status));
}

}  // namespace fumon
