#pragma once

#include <mutex>
#include <string>

#include "files/gdal/gdal_types.h"

namespace fumon {

/// Held around every use of GDAL, whose settings and messages belong to the thread that it runs on:
/// registers its drivers once, keeps GDAL from printing and from the network, and collects what it
/// says.
class GdalSession {
  public:
    /// Which files GDAL may open beside the named one.
    enum class Siblings {
        none,     ///< for files of unknown origin
        by_name,  ///< those that belong to it by their names: .msk, .aux.xml, .hdr, .tfw
    };

    /// Throws InputError where GDAL is not installed.
    explicit GdalSession(Siblings siblings = Siblings::none);
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// The first thing that went wrong, in GDAL's words as one line; empty where nothing did.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    /// Forgets what went wrong so far.
    void forget() { fault_.clear(); }

  private:
    static void collect(CPLErr kind, CPLErrorNum number, const char* message);

    std::lock_guard<std::mutex> lock_;
    std::string fault_;
};

/// A dataset that closes itself.
class GdalDataset {
  public:
    explicit GdalDataset(GDALDatasetH handle) : handle_(handle) {}
    ~GdalDataset() { close(); }
    GdalDataset(const GdalDataset&) = delete;
    GdalDataset& operator=(const GdalDataset&) = delete;
    GdalDataset(GdalDataset&& other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }
    GdalDataset& operator=(GdalDataset&& other) noexcept {
        if (this != &other) {
            close();
            handle_ = other.handle_;
            other.handle_ = nullptr;
        }
        return *this;
    }

    [[nodiscard]] GDALDatasetH get() const { return handle_; }
    void close();  ///< writes what is not yet written

  private:
    GDALDatasetH handle_;
};

}  // namespace fumon
