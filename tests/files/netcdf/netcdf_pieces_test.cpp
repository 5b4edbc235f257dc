#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "support/air_snapshots.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::air_snapshot;
using test::air_text;
using test::bytes_of;
using test::message_of;
using test::section;
using test::TemporaryFolder;

FieldsFile new_file(const TemporaryFolder& folder) {
    return {folder / "on.nc", air_snapshot(0, section(0)), air_text};
}

FieldsFile gone_on_with(const TemporaryFolder& folder, const FieldsBeginning& previous) {
    return {folder / "on.nc", air_snapshot(0, section(0)), air_text, previous};
}

void add_records(FieldsFile& file, std::int64_t from, std::int64_t to) {
    for (std::int64_t step = from; step < to; ++step) file.add(air_snapshot(step, section(step)));
}

std::string bytes_in_one_go(std::int64_t records) {
    const TemporaryFolder folder;
    FieldsFile file = new_file(folder);
    add_records(file, 0, records);
    file.commit();
    return bytes_of(folder / "on.nc");
}

/// The first records, as a checkpoint has them.
FieldsBeginning beginning_of(std::int64_t records) {
    const TemporaryFolder folder;
    FieldsFile file = new_file(folder);
    add_records(file, 0, records);
    return file.sync();
}

TEST(NetcdfPieces, AFileInPiecesGetsTheBytesOfOneInOneGo) {
    const TemporaryFolder folder;
    FieldsFile file = new_file(folder);
    for (const std::int64_t step : {0, 1, 3}) {
        add_records(file, step, step == 0 ? 1 : 2 * step + 1);
        EXPECT_EQ(file.sync().records, file.records());
        EXPECT_EQ(file.sync().hash, beginning_of(file.records()).hash);
    }
    file.commit();
    EXPECT_TRUE(bytes_of(folder / "on.nc") == bytes_in_one_go(7));
    EXPECT_EQ(folder.entries(), 1);
}

/// Leaves six records, the first four of them in two pieces, that were broken off or committed.
void leave_pieces(const TemporaryFolder& folder, bool committed) {
    FieldsFile file = new_file(folder);
    add_records(file, 0, 3);
    EXPECT_EQ(file.sync().records, 3);
    add_records(file, 3, 4);
    EXPECT_EQ(file.sync().records, 4);
    add_records(file, 4, 6);
    if (committed) file.commit();
}

TEST(NetcdfPieces, AFileThatIsGoneOnWithGetsTheBytesOfOneInOneGo) {
    const std::string bytes = bytes_in_one_go(6);
    for (const bool committed : {false, true}) {
        for (const std::int64_t kept : {1, 3, 4, 6}) {
            if (kept == 6 && !committed) continue;
            const TemporaryFolder folder;
            leave_pieces(folder, committed);
            const FieldsBeginning previous = beginning_of(kept);
            EXPECT_EQ(difference(folder / "on.nc", air_snapshot(0, section(0)), previous).what, "");
            FieldsFile file = gone_on_with(folder, previous);
            EXPECT_EQ(file.records(), kept);
            EXPECT_EQ(file.sync().hash, previous.hash);
            add_records(file, kept, 6);
            file.commit();
            EXPECT_TRUE(bytes_of(folder / "on.nc") == bytes) << kept << committed;
            EXPECT_EQ(folder.entries(), 1);
        }
    }
}

TEST(NetcdfPieces, APieceIsNeverWrittenToAgain) {
    const TemporaryFolder folder;
    FieldsFile file = new_file(folder);
    add_records(file, 0, 3);
    EXPECT_EQ(file.sync().records, 3);
    const std::string piece = bytes_of(folder / "on.nc.000001");
    add_records(file, 3, 5);
    EXPECT_EQ(file.sync().records, 5);
    EXPECT_TRUE(bytes_of(folder / "on.nc.000001") == piece);
    EXPECT_EQ(folder.entries(), 2) << "and another piece is not begun before its first record";
}

TEST(NetcdfPieces, WhatCannotBeGoneOnWithIsRefusedAndStays) {
    const TemporaryFolder folder;
    const auto expect_refusal = [&](const FieldsBeginning& previous, const std::string& name,
                                    const std::string& why) {
        const auto [file, what] =
            difference(folder / "on.nc", air_snapshot(0, section(0)), previous);
        EXPECT_EQ(file, folder / name);
        EXPECT_TRUE(what.starts_with(why)) << what;
        const std::string line = message_of<InputError>([&] { gone_on_with(folder, previous); });
        EXPECT_NE(line.find(name + ": cannot be continued: it " + why), std::string::npos) << line;
    };
    expect_refusal(beginning_of(1), "on.nc.000001", "does not exist");
    leave_pieces(folder, false);
    expect_refusal(beginning_of(5), "on.nc.000003", "does not exist");
    FieldsBeginning other = beginning_of(4);
    other.hash[0] ^= 1;
    expect_refusal(other, "on.nc.000002", "or one of the 1 pieces before it has changed");
    other = beginning_of(2);
    other.hash[0] ^= 1;
    expect_refusal(other, "on.nc.000001", "has changed since it was written");
    EXPECT_EQ(folder.entries(), 2);
    folder.file("on.nc.000002", "no NetCDF");
    expect_refusal(beginning_of(4), "on.nc.000002", "cannot be read: ");
    EXPECT_EQ(bytes_of(folder / "on.nc.000002"), "no NetCDF");
    leave_pieces(folder, true);
    expect_refusal(beginning_of(7), "on.nc", "has 6 records of 7");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(NetcdfPieces, PiecesAreToldFromOtherFiles) {
    EXPECT_EQ(number_of_fields_piece("on.nc.000012", "on.nc"), 12);
    for (const char* other : {"on.nc", "on.nc.", "on.nc.12", "on.nc.part", "on.nc.000000",
                              "on.nc.00001x", "no.nc.000001", "on.nc.000001.part"})
        EXPECT_EQ(number_of_fields_piece(other, "on.nc"), 0) << other;
}

}  // namespace
}  // namespace fumon
