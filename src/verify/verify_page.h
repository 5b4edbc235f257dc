#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "files/atomic_file.h"
#include "files/folder_lock.h"
#include "outputs/output_claims.h"
#include "picture/baseline_records.h"
#include "picture/verdict.h"
#include "verify/page_pictures.h"

namespace fumon {

/// The folder of cases that did not pass: their pictures, and index.html, a self-contained page
/// that shows them side by side and in turns. Created with the first case that is added; memory
/// grows with their number by the text alone, so that a page of texts can be written where there is
/// no room for the pictures.
class VerifyPage {
  public:
    /// Locks the folder if it is there; "": a new one among the system's temporary files. Throws
    /// InputError where the claims forbid the page or another program is working there.
    VerifyPage(std::filesystem::path folder, const OutputClaims& claims);

    /// Throws as OutputClaims::check() where the pictures of a case may not be written.
    void check(const std::string& suite, const std::string& name, const OutputClaims& claims) const;

    /// Deletes the page that an earlier run left there. Throws Error.
    void remove_old();

    /// Deletes the pictures that an earlier run left of a case, and nothing of others'. Throws
    /// Error.
    void remove_old(const std::string& suite, const std::string& name);

    /// Writes page_pictures() as DIR/SUITE/NAME-KIND.png and shows them. Throws Error.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict,
             const Image& got, const BaselineRecord* record, const Image* expected,
             const IgnoredPixels& ignored = {});

    /// Likewise; `command`, unless empty, is what accepts the picture. Where the pictures cannot be
    /// written, the case is on the page without them, and Error is thrown.
    void add(const std::string& suite, const std::string& name, const Verdict& verdict,
             const std::vector<PagePicture>& pictures, const std::string& command);

    /// Writes a text beside the pictures of a case that was added, DIR/SUITE/NAME-got.lock: the
    /// record of its new picture. Throws Error.
    void add_record(const std::string& suite, const std::string& name, std::string_view text);

    /// Ends the page, if there is one; where there is no room for it, without its pictures, whose
    /// files go too. Throws Error where there is no room for that either, and then leaves none.
    void finish();

    /// Makes room: takes back the pictures that were written, here and on the page.
    void drop_pictures();

    /// Whether a file lies, or will lie, on the same disk as the pictures.
    [[nodiscard]] bool shares_disk_with(const std::filesystem::path& file) const;

    [[nodiscard]] bool has_cases() const { return !texts_.empty(); }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "index.html"; }
    /// "" where it is a temporary one that is not made yet.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// Makes the folder, if it is not there yet. Throws Error.
    void begin();

  private:
    [[nodiscard]] std::filesystem::path file_of(const std::string& suite, const std::string& name,
                                                std::string_view kind) const;
    /// Every file that a case may have.
    [[nodiscard]] std::vector<std::filesystem::path> files_of(const std::string& suite,
                                                              const std::string& name) const;
    void write(std::string_view text);
    void write_beside(const std::filesystem::path& file, std::string_view bytes);

    std::filesystem::path folder_;
    std::optional<FolderLock> lock_;
    std::unique_ptr<AtomicFile> page_;
    std::string texts_;                          ///< its cases without pictures
    std::vector<std::filesystem::path> beside_;  ///< what was written of the cases
    bool is_torn_ = false;                       ///< a part of it could not be written
};

}  // namespace fumon
