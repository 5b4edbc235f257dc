#include "picture/box_average.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

namespace {

/// How much of pixel `pixel` lies in box `box`, where `pixels` of them are cut into `boxes`, in
/// units of a boxes-th of a pixel.
std::int64_t overlap(int pixel, int box, int pixels, int boxes) {
    const auto begin = std::max(std::int64_t{pixel} * boxes, std::int64_t{box} * pixels);
    const auto end = std::min((std::int64_t{pixel} + 1) * boxes, (std::int64_t{box} + 1) * pixels);
    return std::max<std::int64_t>(end - begin, 0);
}

int first_pixel(int box, int pixels, int boxes) {
    return static_cast<int>(std::int64_t{box} * pixels / boxes);
}

/// One past the last pixel that reaches into the box.
int end_pixel(int box, int pixels, int boxes) {
    return static_cast<int>(((std::int64_t{box} + 1) * pixels + boxes - 1) / boxes);
}

void add_row(const std::uint8_t* row, std::uint32_t weight, std::vector<std::uint32_t>& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * row[i];
}

}  // namespace

BoxSums box_sums(const Image& image, int columns, int rows) {
    BoxSums boxes;
    boxes.area = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
    boxes.sums.reserve(std::size_t{3} * static_cast<std::size_t>(columns) *
                       static_cast<std::size_t>(rows));
    std::vector<std::uint32_t> column_sums(std::size_t{3} * static_cast<std::size_t>(image.width));
    for (int box_y = 0; box_y < rows; ++box_y) {
        std::fill(column_sums.begin(), column_sums.end(), 0U);
        const int end_y = end_pixel(box_y, image.height, rows);
        for (int y = first_pixel(box_y, image.height, rows); y < end_y; ++y) {
            add_row(image.row(y), static_cast<std::uint32_t>(overlap(y, box_y, image.height, rows)),
                    column_sums);
        }
        for (int box_x = 0; box_x < columns; ++box_x) {
            std::uint64_t sum[3] = {};
            const int end_x = end_pixel(box_x, image.width, columns);
            for (int x = first_pixel(box_x, image.width, columns); x < end_x; ++x) {
                const auto weight =
                    static_cast<std::uint64_t>(overlap(x, box_x, image.width, columns));
                const std::uint32_t* pixel =
                    &column_sums[std::size_t{3} * static_cast<std::size_t>(x)];
                for (std::size_t channel = 0; channel < 3; ++channel)
                    sum[channel] += weight * pixel[channel];
            }
            boxes.sums.insert(boxes.sums.end(), std::begin(sum), std::end(sum));
        }
    }
    return boxes;
}

}  // namespace fumon
