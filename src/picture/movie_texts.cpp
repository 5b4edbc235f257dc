// The metadata of MP4 movies, which may come from anywhere: read here rather than by FFmpeg, which
// asks for the memory that a damaged movie says it needs. A file is a row of boxes, each its size
// (uint32, big-endian), its type (4 letters) and its content (ISO/IEC 14496-12); the texts stand in
// moov/udta/meta: their keywords in "keys", and in "ilst" a box of each text, whose type is the
// keyword's number from 1 and which holds a "data" box (QuickTime File Format, "Metadata").

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/utf8.h"
#include "files/input_file.h"
#include "picture/movie.h"

namespace fumon {

namespace {

constexpr std::size_t word = 4;  // bytes
constexpr std::size_t box_head = 2 * word;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(at, word))
        number = number << 8U | static_cast<unsigned char>(byte);
    return number;
}

[[noreturn]] void refuse(const std::string& movie, const char* why) {
    throw InputError(fmt::format(
        "{}: is not an MP4 movie or is damaged ({}); take an untouched copy", movie, why));
}

struct Box {
    std::string_view type;
    std::string_view content;
};

/// The boxes of some bytes, one after the other.
class Boxes {
  public:
    Boxes(std::string_view bytes, const std::string& movie) : bytes_(bytes), movie_(movie) {}

    std::optional<Box> next() {
        if (bytes_.empty()) return std::nullopt;
        if (bytes_.size() < box_head) refuse(movie_, "its metadata are cut short");
        const std::size_t size = number_at(bytes_, 0);
        if (size < box_head || size > bytes_.size())
            refuse(movie_, "the sizes of its metadata are inconsistent");
        const Box box{bytes_.substr(word, word), bytes_.substr(box_head, size - box_head)};
        bytes_.remove_prefix(size);
        return box;
    }

    /// The content of the first further box of that type; empty where there is none.
    std::string_view find(std::string_view type) {
        while (const auto box = next()) {
            if (box->type == type) return box->content;
        }
        return {};
    }

  private:
    std::string_view bytes_;
    const std::string& movie_;
};

/// Content behind a box's version, flags and further words.
std::string_view behind(std::string_view content, std::size_t words, const std::string& movie) {
    if (content.size() < words * word) refuse(movie, "its metadata are cut short");
    return content.substr(words * word);
}

std::vector<std::string> read_keywords(std::string_view keys, const std::string& movie) {
    std::vector<std::string> keywords;
    Boxes boxes(behind(keys, 2, movie), movie);
    while (const auto box = boxes.next()) {
        if (box->content.empty()) refuse(movie, "a keyword of its metadata is empty");
        keywords.emplace_back(box->content);
    }
    return keywords;
}

PictureText read_texts(std::string_view meta, const std::string& movie) {
    PictureText texts;
    const std::string_view content = behind(meta, 1, movie);
    const std::string_view keys = Boxes(content, movie).find("keys");
    if (keys.empty()) return texts;
    const std::vector<std::string> keywords = read_keywords(keys, movie);
    Boxes items(Boxes(content, movie).find("ilst"), movie);
    while (const auto item = items.next()) {
        const std::size_t number = number_at(item->type, 0);
        if (number < 1 || number > keywords.size())
            refuse(movie, "a text of its metadata has no keyword");
        const std::string_view data = Boxes(item->content, movie).find("data");
        const std::string_view text = behind(data, 2, movie);  // its kind and language
        constexpr std::uint32_t utf8 = 1;
        if (number_at(data, 0) == utf8 && is_utf8(text))
            texts.emplace_back(keywords[number - 1], text);
    }
    return texts;
}

/// The content of the box "moov" of a file; none of its other boxes is read.
std::string read_moov(const std::filesystem::path& file) {
    const std::string movie = file.string();
    std::error_code fault;
    const std::uint64_t size = std::filesystem::file_size(file, fault);
    std::ifstream stream(file, std::ios::binary);
    if (fault || !stream) refuse(movie, "it cannot be read");
    for (std::uint64_t at = 0; at + box_head <= size;) {
        constexpr std::size_t long_head = box_head + 2 * word;
        std::string head(long_head, '\0');
        stream.seekg(static_cast<std::streamoff>(at));
        stream.read(head.data(), static_cast<std::streamsize>(head.size()));
        if (stream.gcount() < static_cast<std::streamsize>(box_head)) break;
        stream.clear();
        const std::uint32_t short_length = number_at(head, 0);
        const bool is_long = short_length == 1;  // the length follows as uint64
        std::uint64_t length = short_length;
        if (is_long)
            length =
                std::uint64_t{number_at(head, box_head)} << 32U | number_at(head, box_head + word);
        if (short_length == 0) length = size - at;  // to the end
        const std::size_t head_size = is_long ? long_head : box_head;
        if (length < head_size || length > size - at)
            refuse(movie, "it is cut short, or its sizes are inconsistent");
        if (head.substr(word, word) == "moov") {
            constexpr std::uint64_t largest = std::uint64_t{1} << 28U;  // bytes: a day's frames
            if (length > largest) refuse(movie, "its header is too large");
            std::string content(length - head_size, '\0');
            stream.seekg(static_cast<std::streamoff>(at + head_size));
            stream.read(content.data(), static_cast<std::streamsize>(content.size()));
            if (stream.gcount() != static_cast<std::streamsize>(content.size()))
                refuse(movie, "it cannot be read to its end");
            return content;
        }
        at += length;
    }
    refuse(movie, "it has no header");
}

}  // namespace

bool is_movie(const std::filesystem::path& file) {
    constexpr std::string_view type = "ftyp";
    return start_of_input_file(file, word + type.size()).ends_with(type);
}

PictureText read_movie_texts(const std::filesystem::path& file) {
    const std::string movie = file.string();
    const std::string moov = read_moov(file);
    const std::string_view udta = Boxes(moov, movie).find("udta");
    const std::string_view meta = Boxes(udta, movie).find("meta");
    return meta.empty() ? PictureText{} : read_texts(meta, movie);
}

}  // namespace fumon
