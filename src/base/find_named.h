#pragma once

#include <algorithm>
#include <ranges>
#include <string_view>

namespace fumon {

/// The first of some items whose `member` (a pointer to one, or a function of the item) equals
/// `value`; null where there is none. The items outlive the pointer: they are no temporary.
template <std::ranges::borrowed_range Items, class Value, class Member>
constexpr auto* find_by(Items&& items, Member member, const Value& value) {
    const auto found = std::ranges::find(items, value, member);
    return found == std::ranges::end(items) ? nullptr : &*found;
}

/// The first of some items whose `name` is this one; null where there is none.
template <std::ranges::borrowed_range Items>
constexpr auto* find_named(Items&& items, std::string_view name) {
    return find_by(
        items, [](const auto& item) -> const auto& { return item.name; }, name);
}

}  // namespace fumon
