#pragma once

#include <gdal.h>

#include <mutex>
#include <string>

namespace fumon {

/// Held around every use of GDAL, whose settings and messages belong to the thread that it runs on:
/// registers the drivers in use once, keeps GDAL from printing, collects what it says, and lets it
/// read and write the named file alone, no other one beside it, unless it is a VRT that names
/// others.
class GdalSession {
  public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// The first thing that went wrong, in GDAL's words as one line; empty where nothing did.
    [[nodiscard]] const std::string& fault() const { return fault_; }

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

    [[nodiscard]] GDALDatasetH get() const { return handle_; }
    void close();  ///< writes what is not yet written

  private:
    GDALDatasetH handle_;
};

}  // namespace fumon
