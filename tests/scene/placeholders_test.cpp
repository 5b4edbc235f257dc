#include "scene/placeholders.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace fumon {
namespace {

std::string filled(const std::string& text) {
    return fill_placeholders(text, [](const std::string& name) -> std::optional<std::string> {
        if (name == "step") return "300";
        return std::nullopt;
    });
}

TEST(Placeholders, StandForValues) {
    EXPECT_EQ(filled("step {step}, {step}"), "step 300, 300");
    EXPECT_EQ(filled("{{step}}"), "{step}");
}

TEST(Placeholders, MarksOfRaisedAndLoweredLettersStay) {
    EXPECT_EQ(filled("x^{2} A_{s} {step}"), "x^{2} A_{s} 300");
}

TEST(Placeholders, UnknownNamesAndLoneBracesAreRefused) {
    EXPECT_THROW(filled("{stop}"), InputError);
    EXPECT_THROW(filled("a } b"), InputError);
    EXPECT_THROW(filled("x^{2"), InputError);
}

}  // namespace
}  // namespace fumon
