#include <gtest/gtest.h>

#include "support/verify_folder.h"

namespace fumon::test {
namespace {

constexpr const char* described =
    "[environment.here]\ndriver = \"llvmpipe\"\n[environment.card]\ndrawer = \"gpu\"\n";

class VerifyEnvironments : public ::testing::Test, public VerifyFolder {
  protected:
    /// `light` is the sun's azimuth in degrees.
    void write(const char* environments, const char* light) const {
        write_baseline("b.toml", "one = {picture = true}\n",
                       std::string("environments = ") + environments +
                           "\nsettings = [\"sun.azimuth=" + light + "\"]\n" + described);
    }
};

TEST_F(VerifyEnvironments, WhereOneIsKnownItsPictureIsHeldStrictly) {
    write("[\"card\", \"here\"]", "200");
    ASSERT_EQ(verify({"b.toml", "--update"}).status, 0);
    EXPECT_FALSE(contains(text("b.lock"), "one@here"));
    const Ended own = verify({"b.toml", "--update", "--this-environment"});
    EXPECT_EQ(own.output, "new      b one: one@here: recorded; look at it before you keep it\n")
        << own.errors;
    EXPECT_TRUE(contains(text("b.lock"), "[recorded.\"one@here\"]"));
    EXPECT_TRUE(contains(text("b.lock"), "[recorded.one]"));
    EXPECT_TRUE(has("b/one@here.png") && has("b/one.png"));
    EXPECT_EQ(verify({"b.toml"}).output,
              "ok       b one: strict, environment here: state and pixels as recorded\n"
              "1 of 1 as recorded\n");

    write("[\"card\", \"here\"]", "200.02");
    const Ended strict = verify({"b.toml"});
    EXPECT_EQ(strict.status, 1);
    EXPECT_TRUE(contains(strict.output, "DIFFERS  b one: strict, environment here: "))
        << strict.output;
    const Ended again = verify({"b.toml", "--update"});
    EXPECT_TRUE(contains(again.output, "changed  b one: one@here: the pixels change"))
        << "what is compared here is renewed: " << again.output;
    EXPECT_EQ(verify({"b.toml"}).status, 0);
}

TEST_F(VerifyEnvironments, ElsewhereItIsTolerant) {
    write("[\"card\"]", "200");
    ASSERT_EQ(verify({"b.toml", "--update"}).status, 0);
    write("[\"card\"]", "200.02");
    const Ended elsewhere = verify({"b.toml"});
    EXPECT_EQ(elsewhere.status, 0) << elsewhere.output;
    EXPECT_TRUE(contains(elsewhere.output, "ok       b one: portable (")) << elsewhere.output;
    EXPECT_TRUE(contains(elsewhere.output, "), in no known environment: ")) << elsewhere.output;
    const Ended refused = verify({"b.toml", "--update", "--this-environment"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(contains(refused.output, "cases.one names no environment that matches this one ("))
        << refused.output;
    EXPECT_EQ(verify({"b.toml", "--this-environment"}).status, 2);
}

}  // namespace
}  // namespace fumon::test
