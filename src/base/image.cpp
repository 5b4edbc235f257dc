#include "base/image.h"

#include <utility>

namespace fumon {

Image composited_on(const Image& image, std::uint8_t grey) {
    Image whole(image.width, image.height);
    if (!image.transparent()) {
        whole.rgb = image.rgb;
        return whole;
    }
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
        const unsigned alpha = image.alpha[i];
        for (std::size_t at = 3 * i; at < 3 * i + 3; ++at) {
            const unsigned both = alpha * image.rgb[at] + (255U - alpha) * grey;
            whole.rgb[at] = static_cast<std::uint8_t>((both + 127U) / 255U);
        }
    }
    return whole;
}

Image with_alpha(Image image) {
    if (!image.transparent()) image.alpha.assign(image.rgb.size() / 3, 255);
    return image;
}

}  // namespace fumon
