#include "bmi/saved_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/error.h"
#include "base/find_named.h"
#include "base/state_archive.h"

namespace fumon {

namespace {

class Saver : public StateArchive {
  public:
    explicit Saver(std::vector<SavedState::Entry>& entries) : entries_(entries) {}

    void values(std::string_view name, std::span<double> values) override {
        entries_.push_back({std::string(name), std::vector<double>(values.begin(), values.end())});
    }
    void values(std::string_view name, std::span<std::int64_t> values) override {
        entries_.push_back(
            {std::string(name), std::vector<std::int64_t>(values.begin(), values.end())});
    }
    void list(std::string_view name, std::vector<double>& values) override {
        entries_.push_back({std::string(name), values});
    }
    void list(std::string_view name, std::vector<std::int64_t>& values) override {
        entries_.push_back({std::string(name), values});
    }
    void text(std::string_view name, std::string& text) override {
        entries_.push_back({std::string(name), text});
    }
    [[noreturn]] void refuse(const std::string& why) const override { throw InputError(why); }

  private:
    std::vector<SavedState::Entry>& entries_;
};

class Restorer : public StateArchive {
  public:
    explicit Restorer(const std::vector<SavedState::Entry>& entries) : entries_(entries) {}

    void values(std::string_view name, std::span<double> values) override { fill(name, values); }
    void values(std::string_view name, std::span<std::int64_t> values) override {
        fill(name, values);
    }
    void list(std::string_view name, std::vector<double>& values) override {
        values = next<std::vector<double>>(name);
    }
    void list(std::string_view name, std::vector<std::int64_t>& values) override {
        values = next<std::vector<std::int64_t>>(name);
    }
    void text(std::string_view name, std::string& text) override { text = next<std::string>(name); }
    [[noreturn]] void refuse(const std::string& why) const override {
        throw InputError("the state does not fit the model: " + why);
    }

  private:
    template <class Held>
    const Held& next(std::string_view name) {
        const SavedState::Entry* entry = at_ < entries_.size() ? &entries_[at_++] : nullptr;
        const Held* held = entry == nullptr ? nullptr : std::get_if<Held>(&entry->values);
        if (held == nullptr || entry->name != name)
            refuse(fmt::format("it has no {} at this position", name));
        return *held;
    }
    template <class Number>
    void fill(std::string_view name, std::span<Number> values) {
        const auto& held = next<std::vector<Number>>(name);
        if (held.size() != values.size()) refuse(fmt::format("its {} has a different size", name));
        std::ranges::copy(held, values.begin());
    }

    const std::vector<SavedState::Entry>& entries_;
    std::size_t at_ = 0;
};

}  // namespace

SavedState::SavedState(Model& model) {
    Saver saver(entries_);
    model.serialise(saver);
}

bool SavedState::take(std::string_view name, const SavedState& other) {
    const Entry* theirs = find_named(other.entries_, name);
    const auto mine = std::ranges::find(entries_, name, &Entry::name);
    if (theirs == nullptr || mine == entries_.end()) return false;
    mine->values = theirs->values;
    return true;
}

void SavedState::restore(Model& model) const {
    Restorer restorer(entries_);
    model.serialise(restorer);
}

}  // namespace fumon
