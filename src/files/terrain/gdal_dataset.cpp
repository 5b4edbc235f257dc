#include "files/terrain/gdal_dataset.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_frmts.h>

#include "base/error.h"

namespace fumon {

namespace {

std::mutex& gdal_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

GdalSession::GdalSession() : lock_(gdal_mutex()) {
    static const bool once = [] {
        GDALRegister_GTiff();
        CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");                     // no FILE.aux.xml
        CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");  // no FILE.tfw, .ovr, .msk
        CPLSetConfigOption("GDAL_NUM_THREADS", "1");
        return true;
    }();
    static_cast<void>(once);
    CPLPushErrorHandlerEx(collect, this);
}

GdalSession::~GdalSession() {
    CPLPopErrorHandler();
}

void GdalSession::collect(CPLErr kind, CPLErrorNum, const char* message) {
    auto* session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
    if (kind >= CE_Failure && session->fault_.empty()) session->fault_ = one_line(message);
}

void GdalDataset::close() {
    if (handle_ != nullptr) GDALClose(handle_);
    handle_ = nullptr;
}

}  // namespace fumon
