#include "figure/canvas/pdf_archive.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "figure/canvas/packed_text.h"
#include "files/hash.h"
#include "picture/pixels/srgb_profile.h"
#include "picture/stills/xmp.h"

namespace fumon {

namespace {

[[noreturn]] void refuse() {
    throw Error("cannot make a PDF/A file: the PDF of this version of Cairo is not supported");
}

std::size_t number_at(std::string_view text) {
    std::size_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc{}) refuse();
    return number;
}

/// The objects of a file, "1 0 obj … endobj" with the end of the line, by their numbers from 1 on.
struct Objects {
    std::string head;  ///< before all
    std::vector<std::string> texts;
    std::vector<std::size_t> order;  ///< numbers as they stand in the file
};

Objects objects_of(std::string_view pdf) {
    constexpr std::string_view start = "startxref\n";
    const std::size_t last = pdf.rfind(start);
    if (last == std::string_view::npos) refuse();
    const std::size_t table = number_at(pdf.substr(last + start.size()));
    constexpr std::string_view table_head = "xref\n0 ";
    if (table > last || !pdf.substr(table).starts_with(table_head)) refuse();
    const std::string_view after = pdf.substr(table + table_head.size());
    const std::size_t count = number_at(after);
    const std::size_t line = after.find('\n');
    constexpr std::size_t entry = 20;  // bytes
    if (count < 2 || line == std::string_view::npos || (after.size() - line) / entry < count)
        refuse();
    std::vector<std::pair<std::size_t, std::size_t>> begins;  // and numbers
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t at = number_at(after.substr(line + 1 + entry * k, 10));
        if (at >= table) refuse();
        begins.emplace_back(at, k);
    }
    std::ranges::sort(begins);
    Objects objects{std::string(pdf.substr(0, begins.front().first)), {}, {}};
    objects.texts.resize(count - 1);
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const auto [at, number] = begins[k];
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1].first : table;
        objects.texts[number - 1] = pdf.substr(at, end - at);
        objects.order.push_back(number);
    }
    return objects;
}

/// Puts an entry into a dictionary that has a given entry, before it.
void insert_before(std::string& object, std::string_view entry, const std::string& more) {
    const std::size_t at = object.find(entry);
    if (at == std::string::npos) refuse();
    object.insert(at, more);
}

std::string metadata_packet(const PdfMetadata& metadata) {
    std::string title;
    if (!metadata.title.empty()) {
        title = fmt::format(
            "<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">{}</rdf:li></rdf:Alt></dc:title>\n",
            xml_escaped(metadata.title));
    }
    const auto element = [](std::string_view name, std::string_view text) {
        return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", name, xml_escaped(text));
    };
    return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
           "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description "
           "rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
           "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\" "
           "xmlns:pdfaid=\"http://www.aiim.org/pdfa/ns/id/\">\n"
           "<pdfaid:part>2</pdfaid:part>\n<pdfaid:conformance>B</pdfaid:conformance>\n" +
           title + element("xmp:CreatorTool", metadata.creator) +
           "<xmp:CreateDate>2000-01-01T00:00:00Z</xmp:CreateDate>\n" +
           element("pdf:Producer",
                   fmt::format("cairo {} (https://cairographics.org)", cairo_version_string())) +
           element("pdf:Keywords", metadata.keywords) +
           "</rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

std::string stream_object(std::size_t number, const std::string& entries,
                          const std::string& content) {
    return fmt::format("{} 0 obj\n<< {}\n   /Length {}\n>>\nstream\n{}\nendstream\nendobj\n",
                       number, entries, content.size(), content);
}

}  // namespace

std::string pdf_archive(std::string_view pdf, const PdfMetadata& metadata) {
    Objects objects = objects_of(pdf);
    const std::size_t metadata_number = objects.texts.size() + 1;
    const std::size_t intent_number = metadata_number + 1;
    const std::size_t profile_number = metadata_number + 2;
    constexpr std::string_view date = "/CreationDate (";
    std::size_t catalog = 0;
    std::size_t info = 0;
    for (std::size_t number = 1; number < metadata_number; ++number) {
        std::string& object = objects.texts[number - 1];
        const std::size_t dictionary = std::min(object.find("stream\n"), object.size());
        const auto has = [&](std::string_view entry) { return object.find(entry) < dictionary; };
        if (has("/Type /Catalog")) {
            catalog = number;
            insert_before(object, "/Pages ",
                          fmt::format("/Metadata {} 0 R\n   /OutputIntents [ {} 0 R ]\n   ",
                                      metadata_number, intent_number));
        } else if (has("/Subtype /CIDFontType2") && !has("/CIDToGIDMap")) {
            insert_before(object, "/Subtype /CIDFontType2", "/CIDToGIDMap /Identity\n   ");
        } else if (has(date)) {
            info = number;
            if (has(fmt::format("{}2000", date)))  // Cairo leaves the prefix out
                object.insert(object.find(date) + date.size(), "D:");
        }
    }
    if (catalog == 0 || info == 0) refuse();
    const auto add = [&](std::string text) {
        objects.texts.push_back(std::move(text));
        objects.order.push_back(objects.texts.size());
    };
    add(stream_object(metadata_number, "/Type /Metadata\n   /Subtype /XML",
                      metadata_packet(metadata)));
    add(
        fmt::format("{} 0 obj\n<< /Type /OutputIntent\n   /S /GTS_PDFA1\n   "
                    "/OutputConditionIdentifier ({})\n   /Info ({})\n   /DestOutputProfile {} 0 R\n"
                    ">>\nendobj\n",
                    intent_number, srgb_name, srgb_name, profile_number));
    add(stream_object(profile_number, "/N 3\n   /Alternate /DeviceRGB\n   /Filter /FlateDecode",
                      deflated(srgb_profile())));

    std::string file = objects.head;
    std::vector<std::size_t> begins(objects.texts.size());
    for (const std::size_t number : objects.order) {
        begins[number - 1] = file.size();
        file += objects.texts[number - 1];
    }
    const std::string identifier = hex(text_hash(file)).substr(0, 32);
    const std::size_t table = file.size();
    file += fmt::format("xref\n0 {}\n0000000000 65535 f \n", begins.size() + 1);
    for (const std::size_t begin : begins) file += fmt::format("{:010} 00000 n \n", begin);
    file += fmt::format(
        "trailer\n<< /Size {}\n   /Root {} 0 R\n   /Info {} 0 R\n   /ID [ <{}> <{}> ]\n>>\n"
        "startxref\n{}\n%%EOF\n",
        begins.size() + 1, catalog, info, identifier, identifier, table);
    return file;
}

}  // namespace fumon
