#include "files/gdal/gdal_notes.h"

#include <algorithm>
#include <system_error>

#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Takes out every element that begins with `open`, up to and with `close`.
void take_out(std::string& text, std::string_view open, std::string_view close) {
    for (std::size_t at = text.find(open); at != text.npos; at = text.find(open, at)) {
        const std::size_t end = text.find(close, at);
        if (end == text.npos) return;
        text.erase(at, end + close.size() - at);
    }
}

std::string without_space_between(std::string_view text) {
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('<', at), text.size());
        const std::string_view between = text.substr(at, open - at);
        if (between.find_first_not_of(blanks) != between.npos) kept += between;
        const std::size_t close = text.find('>', open);
        const std::size_t end = close == text.npos ? text.size() : close + 1;
        kept += text.substr(open, end - open);
        at = end;
    }
    return kept;
}

/// Takes out elements that hold nothing, <A …></A> and <Metadata/>, until none is left.
void take_out_empty(std::string& text) {
    for (bool found = true; found;) {
        found = false;
        for (std::size_t close = text.find("></"); close != text.npos;
             close = text.find("></", close + 1)) {
            const std::size_t open = text.rfind('<', close);
            const std::size_t end = text.find('>', close + 1);
            if (open == text.npos || end == text.npos || text[open + 1] == '/' ||
                text[close - 1] == '/')
                continue;
            text.erase(open, end + 1 - open);
            found = true;
            break;
        }
        const std::size_t alone = text.find("<Metadata/>");
        if (alone != text.npos) {
            text.erase(alone, std::string_view("<Metadata/>").size());
            found = true;
        }
    }
}

}  // namespace

std::string without_statistics(std::string_view notes) {
    std::string text(notes);
    take_out(text, "<MDI key=\"STATISTICS_", "</MDI>");
    take_out(text, "<Histograms>", "</Histograms>");
    take_out(text, "<?xml", "?>");
    text = without_space_between(text);
    take_out_empty(text);
    return text;
}

bool is_erdas_aux(const std::filesystem::path& file) {
    std::error_code fault;
    constexpr std::string_view signature = "EHFA_HEADER_TAG";
    return std::filesystem::is_regular_file(file, fault) &&
           start_of_input_file(file, signature.size()) == signature;
}

}  // namespace fumon
