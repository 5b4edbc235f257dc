#include "film/contact_sheet.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(ContactSheet, HasAPictureOfEverySecondAndTheLast) {
    EXPECT_EQ(ContactSheet(7, 3.0, 64, 48).frames(), (std::vector<std::int64_t>{0, 3, 6}));
    ContactSheet sheet(20, 3.0, 64, 48);
    EXPECT_EQ(sheet.frames(), (std::vector<std::int64_t>{0, 3, 6, 9, 12, 15, 18, 19}));
    EXPECT_TRUE(sheet.shows(15));
    EXPECT_FALSE(sheet.shows(16));
    EXPECT_EQ(sheet.image().width, 5 * 64 + 4 * 4);
    EXPECT_EQ(sheet.image().height, 2 * 48 + 4);
    Image white(64, 48);
    white.rgb.assign(white.rgb.size(), 255);
    sheet.add(18, white);  // the second of the second row
    EXPECT_EQ(sheet.image().row(52)[3 * 68], 255);
    EXPECT_EQ(sheet.image().row(52)[3 * 67], 0);
    EXPECT_EQ(sheet.image().row(51)[3 * 68], 0);
    EXPECT_EQ(ContactSheet(1, 3.0, 1920, 1080).image().width, 480);
}

}  // namespace
}  // namespace fumon
