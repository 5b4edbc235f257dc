#include "foreign/variable_names.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "base/data_files.h"
#include "base/error.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

ForeignModel model_of(const toml::table& table) {
    ForeignModel model;
    model.name = table["name"].value_or(std::string());
    model.dry = table["dry"].value_or(0.0);
    if (const toml::array* const others = table["other"].as_array())
        for (const toml::node& node : *others)
            model.other_names.push_back(node.value_or(std::string()));
    for (const QuantityFacts& facts : quantities()) {
        const toml::array* const list = table[facts.key].as_array();
        if (list == nullptr) continue;
        QuantityNames names{facts.quantity, {}};
        for (const toml::node& node : *list) names.names.push_back(node.value_or(std::string()));
        names.grows_downward = table[fmt::format("{}_positive", facts.key)] == "down";
        model.quantities.push_back(std::move(names));
    }
    return model;
}

std::vector<ForeignModel> read_models() {
    const auto file = data_file("assets/models/variables.toml");
    std::ifstream stream(file);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    const toml::table root =
        parse_toml(text, file.string(), "a table of variables' names has [[model]]");
    std::vector<ForeignModel> models;
    if (const toml::array* list = root["model"].as_array()) {
        for (const toml::node& node : *list)
            if (const toml::table* table = node.as_table()) models.push_back(model_of(*table));
    }
    if (models.empty()) throw Error(fmt::format("{}: has no [[model]]", file.string()));
    return models;
}

}  // namespace

const std::vector<ForeignModel>& foreign_models() {
    static const std::vector<ForeignModel> models = read_models();
    return models;
}

}  // namespace fumon
