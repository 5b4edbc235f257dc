#include "picture/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/png_reader.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

LayeredImage layered(int width, int height) {
    LayeredImage image;
    image.width = width;
    image.height = height;
    const auto add = [&](const char* name, const char* unit, bool half) {
        ImageLayer layer{name, unit, half, {}};
        for (int i = 0; i < width * height; ++i)
            layer.values.push_back(0.1F * static_cast<float>(i + static_cast<int>(name[0])));
        image.layers.push_back(layer);
    };
    add("R", "", true);
    add("G", "", true);
    add("B", "", true);
    add("Z", "m", false);
    add("field.water_depth", "m", false);
    image.layers[3].values[0] = std::numeric_limits<float>::infinity();
    image.layers[4].values[1] = std::numeric_limits<float>::quiet_NaN();
    image.world_to_camera[14] = 7.5F;
    return image;
}

TEST(Exr, TheLibraryReadsWhatIsWritten) {
    const TemporaryFolder folder;
    const LayeredImage image = layered(37, 150);  // of several bands of rows
    const PictureText texts{{"Software", "fumon"}, {"fumon:scene", "title = \"風紋\"\n"}};
    const std::vector<std::uint8_t> bytes = encode_exr(image, 300.0, texts);
    EXPECT_EQ(bytes, encode_exr(image, 300.0, texts));
    write_file(folder / "a.exr", bytes);

    Imf::InputFile file((folder / "a.exr").string().c_str());
    const Imf::Header& header = file.header();
    EXPECT_EQ(Imf::xDensity(header), 300.0F);
    EXPECT_EQ(Imf::worldToCamera(header)[3][2], 7.5F);
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("fumon:units").value(),
              "Z: m\nfield.water_depth: m\n");
    int channels = 0;
    for (auto one = header.channels().begin(); one != header.channels().end(); ++one) ++channels;
    EXPECT_EQ(channels, 5);
    for (const ImageLayer& layer : image.layers) {
        const Imf::Channel* channel = header.channels().findChannel(layer.name);
        ASSERT_NE(channel, nullptr) << layer.name;
        EXPECT_EQ(channel->type, layer.half ? Imf::HALF : Imf::FLOAT) << layer.name;
        std::vector<float> values(layer.values.size());
        Imf::FrameBuffer buffer;
        buffer.insert(layer.name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
        file.setFrameBuffer(buffer);
        file.readPixels(0, image.height - 1);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const float wanted = layer.values[i];
            if (std::isnan(wanted)) {
                ASSERT_TRUE(std::isnan(values[i]));
            } else if (layer.half) {
                ASSERT_NEAR(values[i], wanted, wanted / 2048.0F);
            } else {
                ASSERT_EQ(values[i], wanted);
            }
        }
    }
}

TEST(Exr, GivesItsTextsBack) {
    const TemporaryFolder folder;
    const PictureText texts{{"Software", "fumon"}, {"fumon:scene", std::string(5000, 'x')}};
    write_file(folder / "a.exr", encode_exr(layered(20, 20), 96.0, texts));
    const PictureText read = read_exr_texts(folder / "a.exr");
    for (const auto& text : texts) EXPECT_NE(std::ranges::find(read, text), read.end());
}

TEST(Exr, RefusesWhatIsNoneOrDamaged) {
    const TemporaryFolder folder;
    write_file(folder / "none.exr", std::string_view("a text"));
    EXPECT_EQ(message_of<InputError>([&] { read_exr_texts(folder / "none.exr"); }),
              (folder / "none.exr").string() + ": is not an OpenEXR file");
    const std::vector<std::uint8_t> bytes = encode_exr(layered(20, 20), 96.0, {});
    write_file(folder / "cut.exr", std::span(bytes).first(100));
    EXPECT_NE(message_of<InputError>([&] {
                  read_exr_texts(folder / "cut.exr");
              }).find("is a damaged OpenEXR file"),
              std::string::npos);
}

TEST(Exr, ItsHashTellsLayersApart) {
    const LayeredImage image = layered(20, 20);
    LayeredImage other = image;
    other.layers[4].values[7] += 1e-5F;
    EXPECT_NE(layers_hash(image), layers_hash(other));
    other = image;
    other.layers[0].values[7] *= 1.0F + 1e-6F;  // which its 16 bits do not tell
    EXPECT_EQ(layers_hash(image), layers_hash(other));
    other.layers[0].name = "S";
    EXPECT_NE(layers_hash(image), layers_hash(other));
}

TEST(Png, SixteenBitsAreStoredWithTheirOpacities) {
    const TemporaryFolder folder;
    for (const bool open : {false, true}) {
        Image image(23, 11);
        if (open) image = with_alpha(std::move(image));
        for (std::size_t i = 0; i < image.rgb.size(); ++i) {
            image.rgb16.push_back(static_cast<std::uint16_t>(977 * i));
            image.rgb[i] = rounded_to_8(image.rgb16[i]);
        }
        if (open) image.alpha[5] = 17;
        write_file(folder / "a.png", encode_png(image, 96.0, {{"Software", "fumon"}}));
        const std::string bytes = read_input_file(folder / "a.png");
        const std::vector<std::uint8_t> samples = PngReader(bytes, "a.png").samples();
        const std::size_t channels = open ? 4 : 3;
        for (std::size_t i = 0; i < image.rgb16.size(); ++i) {
            const std::size_t at = 2 * (channels * (i / 3) + i % 3);
            ASSERT_EQ(256 * samples[at] + samples[at + 1], image.rgb16[i]);
        }
        Image rounded = read_png(folder / "a.png");
        rounded.rgb16 = image.rgb16;
        EXPECT_EQ(rounded, image);
    }
}

}  // namespace
}  // namespace fumon
