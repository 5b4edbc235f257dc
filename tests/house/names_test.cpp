// A name stands for one type: two of a name in one namespace are undefined behaviour that no
// compiler reports, since each file sees only one of them and the linker keeps either's functions.
// And a name is the field's term: words that were this project's alone are listed with what to
// write instead.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// namespace::Name of the types that a file's text defines outside functions, classes and nameless
/// namespaces.
std::vector<std::string> types_of(std::istream& file) {
    static const std::regex opens("^(inline )?namespace ?([A-Za-z0-9_:]*) ?\\{$");
    static const std::regex closes("^\\}  // namespace");
    static const std::regex defines(
        "^(?:class|struct|union|enum class|enum) ([A-Z][A-Za-z0-9]*)(?: final)?(?: : [^;]*)?"
        "(?: \\{.*|,?)$");
    std::vector<std::string> within;
    std::vector<std::string> types;
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
        if (std::regex_match(line, match, opens)) {
            within.push_back(match[2]);
        } else if (std::regex_search(line, closes)) {
            if (!within.empty()) within.pop_back();
        } else if (std::regex_match(line, match, defines)) {
            std::string name;
            bool everywhere = true;
            for (const std::string& space : within) {
                everywhere = everywhere && !space.empty();
                name += space + "::";
            }
            if (everywhere) types.push_back(name + match[1].str());
        }
    }
    return types;
}

TEST(NamesTest, NoTwoTypesOfANamespaceHaveTheSame) {
    std::map<std::string, fs::path> defined;
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".h") && !name.ends_with(".cpp")) continue;
        if (name.ends_with("-inl.h")) continue;  // in a namespace of each vector target
        std::ifstream file(entry.path());
        for (const std::string& type : types_of(file)) {
            const auto [before, is_new] = defined.emplace(type, entry.path());
            EXPECT_TRUE(is_new) << type << " stands in " << entry.path() << " and in "
                                << before->second;
        }
    }
    EXPECT_GT(defined.size(), 400U);
}

/// A word of the left column in an identifier is an old name of this project; the right column has
/// the field's term. A word with a capital stands for itself alone, any other for a part of an
/// identifier between underscores or capitals too: "told" is in ToldDoubt and in told_.
struct OldWord {
    std::string_view word;
    std::string_view term;
};

constexpr std::array old_words{
    OldWord{"given_up", "cancelled"},
    OldWord{"gave_up", "cancelled"},
    OldWord{"give_up", "cancel, throw_if_cancelled"},
    OldWord{"doubt", "plausibility_warning"},
    OldWord{"doubts", "plausibility_warnings"},
    OldWord{"told", "reported, message"},
    OldWord{"tells", "reports, states"},
    OldWord{"former", "previous"},
    OldWord{"kept_blocks", "BlockPool"},
    OldWord{"large_pages", "huge_pages"},
    OldWord{"state_carrier", "StateArchive"},
    OldWord{"carry_hash", "serialise_hash"},
    OldWord{"held_state", "SavedState"},
    OldWord{"held_bed", "MemoryBed"},
    OldWord{"whole_grid", "FixedPointGrid"},
    OldWord{"whole_within", "truncated_within"},
    OldWord{"look_for_signals", "check_signals"},
    OldWord{"between_looks", "poll_interval"},
    OldWord{"how_it_ended", "termination_text"},
    OldWord{"lives_in_metres", "uses_metres"},
    OldWord{"laid_on", "composited_on"},
    OldWord{"lay_over", "composite_over"},
    OldWord{"into_box", "wrap_periodic"},
    OldWord{"lone_dunes", "isolated_dunes"},
    OldWord{"dune_pieces", "dune_components"},
    OldWord{"dune_way", "wind_on_grid"},
    OldWord{"longest_way", "longest_path_length"},
    OldWord{"cell_rows", "CellBitset"},
    OldWord{"row_places", "RowSlots"},
    OldWord{"row_sides", "RowNeighbours"},
    OldWord{"wind_turns", "WindSchedule"},
    OldWord{"edge_stretch", "EdgeSegment"},
    OldWord{"put_shores", "set_shore_fluxes"},
    OldWord{"part_of_frame", "FramePart"},
    OldWord{"kept_frames", "FrameCache"},
    OldWord{"picture_ahead", "PicturePrefetch"},
    OldWord{"wanted_picture", "ViewRequest"},
    OldWord{"end_at_once", "ExitOnSignal"},
    OldWord{"bar_place", "BarPosition"},
    OldWord{"card_place", "CardPosition"},
    OldWord{"fault_place", "SourcePosition"},
    OldWord{"file_place", "FileCoordinates"},
    OldWord{"grid_place", "GridSpan"},
    OldWord{"inset_place", "InsetCorner"},
    OldWord{"label_place", "LabelAnchor, LabelGap"},
    OldWord{"legend_place", "LegendPosition"},
    OldWord{"overlay_place", "OverlayRectangle"},
    OldWord{"raster_place", "RasterGeoReference"},
    OldWord{"Way", "HorizontalDirection, path, traversal: what it is"},
    OldWord{"How", "the enumeration named for what it chooses"},
    OldWord{"Where", "position, location: what it is"},
    OldWord{"Says", "the enumeration named for what it states"},
};

/// Of render/ and the shaders.
constexpr bool render_has_new_words = true;
constexpr std::array old_words_of_render{
    OldWord{"Place", "position, cell, anchor, rectangle: what it is"},
    OldWord{"seen_buffer", "VisibilityBuffer"},
    OldWord{"gathered_light", "AccumulatedLight"},
    OldWord{"put_colours", "resolve_shading"},
    OldWord{"Coloured", "ShadePass"},
    OldWord{"within_rows", "ScopedScissor"},
    OldWord{"none_slid", "min_drawn_avalanche_slope"},
    OldWord{"whole_pixels", "single_surface_pixels"},
};

/// The identifiers of a C++ or GLSL text, without comments and literals, each with its line.
std::vector<std::pair<std::string, int>> identifiers_of(const std::string& text) {
    const auto is_letter = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    std::vector<std::pair<std::string, int>> found;
    int line = 1;
    std::size_t i = 0;
    const auto skip_to = [&](std::size_t end) {
        end = std::min(end, text.size());
        line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                            text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        i = end;
    };
    const auto past = [&](const std::string& mark, std::size_t from) {
        const std::size_t at = text.find(mark, from);
        return at == std::string::npos ? text.size() : at + mark.size();
    };
    while (i < text.size()) {
        if (text.compare(i, 2, "//") == 0) {
            skip_to(text.find('\n', i));
        } else if (text.compare(i, 2, "/*") == 0) {
            skip_to(past("*/", i + 2));
        } else if (text.compare(i, 2, "R\"") == 0) {
            const std::size_t open = text.find('(', i);
            skip_to(past(")" + text.substr(i + 2, open - i - 2) + "\"", open));
        } else if (text[i] == '"' || text[i] == '\'') {
            std::size_t end = i + 1;
            while (end < text.size() && text[end] != text[i])
                end += text[end] == '\\' ? std::size_t{2} : std::size_t{1};
            skip_to(end + 1);
        } else if (is_letter(text[i])) {
            std::size_t end = i;
            const bool number = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
            while (end < text.size() && (is_letter(text[end]) || (number && text[end] == '\'')))
                ++end;
            if (!number && text.compare(i, 2, "R\"") != 0)
                found.emplace_back(text.substr(i, end - i), line);
            i = end;
        } else {
            skip_to(i + 1);
        }
    }
    return found;
}

/// "_told_doubt_" of ToldDoubt.
std::string words_of(const std::string& identifier) {
    std::string words = "_";
    for (const char c : identifier) {
        if (std::isupper(static_cast<unsigned char>(c)) != 0) {
            if (words.back() != '_') words += '_';
            words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (c != '_' || words.back() != '_') {
            words += c;
        }
    }
    return words.back() == '_' ? words : words + '_';
}

bool has_word(const std::string& identifier, std::string_view word) {
    if (std::isupper(static_cast<unsigned char>(word.front())) != 0) return identifier == word;
    return words_of(identifier).find("_" + std::string(word) + "_") != std::string::npos;
}

TEST(NamesTest, FindsOldWordsInIdentifiersAlone) {
    EXPECT_TRUE(has_word("ToldDoubt", "told"));
    EXPECT_TRUE(has_word("told_", "told"));
    EXPECT_TRUE(has_word("KeptBlocks", "kept_blocks"));
    EXPECT_TRUE(has_word("remove_former_files", "former"));
    EXPECT_FALSE(has_word("transformer", "former"));
    EXPECT_FALSE(has_word("coloured_mesh", "Coloured"));
    EXPECT_TRUE(has_word("Coloured", "Coloured"));
    const std::string text =
        "int told_1 = 1'000;  // told_2\n/* told_3\n*/ f(\"told_4\", 't', told_5);\n"
        "g(R\"x(told_6\")x\", told_7);";
    std::string found;
    for (const auto& [identifier, line] : identifiers_of(text))
        found += identifier + ":" + std::to_string(line) + " ";
    EXPECT_EQ(found, "int:1 told_1:1 f:3 told_5:3 g:4 told_7:4 ");
}

TEST(NamesTest, AreTermsOfTheField) {
    const fs::path sources = FUMON_SOURCES_FOLDER;
    std::vector<OldWord> words(old_words.begin(), old_words.end());
    if (render_has_new_words)
        words.insert(words.end(), old_words_of_render.begin(), old_words_of_render.end());
    std::map<std::string, std::string> first;  // where each identifier stands first
    int files = 0;
    for (const fs::path& folder : {sources, sources.parent_path() / "shaders"}) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            if (!name.ends_with(".h") && !name.ends_with(".cpp") && !name.ends_with(".glsl"))
                continue;
            ++files;
            std::ifstream file(entry.path());
            std::stringstream text;
            text << file.rdbuf();
            for (const auto& [identifier, line] : identifiers_of(text.str()))
                first.emplace(identifier, entry.path().string() + ':' + std::to_string(line));
        }
    }
    for (const auto& [identifier, place] : first) {
        for (const OldWord& old : words) {
            EXPECT_FALSE(has_word(identifier, old.word))
                << place << ": " << identifier << " has \"" << old.word
                << "\", an old word of this project; the field says: " << old.term;
        }
    }
    EXPECT_GT(files, 500);
}

}  // namespace
