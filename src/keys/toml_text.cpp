#include "keys/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/error.h"

namespace fumon {

namespace {

bool is_bare(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
}

/// Follows how deeply a TOML text nests, without building anything: the TOML reader limits the
/// nesting of values but not of keys, and tables that nest too deeply overflow the stack when they
/// go. As long as a text is TOML, it takes strings, comments and brackets as the reader does;
/// behind the first fault the reader has stopped.
class NestingScan {
  public:
    explicit NestingScan(std::string_view text) : text_(text) {}

    /// Where the text first nests deeper than `deepest`; its size where it never does.
    std::size_t first_deeper_than(int deepest) {
        while (at_ < text_.size()) {
            const std::size_t start = at_;
            take_one();
            if (header_ + around_ + key_ + parts_ > deepest) return start;
        }
        return text_.size();
    }

  private:
    void take_one() {
        const char c = text_[at_];
        const bool first_of_line = first_of_line_;
        if (c != ' ' && c != '\t') first_of_line_ = false;
        if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (c == '"' || c == '\'') {
            skip_string(c);
            take_part();
        } else if (is_bare(c)) {
            while (at_ < text_.size() && is_bare(text_[at_])) ++at_;
            take_part();
        } else {
            ++at_;
            take_mark(c, first_of_line);
        }
    }

    void take_part() {
        parts_ = after_dot_ ? parts_ + 1 : 1;
        after_dot_ = false;
    }

    void take_mark(char c, bool first_of_line) {
        switch (c) {
            case ' ':
            case '\t':
            case '\r':
                return;
            case '.':
                after_dot_ = true;
                return;
            case '\n':
                first_of_line_ = open_.empty();
                if (open_.empty()) key_ = 0;
                break;
            case '=':
                key_ = parts_;
                break;
            case ',':
                key_ = 0;
                break;
            case '[':
            case '{':
                open(c == '[' && open_.empty() && (first_of_line || (in_header_ && parts_ == 0)));
                break;
            case ']':
            case '}':
                close();
                break;
            default:
                break;
        }
        parts_ = 0;
        after_dot_ = false;
    }

    void open(bool header) {
        if (header) {
            in_header_ = true;
            header_ = 0;
            return;
        }
        open_.push_back(key_ + 1);
        around_ += open_.back();
        key_ = 0;
    }

    void close() {
        if (in_header_) {
            in_header_ = false;
            header_ = parts_;
        } else if (!open_.empty()) {
            around_ -= open_.back();
            open_.pop_back();
        }
        key_ = 0;
    }

    void skip_string(char quote) {
        const std::string three(3, quote);
        const bool many_lines = text_.substr(at_, 3) == three;
        at_ += many_lines ? 3 : 1;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\\' && quote == '"') {
                at_ += 2;
            } else if (many_lines && text_.substr(at_, 3) == three) {
                at_ += 3;  // up to two more quotes belong to the text
                for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] == quote; ++more)
                    ++at_;
                return;
            } else if (!many_lines && (c == quote || c == '\n')) {
                if (c == quote) ++at_;
                return;
            } else {
                ++at_;
            }
        }
        at_ = text_.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    bool first_of_line_ = true;
    bool in_header_ = false;
    bool after_dot_ = false;
    int header_ = 0;         ///< parts of the header above
    int key_ = 0;            ///< parts of the key of the value at hand
    int parts_ = 0;          ///< of the key at hand, so far
    int around_ = 0;         ///< the sum of open_
    std::vector<int> open_;  ///< of each open list or inline table: itself and its key's parts
};

struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;  ///< in characters
};

TextPosition place_of(std::string_view text, std::size_t offset) {
    TextPosition place;
    for (const char c : text.substr(0, offset)) {
        const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        if (c == '\n') {
            ++place.line;
            place.column = 1;
        } else if (!continues) {
            ++place.column;
        }
    }
    return place;
}

/// Whether a text begins as the pictures and movies do that fumon makes.
bool is_picture(std::string_view text) {
    constexpr std::size_t brand = 4;  // where an MP4 says that it is one
    return text.starts_with("\x89PNG") || text.starts_with("%PDF-") || text.starts_with("<?xml") ||
           text.starts_with("<svg") ||
           text.substr(std::min(brand, text.size())).starts_with("ftyp");
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& name, std::string_view remedy) {
    if (is_picture(text)) {
        throw InputError(
            fmt::format("{}: is a picture; {}; `fumon again {}` redraws a picture made by fumon",
                        name, remedy, name));
    }
    const std::size_t deep = NestingScan(text).first_deeper_than(deepest_toml);
    if (deep < text.size()) {
        const TextPosition place = place_of(text, deep);
        throw InputError(fmt::format("{}:{}:{}: keys and values nest deeper than {}; {}", name,
                                     place.line, place.column, deepest_toml, remedy));
    }
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error& fault) {
        throw InputError(fmt::format("{}:{}:{}: {}; {}", name, fault.source().begin.line,
                                     fault.source().begin.column, fault.description(), remedy));
    }
}

std::optional<toml::table> parse_toml_value(std::string_view text) {
    try {
        toml::table holder = parse_toml(fmt::format("value = {}", text), "", "");
        if (holder.size() == 1) return holder;
    } catch (const InputError&) {
        return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace fumon
