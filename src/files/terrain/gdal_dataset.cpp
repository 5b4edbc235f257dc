#include "files/terrain/gdal_dataset.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.h"
#include "files/terrain/gdal_functions.h"

namespace fumon {

namespace {

std::mutex& gdal_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

void* GdalFunctions::address_of(const char* name) {
    static void* const library = dlopen(FUMON_GDAL_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    void* const address = library == nullptr ? nullptr : dlsym(library, name);
    if (address != nullptr) return address;
    const char* why = dlerror();
    throw Error(
        fmt::format("GDAL, which GeoTIFF needs, cannot be loaded: {}; install it (on Debian {})",
                    why == nullptr ? name : why, FUMON_GDAL_PACKAGE));
}

const GdalFunctions& gdal() {
    static const GdalFunctions functions;
    return functions;
}

GdalSession::GdalSession() : lock_(gdal_mutex()) {
    static const bool once = [] {
        gdal().GDALRegister_GTiff();
        gdal().GDALRegister_COG();
        gdal().GDALRegister_MEM();
        gdal().GDALRegister_VRT();
        gdal().CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");  // no FILE.aux.xml
        gdal().CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN",
                                  "EMPTY_DIR");  // no FILE.tfw, .ovr, .msk
        gdal().CPLSetConfigOption("GDAL_NUM_THREADS", "1");
        return true;
    }();
    static_cast<void>(once);
    gdal().CPLPushErrorHandlerEx(collect, this);
}

GdalSession::~GdalSession() {
    gdal().CPLPopErrorHandler();
}

void GdalSession::collect(CPLErr kind, CPLErrorNum, const char* message) {
    auto* session = static_cast<GdalSession*>(gdal().CPLGetErrorHandlerUserData());
    if (kind >= CE_Failure && session->fault_.empty()) session->fault_ = one_line(message);
}

void GdalDataset::close() {
    if (handle_ != nullptr) gdal().GDALClose(handle_);
    handle_ = nullptr;
}

}  // namespace fumon
