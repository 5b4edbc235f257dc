#include "figure/canvas/marked_text.h"

namespace fumon {

MarkedText read_marked_text(const std::string& text) {
    MarkedText marked;
    std::size_t i = 0;
    while (i < text.size()) {
        const bool mark =
            (text[i] == '^' || text[i] == '_') && i + 1 < text.size() && text[i + 1] == '{';
        const std::size_t end = mark ? text.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            marked.letters += text[i++];
            continue;
        }
        const std::size_t begin = marked.letters.size();
        marked.letters.append(text, i + 2, end - i - 2);
        marked.parts.push_back({begin, marked.letters.size(), text[i] == '^'});
        i = end + 1;
    }
    return marked;
}

}  // namespace fumon
