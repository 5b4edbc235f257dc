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

/// Joins measurements to one tidy CSV: `names`, then the columns of all files in the order in which
/// they first come up; a cell that a file has no column for stays empty. One row is held at a time.
/// Throws Error when a file cannot be read or the table not be written.
void write_table(const std::filesystem::path& table, const std::vector<std::string>& names,
                 const std::vector<TablePart>& parts);

}  // namespace fumon
