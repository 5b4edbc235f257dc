#include "files/netcdf_calls.h"

#include <netcdf.h>

namespace fumon {

namespace {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

NetcdfLock::NetcdfLock() : lock_(library_mutex()) {}

void check_netcdf(int status) {
    if (status != NC_NOERR) throw NetcdfFault(nc_strerror(status));
}

}  // namespace fumon
