#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/avalanche.h"
#include "files/appended_file.h"
#include "files/text_source.h"

namespace fumon {

/// The first line of avalanches.csv; each further line is one avalanche, as struct Avalanche has
/// it.
inline constexpr std::string_view avalanche_table_header = "grain,size,duration,topplings,lost";

/// Writes avalanches.csv while a run goes on, however long: at most 64 KiB of rows are held back.
/// The file gets its name by commit().
class AvalancheFile {
  public:
    /// Throws Error when it cannot be made.
    explicit AvalancheFile(const std::filesystem::path& file);
    /// Goes on with a former one, as AppendedFile does.
    AvalancheFile(const std::filesystem::path& file, const FileBeginning& previous);
    void add(std::span<const Avalanche> avalanches);  ///< throws Error on a full disk
    /// Puts all rows on disk. Throws Error on failure.
    [[nodiscard]] FileBeginning sync();
    void commit();  ///< throws Error on failure

  private:
    AppendedFile file_;
    std::string rows_;  ///< not written yet
};

/// Reads such a table: whole numbers of at most 10^15, lost at least 0 and the rest at least 1, in
/// any order of rows. Lines end in LF, CRLF or CR; blanks beside a number, a UTF-8 byte order mark
/// and blank lines at the end are passed over. Throws InputError "file:line:column: what is wrong;
/// what would be right" for another header, a blank line between rows, a row without exactly five
/// numbers and a number that is none of these.
std::vector<Avalanche> parse_avalanches(const TextSource& source);

/// A file, read by `parse_avalanches`. Throws InputError also where it cannot be read.
std::vector<Avalanche> read_avalanches(const std::filesystem::path& file);

}  // namespace fumon
