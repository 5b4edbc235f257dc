#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "foreign/foreign_layouts.h"
#include "support/program.h"

namespace fumon::test {

inline constexpr const char* film_of_dates =
    "[film]\nwidth = 240\nheight = 180\nrate = 5\nsupersampling = 1\n"
    "[[shot]]\nseconds = 1\nfrom = \"start\"\nto = \"end\"\nmove = \"orbit\"\nturn = 20\n"
    "[[overlay]]\nkind = \"time\"\n";

/// A flood as SFINCS writes it, flood.nc, and a film that shows its dates, film.toml.
class ForeignFilm : public ::testing::Test {
  protected:
    void SetUp() override {
        write_sfincs(folder_ / "flood.nc");
        write_text(folder_ / "film.toml", film_of_dates);
    }
    Ended run(const std::vector<std::string>& arguments) {
        return fumon(arguments, folder_.path());
    }
    ScratchFolder folder_;
};

}  // namespace fumon::test
