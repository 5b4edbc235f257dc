#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/image.h"
#include "files/atomic_file.h"
#include "picture/baseline.h"
#include "picture/verdict.h"

namespace fumon {

/// The folder of cases that did not pass: their pictures, and index.html, a self-contained page
/// that shows them side by side and in turns. Created with the first case that is added; memory
/// does not grow with their number.
class VerifyPage {
  public:
    /// Deletes the page that an earlier run left there. Throws InputError where index.html is
    /// something else.
    explicit VerifyPage(std::filesystem::path folder);

    /// Deletes the pictures that an earlier run left of a case. Throws Error.
    void forget(const std::string& suite, const std::string& name);

    /// Writes DIR/SUITE/NAME-got.png and, where `record` is not null, -expected.png and
    /// -difference.png: of the kept picture, else of the thumbnails. Throws Error.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict,
             const Image& got, const BaselineRecord* record, const Image* expected);

    /// Adds a case of which there is no picture.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict);

    /// Ends the page, if there is one. Throws Error.
    void finish();

    [[nodiscard]] bool has_cases() const { return page_ != nullptr; }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "index.html"; }

  private:
    [[nodiscard]] std::filesystem::path picture(const std::string& suite, const std::string& name,
                                                std::string_view kind) const;
    void begin();
    void open_section(const std::string& suite, const std::string& name, const Verdict& verdict,
                      bool pair);
    void show(const Image& image, const std::filesystem::path& file, const char* kind,
              const std::string& caption);

    std::filesystem::path folder_;
    std::unique_ptr<AtomicFile> page_;
};

}  // namespace fumon
