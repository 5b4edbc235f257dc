#include "film/panes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/elementary.h"
#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "film/lettering.h"

namespace fumon {

namespace {

constexpr double label_size_ratio = 0.85;  // of a caption's letters
constexpr double strip_height_em = 1.7;    // font sizes
constexpr double scale_length_em = 3.6;    // font sizes, of the line of values
constexpr Ink dark_ink{0.063, 0.063, 0.063, 1.0};
constexpr Ink pale_ink{0.62, 0.62, 0.62, 1.0};

double font_of(const Film& film, const FilmSize& size) {
    const double side = static_cast<double>(std::min(size.width, size.height));
    return std::max(6.0, label_size_ratio * film.settings.cap_height / cap_height_em * side /
                             usual_side_pixels);
}

bool is_grid(const Film& film) {
    return film.panes.show == PanesShow::grid;
}

/// A line over all values of what differs, with a dot at one of them.
void draw_scale(Canvas& canvas, const CanvasBox& box, const std::vector<double>& values,
                double own) {
    const double low = std::ranges::min(values);
    const double high = std::ranges::max(values);
    const double middle = box.y + 0.5 * box.height;
    const auto place = [&](double value) {
        return box.x + box.width * (value - low) / (high - low);
    };
    const double line = 0.06 * canvas.font_size();
    const std::array<CanvasPoint, 2> whole{{{box.x, middle}, {box.x + box.width, middle}}};
    canvas.stroke(whole, line, pale_ink);
    for (const double value : values) {
        const double tick = 0.18 * canvas.font_size();
        const std::array<CanvasPoint, 2> mark{
            {{place(value), middle - tick}, {place(value), middle + tick}}};
        canvas.stroke(mark, line, pale_ink);
    }
    canvas.fill_circle({place(own), middle}, 0.24 * canvas.font_size(), white_ink);
}

/// A run's file, with its folder where another run's has the same name.
std::string file_label_of(const FilmRuns& runs, std::size_t run) {
    const std::filesystem::path file = runs.beds(run).name();
    for (std::size_t one = 0; one < runs.size(); ++one) {
        const std::filesystem::path other = runs.beds(one).name();
        if (one == run || other.filename() != file.filename()) continue;
        return (file.parent_path().filename() / file.filename()).string();
    }
    return file.filename().string();
}

/// What stands above a run: of other models' results the file, and the model where these differ.
std::string label_of(const Film& film, const FilmRuns& runs, std::size_t run) {
    const auto model_of = [&](std::size_t one) {
        const ForeignRun* foreign = runs.beds(one).foreign();
        return foreign == nullptr ? std::string("fumon") : foreign->model;
    };
    if (!film.panes.label.empty() || runs.beds(run).foreign() == nullptr)
        return runs.label(film, run);
    const std::string own = model_of(run);
    bool differs = false;
    for (std::size_t one = 0; one < runs.size(); ++one) differs |= model_of(one) != own;
    const std::string file = file_label_of(runs, run);
    return differs && !own.empty() ? fmt::format("{}: {}", own, file) : file;
}

/// A label in the middle of a strip, and what varies beside it; smaller where it is too long.
void draw_label(Canvas& canvas, const CanvasBox& strip, const std::string& text,
                const std::vector<double>& values, std::size_t run, double font) {
    const bool scaled = !values.empty() && std::ranges::min(values) < std::ranges::max(values);
    const double room = strip.width - font;
    const double beside = scaled ? (scale_length_em + 0.8) * font : 0.0;
    const double length = canvas.text_size(text)[0];
    const bool fits = length + beside <= room;
    const double shrunk = fits ? 1.0 : std::min(1.0, room / length);
    const double all = shrunk * length + (fits ? beside : 0.0);
    const double left = strip.x + 0.5 * (strip.width - all);
    canvas.write(text, {left, strip.y + 0.5 * strip.height}, {0.0, 0.5}, white_ink, shrunk);
    if (fits && scaled)
        draw_scale(
            canvas,
            {left + all - scale_length_em * font, strip.y, scale_length_em * font, strip.height},
            values, values[run]);
}

}  // namespace

int pane_columns(std::size_t count, const FilmSize& size) {
    constexpr double best_shape = 4.0 / 3.0;
    constexpr double weight_of_gaps = 3.0;
    int best = 1;
    double least = 1e9;
    for (int columns = 1; columns <= most_pane_columns; ++columns) {
        const int rows = (static_cast<int>(count) + columns - 1) / columns;
        if (rows > most_pane_columns || columns > static_cast<int>(count)) continue;
        const double shape =
            static_cast<double>(size.width) / columns / (static_cast<double>(size.height) / rows);
        const double gaps = 1.0 - static_cast<double>(count) / (columns * rows);
        const double fault = std::abs(elementary::log(shape / best_shape)) + weight_of_gaps * gaps;
        if (fault >= least) continue;
        least = fault;
        best = columns;
    }
    return best;
}

Panes::Panes(const Film& film, const FilmRuns& runs, const FilmSize& size)
    : font_(font_of(film, size)),
      ground_(static_cast<int>(size.width), static_cast<int>(size.height)) {
    if (!is_grid(film) && runs.size() != 2) {
        throw InputError(
            fmt::format("{}panes.show = \"{}\" takes two runs, not {}", film.at("panes.show"),
                        film.panes.show == PanesShow::wipe ? "wipe" : "difference", runs.size()));
    }
    place(film, runs, size);
    if (runs.size() > 1) write_labels(film, runs);
}

void Panes::place(const Film& film, const FilmRuns& runs, const FilmSize& size) {
    const auto width = static_cast<int>(size.width);
    const auto height = static_cast<int>(size.height);
    const int count = is_grid(film) ? static_cast<int>(runs.size()) : 1;
    int columns = static_cast<int>(film.panes.columns);
    if (columns == 0)
        columns = runs.grid_columns().value_or(pane_columns(static_cast<std::size_t>(count), size));
    columns = std::min(columns, count);
    const int rows = (count + columns - 1) / columns;
    const int gap = count > 1 ? std::max(2, std::min(width, height) / 270) : 0;
    strip_ = runs.size() > 1 ? static_cast<int>(std::ceil(strip_height_em * font_)) : 0;
    const int across = (width - gap * (columns - 1)) / columns;
    const int down = (height - gap * (rows - 1)) / rows;
    if (across < smallest_film_side || down - strip_ < smallest_film_side) {
        throw InputError(fmt::format(
            "{}{} runs side by side do not fit into {} x {} pixels; take a larger film.size, or a "
            "smaller film.cap_height",
            film.at("film.size"), count, width, height));
    }
    for (int i = 0; i < count; ++i) {
        const int row = i / columns;
        const int in_row = std::min(columns, count - row * columns);
        const int left = (width - in_row * across - (in_row - 1) * gap) / 2;
        const int top = (height - rows * down - (rows - 1) * gap) / 2;
        boxes_.push_back({left + i % columns * (across + gap), top + row * (down + gap) + strip_,
                          across, down - strip_});
    }
}

void Panes::write_labels(const Film& film, const FilmRuns& runs) {
    Canvas canvas(ground_.width, ground_.height, font_);
    canvas.fill(CanvasBox{0.0, 0.0, canvas.width(), canvas.height()}, dark_ink);
    const std::vector<double> values = film.panes.scale ? runs.values() : std::vector<double>{};
    const auto strip_of = [&](const PaneBox& box) {
        return CanvasBox{static_cast<double>(box.x), static_cast<double>(box.y - strip_),
                         static_cast<double>(box.width), static_cast<double>(strip_)};
    };
    if (film.panes.show == PanesShow::grid) {
        for (std::size_t run = 0; run < runs.size(); ++run)
            draw_label(canvas, strip_of(boxes_[run]), label_of(film, runs, run), values, run,
                       font_);
    } else if (film.panes.show == PanesShow::wipe) {
        CanvasBox half = strip_of(boxes_.front());
        half.width *= 0.5;
        draw_label(canvas, half, label_of(film, runs, 0), values, 0, font_);
        half.x += half.width;
        draw_label(canvas, half, label_of(film, runs, 1), values, 1, font_);
    } else {
        draw_label(canvas, strip_of(boxes_.front()),
                   fmt::format("{}  minus  {}", label_of(film, runs, 0), label_of(film, runs, 1)),
                   {}, 0, font_);
    }
    missing_ = canvas.missing_letters();
    ground_ = canvas.image();
}

void copy_into(Image& whole, const Image& part, const PaneBox& box) {
    for (int y = 0; y < part.height; ++y)
        std::copy_n(part.row(y), 3 * part.width, whole.row(box.y + y) + std::ptrdiff_t{3} * box.x);
    if (!part.transparent() && !whole.transparent()) return;
    if (!whole.transparent()) whole = with_alpha(std::move(whole));
    for (int y = 0; y < part.height; ++y) {
        auto* out = whole.alpha.data() + std::ptrdiff_t{box.y + y} * whole.width + box.x;
        if (part.transparent())
            std::copy_n(part.alpha.data() + std::ptrdiff_t{y} * part.width, part.width, out);
        else
            std::fill_n(out, part.width, std::uint8_t{255});
    }
}

Image wiped(Image left, const Image& right, double share) {
    constexpr std::uint8_t line = 255;
    const int at = static_cast<int>(std::lround(share * left.width));
    const int half = std::max(1, left.width / 1280);
    const int from = std::clamp(at - half, 0, left.width);
    const int to = std::clamp(at + half, 0, left.width);
    for (int y = 0; y < left.height; ++y) {
        std::uint8_t* row = left.row(y);
        std::copy(right.row(y) + std::ptrdiff_t{3} * at,
                  right.row(y) + std::ptrdiff_t{3} * right.width, row + std::ptrdiff_t{3} * at);
        std::fill(row + std::ptrdiff_t{3} * from, row + std::ptrdiff_t{3} * to, line);
        if (!left.transparent()) continue;
        auto* alpha = left.alpha.data() + std::ptrdiff_t{y} * left.width;
        const auto* other = right.alpha.data() + std::ptrdiff_t{y} * left.width;
        std::copy(other + at, other + right.width, alpha + at);
        std::fill(alpha + from, alpha + to, line);
    }
    return left;
}

}  // namespace fumon
