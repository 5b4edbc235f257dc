#include "paper/caption/caption_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/find_named.h"
#include "figure/words/words.h"
#include "keys/key_value.h"
#include "keys/keys.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// Symbols by which papers call a parameter.
struct Symbol {
    std::string_view key;
    std::string_view symbol;
};

constexpr std::array<Symbol, 10> symbols{{{"model.hop_base", "L_{0}"},
                                          {"model.hop_per_height", "b"},
                                          {"model.hop_slope_factor", "α"},
                                          {"model.exponential_base", "a"},
                                          {"model.exponential_height", "h_{0}"},
                                          {"model.exponential_length", "N′_{x}"},
                                          {"model.amount", "q_{0}"},
                                          {"model.amount_slope_factor", "β"},
                                          {"model.creep_rate", "D"},
                                          {"model.flank_rate", "E"}}};

std::string key_text(const Key& key) {
    const Symbol* known = find_by(symbols, &Symbol::key, std::string_view(key.path));
    const std::string name =
        known == nullptr ? key.path : fmt::format("{} ({})", known->symbol, key.path);
    const std::string& unit = key.notes.unit;
    return fmt::format("{} = {}{}", name, value_text(key),
                       unit.empty() ? "" : fmt::format(" {}", unit_word(unit)));
}

/// A model's default scene with lists as long as those of another table, whose items have their
/// defaults too.
KeyTable defaults_beside(Scene& usual, const KeyTable& keys) {
    KeyTable defaults = scene_keys(usual);
    for (const TableList& list : keys.lists()) {
        const TableList* own =
            list.role == KeyRole::parameter ? defaults.find_list(list.path) : nullptr;
        if (own != nullptr) own->resize(list.size());
    }
    return scene_keys(usual);
}

}  // namespace

CaptionFacts::CaptionFacts(const std::vector<CaptionRun>& runs) {
    for (const CaptionRun& run : runs) runs_.push_back(facts_of(run));
}

CaptionFacts::Facts CaptionFacts::facts_of(const CaptionRun& run) {
    Scene written = *run.scene;
    Scene usual = default_scene(written.model.name);
    const KeyTable keys = scene_keys(written);
    const KeyTable defaults = defaults_beside(usual, keys);
    Facts facts;
    facts.push_back({"model.name", phrase("model {}", written.model.name), false, true});
    facts.push_back({"run.steps", phrase("{} steps", written.run.steps), false, true});
    for (const Key& key : keys.keys()) {
        if (key.role != KeyRole::parameter || key.path == "run.steps" || key.path == "model.name")
            continue;
        if (std::ranges::find(run.varied, key.path) != run.varied.end()) continue;
        const bool always = key.path == "grid.nx" || key.path == "grid.ny";
        const Key* of_model = defaults.find(key.path);
        const bool is_usual =
            !always && of_model != nullptr && value_text(key) == value_text(*of_model);
        facts.push_back({key.path, key_text(key), is_usual, false});
    }
    if (!written.bed.file.empty())
        facts.push_back({"bed.file", phrase("initial bed {}", written.bed.file), false, false});
    return facts;
}

bool CaptionFacts::is_shared(const Fact& fact) const {
    return std::ranges::all_of(runs_, [&](const Facts& facts) {
        const Fact* same = find_by(facts, &Fact::key, fact.key);
        return same != nullptr && same->text == fact.text;
    });
}

std::string CaptionFacts::sentence(const std::vector<const Fact*>& facts) {
    std::string text;
    bool after_heading = false;
    for (const Fact* fact : facts) {
        if (!text.empty()) text += after_heading && !fact->heading ? ": " : ", ";
        text += fact->text;
        after_heading = fact->heading;
    }
    return text;
}

std::string CaptionFacts::shared() const {
    std::vector<const Fact*> listed;
    if (!runs_.empty()) {
        for (const Fact& fact : runs_.front()) {
            if (!fact.usual && is_shared(fact)) listed.push_back(&fact);
        }
    }
    return sentence(listed);
}

std::string CaptionFacts::own(std::size_t run) const {
    std::vector<const Fact*> listed;
    for (const Fact& fact : runs_[run]) {
        if (is_shared(fact)) continue;
        const bool differs = std::ranges::any_of(runs_, [&](const Facts& facts) {
            const Fact* other = find_by(facts, &Fact::key, fact.key);
            return other != nullptr && other->text != fact.text;
        });
        if (differs || !fact.usual) listed.push_back(&fact);
    }
    return sentence(listed);
}

}  // namespace fumon
