#include "published/sweep_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/program.h"

namespace fumon::test {

namespace {

std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells;
    std::string cell;
    std::istringstream text(line);
    while (std::getline(text, cell, ',')) cells.push_back(cell);
    if (!line.empty() && line.back() == ',') cells.emplace_back();
    return cells;
}

double number_of(const std::string& cell) {
    char* end = nullptr;
    const double number = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end != '\0' ? std::numeric_limits<double>::quiet_NaN() : number;
}

std::vector<SweepTable::Row> read_table(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = split_cells(line);
    std::vector<SweepTable::Row> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = split_cells(line);
        EXPECT_EQ(cells.size(), names.size()) << line;
        SweepTable::Row row;
        for (std::size_t k = 0; k < std::min(cells.size(), names.size()); ++k)
            row[names[k]] = number_of(cells[k]);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

SweepTable::SweepTable(const Order& order) {
    const ScratchFolder folder;
    std::vector<std::string> arguments{
        "sweep",
        (std::filesystem::path(FUMON_SCENES_FOLDER) / order.scene).string(),
        "-o",
        (folder / "sweep").string(),
        "-q",
        "--threads",
        "2",
        "--seeds",
        std::to_string(order.seeds)};
    for (const std::string& over : order.over) {
        arguments.emplace_back("--over");
        arguments.push_back(over);
    }
    for (const std::string& setting : order.settings) {
        arguments.emplace_back("--set");
        arguments.push_back(setting);
    }
    const Ended ended = fumon(arguments, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
    rows_ = read_table(folder / "sweep" / "sweep.csv");
    EXPECT_FALSE(rows_.empty());
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "sweep" / "runs")) {
        if (entry.path().string().ends_with("avalanches.csv")) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        std::vector<long long> sizes;
        for (const Row& row : read_table(file)) sizes.push_back(std::llround(row.at("size")));
        sizes_.push_back(std::move(sizes));
    }
}

double SweepTable::mean(const std::string& column, const Where& where) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Row& row : rows_) {
        if (!where(row)) continue;
        const auto cell = row.find(column);
        if (cell == row.end()) {
            ADD_FAILURE() << "there is no column " << column;
            return std::numeric_limits<double>::quiet_NaN();
        }
        sum += cell->second;
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

void expect_within(double found, double expected, double share, const std::string& what) {
    EXPECT_NEAR(found, expected, share * std::abs(expected)) << what;
    std::printf("    %-60s %10.4g  published %10.4g  (%+.1f %%)\n", what.c_str(), found, expected,
                100.0 * (found / expected - 1.0));
}

FittedLine line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mx = 0.0;
    double my = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        mx += x[k] / n;
        my += y[k] / n;
    }
    double sxx = 0.0;
    double sxy = 0.0;
    double syy = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sxx += (x[k] - mx) * (x[k] - mx);
        sxy += (x[k] - mx) * (y[k] - my);
        syy += (y[k] - my) * (y[k] - my);
    }
    return {my - sxy / sxx * mx, sxy / sxx, sxy * sxy / (sxx * syy)};
}

}  // namespace fumon::test
