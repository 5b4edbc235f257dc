#include "foreign/field_choice.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "files/terrain/wanted_unit.h"
#include "files/unit_conversion.h"
#include "foreign/netcdf_place.h"
#include "foreign/netcdf_times.h"

namespace fumon {

namespace {

std::string lowered(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

[[noreturn]] void refuse(const std::string& file, std::string_view what, std::string_view remedy) {
    throw InputError(fmt::format("{}: {}; {}", file, what, remedy));
}

std::string words_of(const ForeignMap& map) {
    return fmt::format("{} ({})", map.variable.name, map.dimensions);
}

std::string listed(const std::vector<ForeignMap>& maps) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < maps.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + words_of(maps[i]);
    return maps.size() > most ? text + " …" : text;
}

bool is_length(const std::string& unit) {
    return unit.empty() || unit == "-" || unit == "?" || metres_per_height(unit).has_value();
}

/// What of the file is chosen so far, and what it is chosen by.
class Choice {
  public:
    Choice(const std::string& file, const std::vector<ForeignMap>& maps, const ForeignModel* model)
        : file_(file), maps_(maps), model_(model) {}

    void take_named(Quantity quantity, const std::string& name) {
        for (const ForeignMap& map : maps_) {
            if (map.variable.name != name) continue;
            return take({quantity, map, "--field"});
        }
        std::vector<std::string> known;
        for (const ForeignMap& map : maps_) known.push_back(map.variable.name);
        refuse(file_, fmt::format("has no map \"{}\" to be its {}", name, facts_of(quantity).name),
               known.empty() ? "it has none at all" : suggestion(name, known));
    }

    void take_standard(Quantity quantity) {
        if (has(quantity)) return;
        std::vector<ForeignMap> fitting;
        for (const ForeignMap& map : maps_)
            if (may_be(map, quantity) && quantity_of_standard_name(map.standard_name) == quantity)
                fitting.push_back(map);
        if (std::ranges::any_of(fitting, &ForeignMap::over_time))
            std::erase_if(fitting, [](const ForeignMap& map) { return !map.over_time; });
        if (fitting.empty()) return;
        if (fitting.size() > 1) keep_preferred(quantity, fitting);
        if (fitting.size() > 1)
            refuse(file_,
                   fmt::format("{} maps have the standard name of its {}: {}", fitting.size(),
                               facts_of(quantity).name, listed(fitting)),
                   fmt::format("name one by --field {}={}", facts_of(quantity).key,
                               fitting.front().variable.name));
        const std::string reason = "CF standard name " + fitting.front().standard_name;
        take({quantity, fitting.front(), reason});
    }

    void take_by_model(Quantity quantity, const ForeignModel& model) {
        if (has(quantity)) return;
        const auto entry = std::ranges::find(model.quantities, quantity, &QuantityNames::quantity);
        if (entry == model.quantities.end()) return;
        for (const bool over_time : {true, false}) {
            for (const std::string& name : entry->names) {
                const auto found = std::ranges::find_if(maps_, [&](const ForeignMap& map) {
                    return means(map) && map.known_as == name && map.over_time == over_time &&
                           may_be(map, quantity);
                });
                if (found == maps_.end()) continue;
                const std::string reason =
                    model.name == "others" ? "a common name" : "a name of " + model.name;
                return take({quantity, *found, reason, entry->grows_downward});
            }
        }
    }

    /// The only map of lengths.
    void take_only_bed() {
        std::vector<ForeignMap> lengths;
        for (const ForeignMap& map : maps_)
            if (free(map) && is_length(map.unit)) lengths.push_back(map);
        if (lengths.size() == 1 && chosen_.empty())
            take({Quantity::bed, lengths.front(), "the only map of lengths"});
    }

    [[nodiscard]] bool has(Quantity quantity) const {
        return std::ranges::find(chosen_, quantity, &ChosenMap::quantity) != chosen_.end();
    }
    [[nodiscard]] std::vector<ChosenMap> chosen() && { return std::move(chosen_); }

  private:
    [[nodiscard]] bool free(const ForeignMap& map) const {
        return !taken_.contains(map.variable.name);
    }
    /// Whether the model of the file does not mean something else by a name.
    [[nodiscard]] bool means(const ForeignMap& map) const {
        return model_ == nullptr ||
               std::ranges::find(model_->other_names, map.known_as) == model_->other_names.end();
    }
    /// The water of a run with times is over them; its maxima are not.
    [[nodiscard]] bool may_be(const ForeignMap& map, Quantity quantity) const {
        return free(map) && (quantity == Quantity::bed || map.over_time ||
                             std::ranges::none_of(maps_, &ForeignMap::over_time));
    }
    void take(ChosenMap chosen) {
        taken_.insert(chosen.map.variable.name);
        chosen_.push_back(std::move(chosen));
    }
    /// Of several maps of one standard name the first that the model's table has.
    void keep_preferred(Quantity quantity, std::vector<ForeignMap>& fitting) const {
        if (model_ == nullptr) return;
        const auto entry =
            std::ranges::find(model_->quantities, quantity, &QuantityNames::quantity);
        if (entry == model_->quantities.end()) return;
        for (const std::string& name : entry->names) {
            const auto found = std::ranges::find_if(
                fitting, [&](const ForeignMap& map) { return map.known_as == name; });
            if (found == fitting.end()) continue;
            fitting = {*found};
            return;
        }
    }

    const std::string& file_;
    const std::vector<ForeignMap>& maps_;
    const ForeignModel* model_;
    std::vector<ChosenMap> chosen_;
    std::set<std::string> taken_;
};

}  // namespace

std::vector<ForeignMap> maps_of(const NetcdfInput& input, int records) {
    std::vector<ForeignMap> maps;
    for (BedVariable& variable : map_variables(input)) {
        const std::vector<int> over = input.dimensions(variable.variable);
        if (over.size() == 2 && is_place_variable(variable.name)) continue;
        if (input.dimension_length(variable.x) * input.dimension_length(variable.y) < 2) continue;
        ForeignMap map;
        map.over_time = variable.has_records && variable.records == records;
        if (variable.has_records && !map.over_time && input.dimension_length(variable.records) != 1)
            continue;
        for (const int dimension : over)
            map.dimensions +=
                (map.dimensions.empty() ? "" : ", ") + input.dimension_name(dimension);
        map.standard_name = input.text(variable.variable, "standard_name").value_or("");
        map.unit = input.text(variable.variable, "units").value_or("");
        map.positive = input.text(variable.variable, "positive").value_or("");
        map.known_as = variable.name;
        map.variable = std::move(variable);
        maps.push_back(std::move(map));
    }
    return maps;
}

int dimension_of_records(const NetcdfInput& input) {
    std::map<int, std::size_t> maps;
    for (const BedVariable& variable : map_variables(input))
        if (variable.has_records) ++maps[variable.records];
    int best = -1;
    std::size_t most = 0;
    for (const auto& [dimension, count] : maps) {
        constexpr std::size_t of_time = 1'000'000;  // more than any file has maps
        std::size_t weight = count;
        if (time_variable(input, dimension) || input.dimension_name(dimension) == "time")
            weight += of_time;
        if (weight <= most) continue;
        most = weight;
        best = dimension;
    }
    return best;
}

std::string words_of_file(const NetcdfInput& input) {
    std::string words;
    for (const char* attribute : {"source", "title", "model", "program", "Producer", "history",
                                  "institution", "Conventions"})
        words += " " + input.text(NC_GLOBAL, attribute).value_or("");
    return words;
}

const ForeignModel* model_of_maps(const std::string& said, const std::vector<ForeignMap>& maps) {
    const std::string words = lowered(said);
    for (const ForeignModel& model : foreign_models())
        if (model.name != "others" && words.find(lowered(model.name)) != std::string::npos)
            return &model;
    const ForeignModel* best = nullptr;
    std::size_t most = 0;
    for (const ForeignModel& model : foreign_models()) {
        std::size_t fitting = 0;
        for (const QuantityNames& names : model.quantities) {
            fitting +=
                static_cast<std::size_t>(std::ranges::any_of(maps, [&](const ForeignMap& map) {
                    return std::ranges::find(names.names, map.known_as) != names.names.end();
                }));
        }
        if (fitting <= most) continue;
        most = fitting;
        best = &model;
    }
    return best;
}

std::vector<ChosenMap> choose_maps(const std::string& file, const std::vector<ForeignMap>& maps,
                                   const ForeignModel* model,
                                   const std::map<Quantity, std::string>& named, bool has_bed) {
    Choice choice(file, maps, model);
    for (const auto& [quantity, name] : named) choice.take_named(quantity, name);
    for (const QuantityFacts& facts : quantities()) {
        if (facts.quantity == Quantity::bed && has_bed) continue;
        choice.take_standard(facts.quantity);
        if (model != nullptr) choice.take_by_model(facts.quantity, *model);
    }
    for (const QuantityFacts& facts : quantities()) {
        if (facts.quantity == Quantity::bed && has_bed) continue;
        for (const ForeignModel& other : foreign_models())
            choice.take_by_model(facts.quantity, other);
    }
    if (!has_bed && !choice.has(Quantity::bed)) choice.take_only_bed();
    if (!has_bed && !choice.has(Quantity::bed) &&
        !(choice.has(Quantity::depth) && choice.has(Quantity::level))) {
        if (maps.empty()) refuse(file, "holds no map over two sides", "name another file");
        refuse(file, "no map is known as its bed",
               fmt::format("name it by --field bed=NAME, or bed=FILE of another; it has {}",
                           listed(maps)));
    }
    return std::move(choice).chosen();
}

UnitConversion conversion_of(const std::string& file, const ChosenMap& chosen) {
    const QuantityFacts& facts = facts_of(chosen.quantity);
    const std::string& unit = chosen.map.unit;
    UnitConversion conversion;
    if (!unit.empty() && unit != "-" && unit != "?" && unit != "1") {
        std::optional<UnitConversion> known;
        if (facts.unit == "m") {
            if (const auto metres = metres_per_height(unit)) known = UnitConversion{*metres};
        } else {
            known = unit_conversion(unit, facts.unit);
        }
        if (!known)
            refuse(file,
                   fmt::format("{} is in \"{}\", and cannot be its {}", chosen.map.variable.name,
                               unit, facts.name),
                   fmt::format("a {} becomes {}; name another by --field {}=NAME", facts.name,
                               facts.unit, facts.key));
        conversion = *known;
    }
    const std::string& positive = chosen.map.positive;
    const bool down =
        chosen.quantity == Quantity::bed && (grows_downward(positive, chosen.map.standard_name) ||
                                             (positive.empty() && chosen.grows_downward));
    if (down) {
        conversion.factor = -conversion.factor;
        conversion.offset = -conversion.offset;
    }
    return conversion;
}

}  // namespace fumon
