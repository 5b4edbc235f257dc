#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace fumon {

enum class WorkKind { article, proceedings, thesis, report, book, data };

/// A published work, as reference lists name it. Texts are UTF-8; what a work lacks is empty.
struct Work {
    std::string_view id;  ///< "werner_1995": of BibTeX, and of the rules that cite it
    WorkKind kind = WorkKind::article;
    std::vector<std::string_view> authors{};  ///< "Werner, B. T."
    int year = 0;
    std::string_view title{};        ///< as published
    std::string_view translation{};  ///< of a title that is not English
    std::string_view in{};  ///< journal, proceedings, university, publisher, or where data lie
    std::string_view volume{};
    std::string_view pages{};  ///< "1107–1110", or an article's number
    std::string_view doi{};
};

/// All works behind fumon's models, palettes and shipped data.
std::span<const Work> works();

/// The work of that id. Throws std::out_of_range.
const Work& work_of(std::string_view id);

}  // namespace fumon
