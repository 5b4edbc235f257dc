#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace fumon::test {

inline std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// The cells of a table, its comments left out.
inline std::vector<std::vector<std::string>> cells_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#')) continue;
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
        rows.push_back(std::move(cells));
    }
    return rows;
}

inline const std::string curves = R"(
[sweep]
over = ["model.hop_base=1,2,3"]
seeds = 2
[figure]
width = "single"
columns = 1
dots_per_inch = 60
caption = "What is tested."
[[figure.panel]]
title = "over time"
[[figure.panel.curve]]
name = "L0 = {model.hop_base}"
x = "step"
y = "standard_deviation"
group_by = "model.hop_base"
spread = "deviation"
[[figure.panel]]
title = "at the end"
[[figure.panel.curve]]
x = "model.hop_base"
y = "standard_deviation"
where = ["step=20"]
fit = "line"
[[figure.panel.box]]
label = "elsewhere"
source = "Somebody 1999"
x_low = 1.5
x_high = 2.5
y_low = 0.1
y_high = 0.2
)";

inline const std::string pictures = R"(
[figure]
width = "double"
columns = 3
dots_per_inch = 60
[[figure.panel]]
kind = "map"
title = "step {step}"
steps = [5, 20]
[[figure.panel]]
kind = "view"
title = "creep {model.creep_rate}"
steps = [20]
)";

/// `fumon figure` of a small scene.
class FigureTest : public ::testing::Test {
  protected:
    Ended figure(const std::string& scene, const std::vector<std::string>& more = {},
                 const std::string& output = "out") {
        std::vector<std::string> arguments{"figure", scene, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    }

    void write_scene(const std::string& name, const std::string& more) const {
        write_text(folder_ / name, small_scene() + more);
    }

    [[nodiscard]] std::string text(const std::string& name) const {
        return read_text(folder_ / name);
    }

    [[nodiscard]] std::vector<std::string> runs(const std::string& output = "out/runs") const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / output))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    ScratchFolder folder_;
};

}  // namespace fumon::test
