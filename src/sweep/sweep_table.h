#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fumon {

/// The rows of one run's measurements.csv and what stands before each of them.
struct TablePart {
    std::vector<std::string> cells;
    std::filesystem::path file;
};

/// Joins measurements into one tidy CSV: `names`, then the columns of all files in the order in
/// which they first occur; a cell stays empty if its file lacks the column. Holds one row at a
/// time. Throws Error if a file cannot be read or the table cannot be written.
void write_table(const std::filesystem::path& table, const std::vector<std::string>& names,
                 const std::vector<TablePart>& parts);

}  // namespace fumon
