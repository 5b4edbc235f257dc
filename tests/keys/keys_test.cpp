#include "keys/keys.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "keys/describe_key.h"
#include "keys/key_value.h"

namespace fumon {
namespace {

enum class Fruit { apple, pear, plum };

/// Every type of key, bound to a value of its own.
struct Everything {
    bool truth = true;
    std::int64_t whole = 3;
    double real = 0.25;
    std::string text = "text";
    Fruit fruit = Fruit::pear;
    WordOrReal either{"auto", 0.0};
    std::vector<double> reals{1.0};
    std::vector<std::int64_t> wholes{2};
    std::vector<std::string> texts{"one"};

    KeyTable keys() {
        KeyTable table;
        table.boolean("truth", truth, {.help = "of it"});
        table.integer("whole", whole, {.unit = "steps", .range = {0, 9}, .help = "of them"});
        table.role(KeyRole::look);
        table.real("real", real, {.help = "of it"});
        table.text("text", text, {.help = "of it"});
        table.choice("list.0.fruit", fruit,
                     {{Fruit::plum, "blue", "a plum"}, {Fruit::pear, "green", "a pear"}},
                     {.help = "which fruit"});
        table.word_or_real("either", either, {{"auto", "by itself"}}, {.help = "of it"});
        table.real_list("reals", reals, 0, 9, {.help = "of them"});
        table.integer_list("wholes", wholes, {.help = "of them"});
        table.text_list("texts", texts, {.help = "of them"});
        return table;
    }
};

TEST(Choices, AWordBelongsToItsEnumeratorWhateverTheirOrder) {
    Everything all;
    const KeyTable table = all.keys();
    const auto& target = std::get<ChoiceTarget>(table.find("list.0.fruit")->target);
    EXPECT_EQ(target.word(), "green");
    EXPECT_TRUE(target.choose("blue"));
    EXPECT_EQ(all.fruit, Fruit::plum);
    EXPECT_EQ(target.word(), "blue");
    EXPECT_FALSE(target.choose("red"));
    EXPECT_EQ(all.fruit, Fruit::plum) << "an unknown word changes nothing";
    all.fruit = Fruit::apple;
    EXPECT_THROW(static_cast<void>(target.word()), std::logic_error) << "an apple has no word";
}

TEST(KeyValues, AreCopiedWhateverTheirType) {
    Everything from;
    from = {false, 4, 0.5, "other", Fruit::plum, {"", 2.0}, {3.0, 4.0}, {}, {"two"}};
    Everything to;
    const KeyTable source = from.keys();
    const KeyTable target = to.keys();
    for (const Key& key : target.keys()) {
        EXPECT_NE(value_text(key), value_text(*source.find(key.path)));
        copy_value(*source.find(key.path), key);
        EXPECT_EQ(value_text(key), value_text(*source.find(key.path)));
    }
    EXPECT_EQ(to.fruit, Fruit::plum);
    EXPECT_EQ(to.reals, from.reals);
}

TEST(KeyRoles, HoldForTheKeysThatFollow) {
    Everything all;
    const KeyTable table = all.keys();
    EXPECT_EQ(table.find("whole")->role, KeyRole::parameter) << "where nothing is said";
    EXPECT_EQ(table.find("real")->role, KeyRole::look);
    EXPECT_EQ(table.find("texts")->role, KeyRole::look);
}

TEST(KeyRoles, HaveANameAndAHelpEach) {
    std::set<std::string_view> names;
    int number = 0;
    for (const KeyRoleText& role : key_roles()) {
        EXPECT_EQ(static_cast<int>(role.role), number++) << "all of them";
        EXPECT_TRUE(names.insert(role.name).second) << role.name;
        EXPECT_FALSE(role.help.empty());
        EXPECT_EQ(role_name(role.role), role.name);
    }
    EXPECT_EQ(static_cast<int>(KeyRole::figure) + 1, number) << "figure is the last";
}

TEST(KeyDescriptions, TellTypeUnitRangeDefaultRoleAndWords) {
    Everything all;
    const KeyTable table = all.keys();
    EXPECT_EQ(describe_key(*table.find("whole")),
              "  whole                        whole number, steps, 0 … 9 [default 3] (parameter)\n"
              "      of them\n");
    EXPECT_EQ(describe_key(*table.find("list.0.fruit")),
              "  list.N.fruit                 choice [default \"green\"] (look)\n"
              "      which fruit\n"
              "        blue               a plum\n"
              "        green              a pear\n");
    const auto json = key_json(*table.find("whole"));
    EXPECT_EQ(json["role"], "parameter");
    EXPECT_EQ(json["default"], "3");
    EXPECT_EQ(json["maximum"], 9.0);
}

TEST(KeyDescriptions, ARequiredKeyHasNoDefault) {
    std::string name;
    KeyTable table;
    table.text("name", name, {.help = "of it", .required = true});
    EXPECT_NE(describe_key(table.keys()[0]).find("[required]"), std::string::npos);
    EXPECT_TRUE(key_json(table.keys()[0])["default"].is_null());
    EXPECT_EQ(key_json(table.keys()[0])["required"], true);
}

}  // namespace
}  // namespace fumon
