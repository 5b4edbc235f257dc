// What counts in a grid's hash beside its own bytes.

#include "files/terrain/grid_hash.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/hash.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class GridHash : public ::testing::Test {
  protected:
    [[nodiscard]] std::vector<std::string> roles(const fs::path& grid) const {
        std::vector<std::string> names;
        for (const GridPart& part : grid_parts(grid)) names.push_back(part.role);
        return names;
    }
    TemporaryFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(GridHash, OfAFileAloneIsThatOfItsBytes) {
    const fs::path grid = folder_.file("dem.tif", "II*");
    folder_.file("other.tif.msk", "a mask");
    folder_.file("dem.tif.ovr", "overviews change no height");
    folder_.file("dem.prj", "GDAL reads none beside a GeoTIFF");
    EXPECT_EQ(grid_hash(grid), file_hash(grid));
    const fs::path netcdf = folder_.file("dem.nc", "CDF");
    EXPECT_EQ(grid_hash(netcdf), file_hash(netcdf)) << "dem.prj is not its";
    EXPECT_TRUE(has_grid_hash(netcdf, hex(file_hash(netcdf))));
    EXPECT_FALSE(has_grid_hash(folder_ / "none.tif", hex(file_hash(netcdf))));
}

TEST_F(GridHash, CountsMasksSystemsHeadersAndWorldFiles) {
    const fs::path tiff = folder_.file("dem.tif", "II*");
    const Sha256 alone = grid_hash(tiff);
    folder_.file("dem.tif.msk", "a mask");
    const Sha256 masked = grid_hash(tiff);
    EXPECT_NE(masked, alone);
    EXPECT_EQ(hex(masked),
              hex(text_hash("\n" + hex(alone) + "\n.tif.msk\n" + hex(text_hash("a mask")) + "\n")));
    folder_.file("dem.tif.msk", "another");
    EXPECT_NE(grid_hash(tiff), masked);
    folder_.file("dem.TFW", "10\n0\n0\n-10\n5\n5\n");
    EXPECT_EQ(roles(tiff), (Names{".tfw", ".tif.msk"}));
    const fs::path esri = folder_.file("dem.asc", "ncols 1");
    folder_.file("dem.prj", "PROJCS[]");
    EXPECT_EQ(roles(esri), (Names{".prj"}));
    folder_.file("raw.flt", "....");
    folder_.file("raw.hdr", "nrows 1");
    folder_.file("raw.aux", "\\relax of LaTeX");
    EXPECT_EQ(roles(folder_ / "raw.flt"), (Names{".hdr"}));
}

TEST_F(GridHash, LeavesStatisticsOut) {
    const fs::path grid = folder_.file("dem.tif", "II*");
    const std::string open = "<PAMDataset>\n  <PAMRasterBand band=\"1\">\n";
    const std::string statistics =
        "    <Histograms>\n <HistItem> <HistMin>1</HistMin> </HistItem>\n    </Histograms>\n"
        "    <Metadata>\n      <MDI key=\"STATISTICS_MAXIMUM\">7</MDI>\n"
        "      <MDI key=\"STATISTICS_MEAN\">7</MDI>\n    </Metadata>\n";
    const std::string nodata = "    <NoDataValue>7</NoDataValue>\n";
    const std::string close = "  </PAMRasterBand>\n</PAMDataset>\n";
    folder_.file("dem.tif.aux.xml", open + statistics + close);
    EXPECT_EQ(roles(grid), Names{}) << "as QGIS writes them when it opens a grid";
    EXPECT_EQ(grid_hash(grid), file_hash(grid));
    folder_.file("dem.tif.aux.xml", open + nodata + close);
    const Sha256 with_nodata = grid_hash(grid);
    EXPECT_NE(with_nodata, file_hash(grid));
    folder_.file("dem.tif.aux.xml", open + nodata + statistics + close);
    EXPECT_EQ(grid_hash(grid), with_nodata);
    folder_.file("dem.tif.aux.xml", open + "    <NoDataValue>8</NoDataValue>\n" + close);
    EXPECT_NE(grid_hash(grid), with_nodata);
}

TEST_F(GridHash, CountsWhatAVrtNames) {
    const auto vrt = [&](const std::string& name, const std::string& source) {
        return folder_.file(name, "<VRTDataset><SourceFilename relativeToVRT=\"1\">" + source +
                                      "</SourceFilename></VRTDataset>");
    };
    folder_.file("a&b.tif", "II*");
    const fs::path inner = vrt("inner.vrt", "a&amp;b.tif");
    const fs::path outer = vrt("outer.vrt", inner.string());
    EXPECT_EQ(roles(inner), (Names{"\ta&b.tif"}));
    const Sha256 before = grid_hash(outer);
    folder_.file("a&b.tif.msk", "a mask");
    EXPECT_NE(grid_hash(outer), before);
    const fs::path itself = vrt("itself.vrt", "itself.vrt");
    EXPECT_LE(grid_parts(itself).size(), 5U) << "it ends";
    EXPECT_EQ(roles(vrt("far.vrt", "/vsicurl/http://localhost/a.tif")), Names{});
}

}  // namespace
}  // namespace fumon::test
