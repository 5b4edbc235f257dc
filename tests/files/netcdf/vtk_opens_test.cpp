// fields.nc in VTK's reader of CF files, as ParaView opens it.

#include <gtest/gtest.h>

#include <string>

#include "files/netcdf/netcdf_fields.h"
#include "support/air_snapshots.h"
#include "support/command.h"
#include "support/netcdf_records.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

/// Prints the bounds, times and arrays of a file's grid over some dimensions.
constexpr const char* reader = R"(
import sys
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
reader = vtkNetCDFCFReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
reader.SetDimensions(sys.argv[2])
reader.UpdateInformation()
times = Pipeline.TIME_STEPS()
information = reader.GetOutputInformation(0)
print([information.Get(times, i) for i in range(information.Length(times))])
reader.Update()
grid = reader.GetOutputDataObject(0)
print([round(bound, 9) for bound in grid.GetBounds()])
arrays = grid.GetPointData()
print(sorted(arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())))
)";

std::string seen_by_vtk(const test::TemporaryFolder& folder, const std::string& dimensions) {
    const auto script = folder.file("reader.py", reader);
    return test::run_command("/usr/bin/python3 " + script.string() + " " +
                             (folder / "fields.nc").string() + " '" + dimensions + "' 2>&1")
        .words;
}

bool has_vtk() {
    return std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIONetCDF' > /dev/null 2>&1") == 0;
}

TEST(VtkOpens, FieldsFlatAndWithTheirTimes) {
    if (!has_vtk()) GTEST_SKIP() << "/usr/bin/python3 has no vtkmodules here (python3-vtk9)";
    const test::TemporaryFolder folder;
    test::write_records(folder / "fields.nc", 3);
    EXPECT_EQ(seen_by_vtk(folder, "(y, x)"),
              "[0.0, 5.0, 10.0]\n[1.0, 13.0, 1.5, 13.5, 0.0, 0.0]\n"
              "['bed_height', 'last_avalanche', 'water_depth']\n");
}

TEST(VtkOpens, ASectionOfAir) {
    if (!has_vtk()) GTEST_SKIP() << "/usr/bin/python3 has no vtkmodules here (python3-vtk9)";
    const test::TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", test::air_snapshot(0, test::section(0)), test::air_text);
    for (const std::int64_t step : {0, 4}) file.add(test::air_snapshot(step, test::section(step)));
    file.commit();
    const std::string seen = seen_by_vtk(folder, "(z, section_x)");
    EXPECT_NE(seen.find("[0.0, 1.0, 0.0, 0.375, 0.0, 0.0]\n['pressure', 'velocity_x']\n"),
              std::string::npos)
        << seen;
    EXPECT_EQ(seen_by_vtk(folder, "(y, x)").find("nan"), std::string::npos);
}

}  // namespace
}  // namespace fumon
