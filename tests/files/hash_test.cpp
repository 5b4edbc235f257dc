#include "files/hash.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

/// Two fields and a step that a test can set.
class FakeModel : public Model {
  public:
    std::vector<double> bed{0.0, 1.5, -2.0};
    std::vector<double> water{3.25};
    std::int64_t steps = 258;
    [[nodiscard]] std::string_view name() const override { return "fake"; }
    void step() override { ++steps; }
    [[nodiscard]] std::int64_t steps_done() const override { return steps; }
    [[nodiscard]] Snapshot snapshot() const override { return {}; }
    [[nodiscard]] std::vector<StateField> state() const override {
        return {{"bed", bed}, {"water", water}};
    }
    void serialise(StateArchive&) override {}
};

// FIPS 180-2, appendix B.1: the message "abc".
TEST(Hash, FileHashMatchesThePublishedVector) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(hex(file_hash(folder.file("abc", "abc"))),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hex(file_hash(folder.file("empty", ""))),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    // Appendix B.3: one million times "a".
    EXPECT_EQ(hex(file_hash(folder.file("million", std::string(1'000'000, 'a')))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Hash, FileHashRefusesAMissingFile) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(test::message_of<InputError>([&] { file_hash(folder / "none"); }),
              (folder / "none").string() +
                  ": cannot be read: No such file or directory; name a file that exists and that "
                  "you may read");
}

// The expected bytes are spelled out in a file, whose hash is checked above.
TEST(Hash, PixelHashCoversSizeAndPixels) {
    const test::TemporaryFolder folder;
    Image image(2, 1);
    image.rgb = {1, 2, 3, 4, 5, 255};
    const std::string bytes("\x02\0\0\0\x01\0\0\0\x01\x02\x03\x04\x05\xFF", 14);
    EXPECT_EQ(pixel_hash(image), file_hash(folder.file("pixels", bytes)));
    Image turned(1, 2);
    turned.rgb = image.rgb;
    EXPECT_NE(pixel_hash(turned), pixel_hash(image));
}

TEST(Hash, StateHashCoversNameStepAndFieldsInOrder) {
    const test::TemporaryFolder folder;
    const std::string bytes(
        "fake"
        "\x02\x01\0\0\0\0\0\0"   // 258
        "\0\0\0\0\0\0\0\0"       // 0.0
        "\0\0\0\0\0\0\xF8\x3F"   // 1.5
        "\0\0\0\0\0\0\0\xC0"     // -2.0
        "\0\0\0\0\0\0\x0A\x40",  // 3.25
        44);
    FakeModel model;
    EXPECT_EQ(state_hash(model), file_hash(folder.file("state", bytes)));
    model.step();
    EXPECT_NE(state_hash(model), file_hash(folder / "state"));
    model.steps = 258;
    model.water[0] = -0.0;
    const Sha256 negative = state_hash(model);
    model.water[0] = 0.0;
    EXPECT_NE(state_hash(model), negative) << "the two zeros are different states";
}

}  // namespace
}  // namespace fumon
