#include "files/wkt.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace fumon {

namespace {

constexpr int deepest = 32;

class WktReader {
  public:
    explicit WktReader(std::string_view text) : text_(text) {}

    std::optional<WktNode> whole() {
        WktNode node;
        if (!read_node(node, 0)) return std::nullopt;
        skip_blanks();
        return at_ == text_.size() ? std::optional(std::move(node)) : std::nullopt;
    }

  private:
    [[nodiscard]] bool is_at(std::string_view any) const {
        return at_ < text_.size() && any.find(text_[at_]) != std::string_view::npos;
    }

    void skip_blanks() {
        while (is_at(" \t\r\n")) ++at_;
    }

    /// A keyword, a bare word or a number.
    std::string read_word() {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_at(" \t\r\n,[]()\"")) ++at_;
        return std::string(text_.substr(begin, at_ - begin));
    }

    /// A text in quotes, in which two of them are one.
    bool read_quoted(std::string& value) {
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] != '"') {
                value += text_[at_];
            } else if (text_.substr(at_).starts_with("\"\"")) {
                value += text_[at_++];
            } else {
                ++at_;
                return true;
            }
        }
        return false;
    }

    bool read_entry(WktNode& of, int depth) {
        skip_blanks();
        if (is_at("\"")) return read_quoted(of.values.emplace_back());
        const std::size_t begin = at_;
        std::string word = read_word();
        if (word.empty()) return false;
        skip_blanks();
        if (!is_at("[(")) {
            of.values.push_back(std::move(word));
            return true;
        }
        at_ = begin;
        return read_node(of.children.emplace_back(), depth + 1);
    }

    bool read_node(WktNode& node, int depth) {
        node.keyword = read_word();
        for (char& letter : node.keyword) {
            if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
        }
        skip_blanks();
        if (node.keyword.empty() || !is_at("[(") || depth > deepest) return false;
        do {
            ++at_;
            if (!read_entry(node, depth)) return false;
            skip_blanks();
        } while (is_at(","));
        if (!is_at("])")) return false;
        ++at_;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::optional<double> WktNode::number(std::size_t nth) const {
    if (nth >= values.size()) return std::nullopt;
    const std::string& text = values[nth];
    double number = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

const WktNode* WktNode::child(std::initializer_list<std::string_view> keywords) const {
    for (const WktNode& node : children) {
        if (is_one_of(node.keyword, keywords)) return &node;
    }
    return nullptr;
}

const WktNode* WktNode::find(std::initializer_list<std::string_view> keywords) const {
    if (is_one_of(keyword, keywords)) return this;
    if (const WktNode* node = child(keywords)) return node;
    for (const WktNode& node : children) {
        if (const WktNode* found = node.find(keywords)) return found;
    }
    return nullptr;
}

std::optional<WktNode> parse_wkt(std::string_view text) {
    return WktReader(text).whole();
}

}  // namespace fumon
