#include "files/gdal/gdal_session.h"

#include "base/error.h"
#include "files/gdal/gdal_functions.h"

namespace fumon {

namespace {

std::mutex& gdal_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// Drivers that GDAL loads from folders would be other people's programs, and a reader of local
/// files asks no server.
void set_up_once() {
    static const bool once = [] {
        gdal().CPLSetConfigOption("GDAL_DRIVER_PATH", "disable");
        gdal().CPLSetConfigOption("GDAL_PYTHON_DRIVER_PATH", nullptr);
        gdal().CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
        gdal().CPLSetConfigOption("PROJ_NETWORK", "OFF");
        gdal().CPLSetConfigOption("GDAL_HTTP_MAX_RETRY", "0");
        gdal().CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_FILENAME", "");
        gdal().CPLSetConfigOption("GDAL_NUM_THREADS", "1");
        gdal().GDALAllRegister();
        return true;
    }();
    static_cast<void>(once);
}

}  // namespace

GdalSession::GdalSession(Siblings siblings) : lock_(gdal_mutex()) {
    set_up_once();
    const bool alone = siblings == Siblings::none;
    gdal().CPLSetConfigOption("GDAL_PAM_ENABLED", alone ? "NO" : "YES");
    gdal().CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", alone ? "EMPTY_DIR" : "NO");
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
