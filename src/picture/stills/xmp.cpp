#include "picture/stills/xmp.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "base/error.h"
#include "base/utf8.h"
#include "picture/markup.h"

namespace fumon {

namespace {

constexpr std::string_view own_prefix = "fumon:";
constexpr std::string_view tool_element = "xmp:CreatorTool";
constexpr std::string_view title_element = "dc:title";
constexpr std::string_view extension_element = "xmpNote:HasExtendedXMP";
constexpr std::string_view description_head =
    "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
    "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description rdf:about=\"\" "
    "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" "
    "xmlns:xmpNote=\"http://ns.adobe.com/xmp/note/\" xmlns:fumon=\"urn:fumon:picture:\">\n";
constexpr std::string_view description_tail = "</rdf:Description></rdf:RDF></x:xmpmeta>";
constexpr std::string_view packet_head =
    "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>";
constexpr std::string_view packet_tail = "<?xpacket end=\"r\"?>";

struct Entity {
    char character;
    std::string_view name;
};

constexpr std::array<Entity, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}}};

/// The MD5 of a text (RFC 1321) in capital hexadecimal digits.
std::string md5_of(std::string_view text) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    std::size_t length = 0;
    if (EVP_Q_digest(nullptr, "MD5", nullptr, text.data(), text.size(), digest.data(), &length) !=
        1)
        throw Error("the MD5 of OpenSSL's libcrypto does not work here, which names XMP's parts");
    std::string digits;
    for (std::size_t i = 0; i < length; ++i) digits += fmt::format("{:02X}", digest.at(i));
    return digits;
}

/// A character in UTF-8; nothing for a number that is none.
std::string utf8_of(unsigned code) {
    const auto byte = [](unsigned bits) { return static_cast<char>(bits); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xC0U | code >> 6U), byte(0x80U | (code & 0x3FU))};
    if (code < 0x10000) {
        return {byte(0xE0U | code >> 12U), byte(0x80U | (code >> 6U & 0x3FU)),
                byte(0x80U | (code & 0x3FU))};
    }
    if (code > 0x10FFFF) return {};
    return {byte(0xF0U | code >> 18U), byte(0x80U | (code >> 12U & 0x3FU)),
            byte(0x80U | (code >> 6U & 0x3FU)), byte(0x80U | (code & 0x3FU))};
}

/// The character of "&#10;" or "&#xA;", which ends at `end`.
std::optional<std::string> numbered(std::string_view entity, std::size_t end) {
    if (!entity.starts_with("&#") || end == std::string_view::npos) return std::nullopt;
    std::string_view digits = entity.substr(2, end - 2);
    const bool hexadecimal = digits.starts_with('x');
    if (hexadecimal) digits.remove_prefix(1);
    unsigned code = 0;
    const auto read =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
    if (digits.empty() || read.ec != std::errc{} || read.ptr != digits.data() + digits.size())
        return std::nullopt;
    return utf8_of(code);
}

std::string from_xml(std::string_view xml) {
    std::string text;
    while (!xml.empty()) {
        const std::size_t plain = std::min(xml.find('&'), xml.size());
        text += xml.substr(0, plain);
        xml.remove_prefix(plain);
        if (xml.empty()) break;
        const auto* entity = std::ranges::find_if(
            entities, [xml](const Entity& one) { return xml.starts_with(one.name); });
        const std::size_t end = xml.substr(0, 12).find(';');
        if (entity != entities.end()) {
            text += entity->character;
            xml.remove_prefix(entity->name.size());
        } else if (const auto character = numbered(xml, end)) {
            text += *character;
            xml.remove_prefix(end + 1);
        } else {
            text += '&';
            xml.remove_prefix(1);
        }
    }
    return text;
}

std::string element_of(const std::string& keyword, std::string_view text) {
    const std::string value = xml_escaped(text);
    if (keyword == "Title") {
        return fmt::format(
            "<{0}><rdf:Alt><rdf:li xml:lang=\"x-default\">{1}</rdf:li></rdf:Alt></{0}>\n",
            title_element, value);
    }
    if (keyword == "Software") return fmt::format("<{0}>{1}</{0}>\n", tool_element, value);
    const bool plain = std::ranges::all_of(keyword, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == ':';
    });
    if (!keyword.starts_with(own_prefix) || keyword.size() == own_prefix.size() || !plain)
        throw Error(fmt::format("'{}' cannot be a keyword of XMP", keyword));
    return fmt::format("<{0}>{1}</{0}>\n", keyword, value);
}

/// The keyword of an element or attribute; empty where it is of no interest.
std::string keyword_of(std::string_view name) {
    if (name == tool_element) return "Software";
    return name.starts_with(own_prefix) ? std::string(name) : "";
}

std::string packet_of(const std::string& elements) {
    return fmt::format("{}\n{}{}{}\n{}", packet_head, description_head, elements, description_tail,
                       packet_tail);
}

constexpr std::string_view spaces = " \t\r\n";

/// Calls found(name, value) for the attributes of what stands between "<" and ">".
template <class Found>
void each_attribute(std::string_view tag, const Found& found) {
    for (std::size_t at = tag.find_first_of(spaces); at != std::string_view::npos;) {
        const std::size_t start = tag.find_first_not_of(spaces, at);
        const std::size_t equals = tag.find('=', at);
        if (start == std::string_view::npos || equals == std::string_view::npos) return;
        const std::size_t open = tag.find_first_of("\"'", equals);
        if (open == std::string_view::npos) return;
        const std::size_t close = tag.find(tag[open], open + 1);
        if (close == std::string_view::npos) return;
        std::string_view name = tag.substr(start, equals - start);
        name = name.substr(0, std::min(name.find_first_of(spaces), name.size()));
        found(name, tag.substr(open + 1, close - open - 1));
        at = close + 1;
    }
}

/// Calls found(name, value) for the elements that hold text alone, and for all attributes; an item
/// of a title is called as the title.
template <class Found>
void each_value(std::string_view xmp, const Found& found) {
    bool in_title = false;
    for (std::size_t open = xmp.find('<'); open != std::string_view::npos;) {
        const std::size_t close = xmp.find('>', open);
        if (close == std::string_view::npos) return;
        const std::string_view tag = xmp.substr(open + 1, close - open - 1);
        open = xmp.find('<', close);
        const std::string_view name =
            tag.substr(0, std::min(tag.find_first_of(" \t\r\n/"), tag.size()));
        if (tag.starts_with('/')) {
            if (tag.substr(1) == title_element) in_title = false;
            continue;
        }
        if (name == title_element) in_title = true;
        each_attribute(tag, found);
        if (tag.ends_with('/') || open == std::string_view::npos) continue;
        const std::string_view content = xmp.substr(close + 1, open - close - 1);
        if (!xmp.substr(open).starts_with("</")) continue;
        found(in_title && name == "rdf:li" ? title_element : name, content);
    }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
    std::string xml;
    while (!text.empty()) {
        const std::size_t plain = std::min(text.find_first_of("\r\n\t"), text.size());
        xml += markup_text(text.substr(0, plain));
        text.remove_prefix(plain);
        if (text.empty()) break;
        xml += fmt::format("&#{};", static_cast<int>(text.front()));
        text.remove_prefix(1);
    }
    return xml;
}

std::string xmp_packet(const PictureText& texts) {
    std::string elements;
    for (const auto& [keyword, text] : texts) elements += element_of(keyword, text);
    return packet_of(elements);
}

XmpParts xmp_parts(const PictureText& texts, std::size_t most_bytes) {
    XmpParts parts{xmp_packet(texts), {}, {}};
    if (parts.packet.size() <= most_bytes) return parts;
    constexpr std::size_t note =
        200;  // bytes of the element that names the extension, and to spare
    std::string kept;
    std::string extended;
    for (const auto& [keyword, text] : texts) {
        const std::string element = element_of(keyword, text);
        const bool fits = packet_of(kept).size() + element.size() + note <= most_bytes;
        (fits ? kept : extended) += element;
    }
    parts.extension = fmt::format("{}{}{}", description_head, extended, description_tail);
    parts.guid = md5_of(parts.extension);
    kept += fmt::format("<{0}>{1}</{0}>\n", extension_element, parts.guid);
    parts.packet = packet_of(kept);
    return parts;
}

PictureText texts_of_xmp(std::string_view xmp) {
    PictureText texts;
    each_value(xmp, [&texts](std::string_view name, std::string_view value) {
        const std::string keyword = name == title_element ? "Title" : keyword_of(name);
        if (keyword.empty()) return;
        std::string text = from_xml(value);
        if (is_utf8(text)) texts.emplace_back(keyword, std::move(text));
    });
    return texts;
}

std::string xmp_value(std::string_view xmp, std::string_view name) {
    std::string text;
    each_value(xmp, [&](std::string_view found, std::string_view value) {
        if (found == name) text = from_xml(value);
    });
    return text;
}

std::string extension_of_xmp(std::string_view xmp) {
    return xmp_value(xmp, extension_element);
}

}  // namespace fumon
