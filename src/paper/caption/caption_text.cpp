#include "paper/caption/caption_text.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "figure/canvas/marked_text.h"

namespace fumon {

namespace {

struct Replacement {
    std::string_view letter;
    std::string_view by;
};

constexpr std::array<Replacement, 14> raised_letters{{{"0", "⁰"},
                                                      {"1", "¹"},
                                                      {"2", "²"},
                                                      {"3", "³"},
                                                      {"4", "⁴"},
                                                      {"5", "⁵"},
                                                      {"6", "⁶"},
                                                      {"7", "⁷"},
                                                      {"8", "⁸"},
                                                      {"9", "⁹"},
                                                      {"−", "⁻"},
                                                      {"-", "⁻"},
                                                      {"+", "⁺"},
                                                      {"n", "ⁿ"}}};
constexpr std::array<Replacement, 14> lowered_letters{{{"0", "₀"},
                                                       {"1", "₁"},
                                                       {"2", "₂"},
                                                       {"3", "₃"},
                                                       {"4", "₄"},
                                                       {"5", "₅"},
                                                       {"6", "₆"},
                                                       {"7", "₇"},
                                                       {"8", "₈"},
                                                       {"9", "₉"},
                                                       {"x", "ₓ"},
                                                       {"a", "ₐ"},
                                                       {"e", "ₑ"},
                                                       {"s", "ₛ"}}};
/// What LaTeX reads as commands, and letters that its usual fonts do not have.
constexpr std::array<Replacement, 37> latex_letters{{{"\\", "\\textbackslash{}"},
                                                     {"{", "\\{"},
                                                     {"}", "\\}"},
                                                     {"$", "\\$"},
                                                     {"&", "\\&"},
                                                     {"#", "\\#"},
                                                     {"%", "\\%"},
                                                     {"_", "\\_"},
                                                     {"^", "\\textasciicircum{}"},
                                                     {"~", "\\textasciitilde{}"},
                                                     {"<", "\\textless{}"},
                                                     {">", "\\textgreater{}"},
                                                     {"|", "\\textbar{}"},
                                                     {"\"", "''"},
                                                     {"\u2212", "$-$"},
                                                     {"×", "$\\times$"},
                                                     {"·", "$\\cdot$"},
                                                     {"±", "$\\pm$"},
                                                     {"°", "$^\\circ$"},
                                                     {"µ", "$\\mu$"},
                                                     {"′", "$'$"},
                                                     {"≤", "$\\le$"},
                                                     {"≥", "$\\ge$"},
                                                     {"…", "\\ldots{}"},
                                                     {"–", "--"},
                                                     {"α", "$\\alpha$"},
                                                     {"β", "$\\beta$"},
                                                     {"γ", "$\\gamma$"},
                                                     {"θ", "$\\theta$"},
                                                     {"λ", "$\\lambda$"},
                                                     {"π", "$\\pi$"},
                                                     {"ρ", "$\\rho$"},
                                                     {"τ", "$\\tau$"},
                                                     {"φ", "$\\varphi$"},
                                                     {"₀", "\\textsubscript{0}"},
                                                     {"²", "\\textsuperscript{2}"},
                                                     {"³", "\\textsuperscript{3}"}}};
constexpr std::array<Replacement, 9> markdown_letters{{{"\\", "\\\\"},
                                                       {"`", "\\`"},
                                                       {"*", "\\*"},
                                                       {"_", "\\_"},
                                                       {"[", "\\["},
                                                       {"]", "\\]"},
                                                       {"<", "&lt;"},
                                                       {">", "&gt;"},
                                                       {"&", "&amp;"}}};

template <std::size_t count>
std::string replaced(std::string_view text, const std::array<Replacement, count>& letters) {
    std::string made;
    while (!text.empty()) {
        const auto known = std::ranges::find_if(
            letters, [text](const Replacement& one) { return text.starts_with(one.letter); });
        made += known == letters.end() ? text.substr(0, 1) : known->by;
        text.remove_prefix(known == letters.end() ? 1 : known->letter.size());
    }
    return made;
}

/// Whether each letter has its replacement.
template <std::size_t count>
bool all_known(std::string_view text, const std::array<Replacement, count>& letters) {
    while (!text.empty()) {
        const auto known = std::ranges::find_if(
            letters, [text](const Replacement& one) { return text.starts_with(one.letter); });
        if (known == letters.end()) return false;
        text.remove_prefix(known->letter.size());
    }
    return true;
}

/// A text whose letters `plain` writes, and whose raised and lowered parts `marked`.
std::string written(const std::string& text,
                    const std::function<std::string(std::string_view)>& plain,
                    const std::function<std::string(std::string_view, bool raised)>& marked) {
    const MarkedText read = read_marked_text(text);
    const std::string_view letters = read.letters;
    std::string made;
    std::size_t at = 0;
    for (const RaisedPart& part : read.parts) {
        made += plain(letters.substr(at, part.begin - at));
        made += marked(letters.substr(part.begin, part.end - part.begin), part.raised);
        at = part.end;
    }
    return made + plain(letters.substr(at));
}

}  // namespace

std::string plain_caption(const std::string& caption) {
    return written(
        caption, [](std::string_view letters) { return std::string(letters); },
        [](std::string_view part, bool raised) {
            if (raised && all_known(part, raised_letters)) return replaced(part, raised_letters);
            if (!raised && all_known(part, lowered_letters)) return replaced(part, lowered_letters);
            return std::string(1, raised ? '^' : '_').append(part);
        });
}

std::string latex_caption(const std::string& caption) {
    const auto plain = [](std::string_view letters) { return replaced(letters, latex_letters); };
    std::string text = written(caption, plain, [&](std::string_view part, bool raised) {
        return (raised ? "\\textsuperscript{" : "\\textsubscript{") + plain(part) + "}";
    });
    for (std::size_t at = text.find("\n\n"); at != std::string::npos; at = text.find("\n\n", at))
        text.erase(at, 1);
    while (text.starts_with('\n')) text.erase(0, 1);
    return text;
}

std::string markdown_caption(const std::string& caption) {
    const auto plain = [](std::string_view letters) { return replaced(letters, markdown_letters); };
    return written(caption, plain, [&](std::string_view part, bool raised) {
        const std::string tag = raised ? "sup>" : "sub>";
        return "<" + tag + plain(part) + "</" + tag;
    });
}

}  // namespace fumon
