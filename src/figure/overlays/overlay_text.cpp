#include "figure/overlays/overlay_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/quantity_text.h"
#include "figure/panels/step_text.h"
#include "figure/words/words.h"
#include "keys/keys.h"
#include "scene/placeholders.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

constexpr double parameter_text_size_em = 0.85;  // of the font size
constexpr double title_text_size_em = 1.15;

/// Seconds of a step, or grains of a pile's, where the model's parameters say them.
std::optional<double> length_of_step(const Scene& scene) {
    Scene copy = scene;  // the table binds to writable values
    const KeyTable table = scene_keys(copy);
    if (const Key* grains = table.find("model.grains_per_step"); grains != nullptr)
        return static_cast<double>(*std::get<std::int64_t*>(grains->target));
    const Key* key = table.find("model.time_step");
    if (key == nullptr || !std::holds_alternative<double*>(key->target)) return std::nullopt;
    return *std::get<double*>(key->target);
}

/// How many decimals tell the multiples of a number apart, at most `most`.
int decimals_of(double number, int most) {
    constexpr double rounding = 1e-6;
    for (int decimals = 0; decimals < most; ++decimals) {
        const double scaled = number * elementary::pow(10.0, decimals);
        if (std::abs(scaled - std::round(scaled)) < rounding * std::max(1.0, scaled))
            return decimals;
    }
    return most;
}

/// A key's value as one reads it: "60", where the scene's text says 60.0.
std::optional<std::string> shown_value(const Scene& scene, const std::string& key) {
    std::optional<std::string> text = key_text(scene, key);
    if (!text || !text->ends_with(".0")) return text;
    const bool number = text->find_first_not_of("-0123456789.") == std::string::npos;
    if (number) text->resize(text->size() - 2);
    return text;
}

/// Times of which one has the longest text of a run. Where the length of a step is not known, those
/// below 1 and below 10 have decimals, and the run may end among them.
std::vector<double> times_of_widest(const TimeText& times, const std::optional<double>& known_end) {
    std::vector<double> found{times.end.value_or(static_cast<double>(times.last))};
    if (known_end) found.push_back(*known_end);
    if (times.decimals == TimeText::by_size) found.insert(found.end(), {0.88, 8.8});
    return found;
}

class TextOverlay : public Overlay {
  public:
    TextOverlay(const OverlayScene& on, std::size_t number, std::string text, double text_size,
                bool bold)
        : scene_(on.scene),
          times_(time_text_of(on.scene, on.first)),
          text_(std::move(text)),
          text_size_(text_size),
          bold_(bold) {
        try {
            widest_.push_back(filled_text(text_, scene_, times_, 0, 0.0));
            for (const double time : times_of_widest(times_, on.end_time))
                widest_.push_back(filled_text(text_, scene_, times_, times_.last, time));
        } catch (const InputError& fault) {
            throw KeyError(overlay_key(number, "text"), fault.what());
        }
    }

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        FurnitureSize most;
        for (const std::string& text : widest_) {
            const auto [width, height] = canvas.text_size(text, text_size_, bold_);
            most = {std::max(most.width, width), std::max(most.height, height)};
        }
        return most;
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        return filled_text(text_, scene_, times_, frame.snapshot.step, frame.snapshot.time);
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const std::string text = appearance_in(frame);
        const auto [width, height] = canvas.text_size(text, text_size_, bold_);
        // A frame beyond the scene's end may say more than any that the plate was measured for.
        const double fits =
            std::min({1.0, box.width / std::max(width, 1.0), box.height / std::max(height, 1.0)});
        canvas.write(text, {box.x, box.y + 0.5 * box.height}, {0.0, 0.5}, black_ink,
                     fits * text_size_, false, bold_);
    }

  private:
    const Scene& scene_;
    TimeText times_;
    std::string text_;
    std::vector<std::string> widest_;  ///< of the texts of all frames, one of these
    double text_size_;
    bool bold_;
};

std::string chosen_text(const OverlayScene& on, std::size_t number, const std::string& usual) {
    const OverlaySettings& settings = on.scene.view.overlays[number];
    return settings.text.empty() ? usual : settings.text;
}

/// "hop base = 10 sites", of a key.
std::string parameter_text_of(const Scene& scene, const Key& key) {
    const std::string name = name_in_words(key.path.substr(key.path.rfind('.') + 1));
    const std::string value = shown_value(scene, key.path).value_or("");
    const std::string unit = key.notes.unit.empty() ? "" : " " + unit_word(key.notes.unit);
    return fmt::format("{} = {}{}", name, value, unit);
}

class ParameterLine : public Overlay {
  public:
    explicit ParameterLine(const OverlayScene& on, std::size_t number)
        : widest_(0.5 * static_cast<double>(on.scene.view.image.width)) {
        Scene copy = on.scene;  // the table binds to writable values
        const KeyTable table = scene_keys(copy);
        for (const std::string& name : on.scene.view.overlays[number].keys) {
            if (const Key* key = table.find(name))
                parts_.push_back(parameter_text_of(on.scene, *key));
        }
    }

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        const auto size = canvas.text_size(broken(canvas), parameter_text_size_em);
        return {size[0], size[1]};
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& /*frame*/) const override {
        return "";
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& /*frame*/) const override {
        canvas.write(broken(canvas), {box.x, box.y}, {0.0, 0.0}, black_ink, parameter_text_size_em);
    }

  private:
    [[nodiscard]] std::string broken(const Canvas& canvas) const {
        std::string text;
        std::string line;
        for (const std::string& part : parts_) {
            const std::string longer = line.empty() ? part : fmt::format("{},  {}", line, part);
            if (!line.empty() && canvas.text_size(longer, parameter_text_size_em)[0] > widest_) {
                text += line + ",\n";
                line = part;
            } else {
                line = longer;
            }
        }
        return text + line;
    }

    std::vector<std::string> parts_;
    double widest_;
};

}  // namespace

std::string TimeText::operator()(double time) const {
    const int by_its_size = time <= 0.0 || time >= 10.0 ? 0 : time < 1.0 ? 2 : 1;
    return with_commas(time, decimals == by_size ? by_its_size : decimals) + " " + unit_word(unit);
}

std::string TimeText::in(const std::string& wanted, double time) const {
    const std::optional<double> factor = time_factor(unit, wanted);
    if (!factor) {
        throw InputError(
            unit == "steps"
                ? fmt::format("{{time:{}}}: this model counts steps and has no time", wanted)
                : fmt::format(
                      "{{time:{}}}: a time in {} can be shown in µs, ms, s, min, h, d or yr",
                      wanted, unit));
    }
    constexpr int most_decimals = 2;
    TimeText own = *this;
    own.unit = wanted;
    if (end && last > 0)
        own.decimals = decimals_of(*factor * *end / static_cast<double>(last), most_decimals);
    return own(*factor * time);
}

namespace {

/// Of a run of fumon's own.
TimeText time_text_of_steps(const Scene& scene, const Snapshot& first) {
    constexpr int most_decimals = 6;
    const std::int64_t last = scene.run.steps;
    const auto steps = static_cast<double>(last);
    if (first.time_unit == "steps") return {first.time_unit, 0, last, steps};
    const std::optional<double> length = length_of_step(scene);
    if (!length) return {first.time_unit, TimeText::by_size, last, {}};
    return {first.time_unit, decimals_of(*length, most_decimals), last, steps * *length};
}

}  // namespace

TimeText time_text_of(const Scene& scene, const Snapshot& first) {
    TimeText text = time_text_of_steps(scene, first);
    text.date = first.date;
    return text;
}

std::string filled_text(const std::string& text, const Scene& scene, const TimeText& times,
                        std::int64_t step, double time) {
    return fill_placeholders(text, [&](const std::string& name) -> std::optional<std::string> {
        if (name == "title") return scene.title;
        if (name == "step") return with_commas(step);
        if (name == "time") return times(time);
        if (constexpr std::string_view in_unit = "time:"; name.starts_with(in_unit))
            return times.in(name.substr(in_unit.size()), time);
        if (name == "date") {
            if (times.date) return times.date(time);
            throw InputError("{date}: the times of this run have no date; write {time}");
        }
        if (name == "seed") return fmt::format("{}", scene.seed);
        return shown_value(scene, name);
    });
}

/// The scene's title, or another text; none where the scene has no title.
std::unique_ptr<Overlay> make_title_overlay(const OverlayScene& on, std::size_t number) {
    const std::string text = chosen_text(on, number, "{title}");
    if (text == "{title}" && on.scene.title.empty()) {
        throw KeyError(
            overlay_key(number, "kind"),
            fmt::format("overlay.{} shows the scene's title, but the scene has none; write "
                        "title = \"…\" or overlay.{}.text",
                        number, number));
    }
    return std::make_unique<TextOverlay>(on, number, text, title_text_size_em, true);
}

std::unique_ptr<Overlay> make_time_overlay(const OverlayScene& on, std::size_t number) {
    const bool steps_only = on.first.time_unit == "steps";
    const std::string usual = on.first.date ? "{date}"
                              : steps_only  ? word("step {step}")
                                            : word("t = {time},  step {step}");
    std::string text = chosen_text(on, number, usual);
    if (on.time_note == TimeNote::held) text += "\n" + word("held between records");
    if (on.time_note == TimeNote::blended) text += "\n" + word("blended between records");
    return std::make_unique<TextOverlay>(on, number, text, 1.0, false);
}

/// The values of overlay.keys in a line, which breaks where it is wider than half of the picture.
std::unique_ptr<Overlay> make_parameters_overlay(const OverlayScene& on, std::size_t number) {
    return std::make_unique<ParameterLine>(on, number);
}

std::string overlay_key(std::size_t number, const std::string& key) {
    return fmt::format("overlay.{}.{}", number, key);
}

}  // namespace fumon
