#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "keys/key_value.h"
#include "picture/fingerprint.h"
#include "picture/fingerprint_text.h"
#include "picture/stills/picture_file.h"
#include "scene/json.h"

namespace fumon {

namespace {

struct FingerprintOptions {
    std::vector<std::string> images;
    bool as_json = false;
};

void declare(CLI::App& command, FingerprintOptions& options) {
    command.add_option("IMAGE", options.images, "PNG, JPEG, WebP or TIFF files")->required();
    command.add_flag("--json", options.as_json, "as JSON");
    add_examples(
        command,
        {{"fumon fingerprint dunes.png", ""}, {"fumon fingerprint a.png b.png --json", ""}},
        "size     width and height, pixels\n"
        "pixels   SHA-256 of the pixels (8 bits a channel, alpha too), as run.json has it\n"
        "dhash    64-bit difference hash: a label, blind to light and shading\n"
        "red, green, blue   32 x 18 mean levels of boxes of the picture, to a tenth");
}

using Json = nlohmann::ordered_json;

Json thumbnail_json(const Thumbnail& thumbnail) {
    Json rows = Json::array();
    for (int y = 0; y < Thumbnail::height; ++y) {
        Json row = Json::array();
        for (int x = 0; x < Thumbnail::width; ++x) {
            row.push_back({thumbnail.at(x, y, 0), thumbnail.at(x, y, 1), thumbnail.at(x, y, 2)});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Json fingerprint_json(const std::string& file, const Fingerprint& fingerprint) {
    Json json;
    json["file"] = file;
    json["width"] = fingerprint.width;
    json["height"] = fingerprint.height;
    json["pixels_sha256"] = hex(fingerprint.pixels);
    json["dhash"] = dhash_text(fingerprint.difference_hash);
    json["thumbnail"] = thumbnail_json(fingerprint.thumbnail);
    return json;
}

int perform(const FingerprintOptions& options) {
    Json all = Json::array();
    std::string text;
    for (std::string file : options.images) {
        const Fingerprint fingerprint = fingerprint_of(read_picture(file));
        if (options.as_json) {
            all.push_back(fingerprint_json(file, fingerprint));
            continue;
        }
        if (!text.empty()) text += '\n';
        const Key name{"", {}, &file};
        text += fmt::format("[{}]\n", value_text(name)) + fingerprint_text(fingerprint);
    }
    if (options.as_json) text = json_text(all) + "\n";
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

Command fingerprint_command() {
    return make_command<FingerprintOptions>(
        "fingerprint", "print fingerprints of pictures: pixel hash, thumbnail as text, dHash",
        declare, perform);
}

}  // namespace fumon
