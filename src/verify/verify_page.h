#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/image.h"
#include "files/atomic_file.h"
#include "files/folder_lock.h"
#include "outputs/output_claims.h"
#include "picture/baseline.h"
#include "picture/pixels/ignored_pixels.h"
#include "picture/verdict.h"

namespace fumon {

/// The folder of cases that did not pass: their pictures, and index.html, a self-contained page
/// that shows them side by side and in turns. Created with the first case that is added; memory
/// does not grow with their number.
class VerifyPage {
  public:
    /// Locks the folder if it is there. Throws InputError where the claims forbid the page or
    /// another program is working there.
    VerifyPage(std::filesystem::path folder, const OutputClaims& claims);

    /// Throws as OutputClaims::check() where the pictures of a case may not be written.
    void check(const std::string& suite, const std::string& name, const OutputClaims& claims) const;

    /// Deletes the page that an earlier run left there. Throws Error.
    void forget();

    /// Deletes the pictures that an earlier run left of a case, and nothing of others'. Throws
    /// Error.
    void forget(const std::string& suite, const std::string& name);

    /// Writes DIR/SUITE/NAME-got.png and, where `record` is not null, -expected.png and
    /// -difference.png: of the kept picture, else of the thumbnails. On the page and in the
    /// difference, ignored pixels are hatched. Throws Error.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict,
             const Image& got, const BaselineRecord* record, const Image* expected,
             const IgnoredPixels& ignored = {});

    /// Adds a case of which there is no picture.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict);

    /// Ends the page, if there is one. Throws Error, also where a part of it could not be written
    /// before, and then leaves none.
    void finish();

    [[nodiscard]] bool has_cases() const { return page_ != nullptr; }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "index.html"; }

  private:
    [[nodiscard]] std::filesystem::path picture(const std::string& suite, const std::string& name,
                                                std::string_view kind) const;
    void begin();
    void write(std::string_view text);
    void write_section_head(const std::string& suite, const std::string& name,
                            const Verdict& verdict, bool pair);
    /// Writes a picture's file and shows it on the page, hatched where pixels are ignored of one of
    /// its size; `of`: the case.
    void write_picture(const Image& image, const std::filesystem::path& file, const char* kind,
                       const std::string& of, const std::string& caption,
                       const IgnoredPixels& ignored);

    std::filesystem::path folder_;
    std::optional<FolderLock> lock_;
    std::unique_ptr<AtomicFile> page_;
    bool is_torn_ = false;  ///< a part of it could not be written
};

}  // namespace fumon
