#include "picture/stills/cmyk.h"

#include <lcms2.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>

#include "base/error.h"
#include "picture/pixels/srgb_profile.h"

namespace fumon {

namespace {

template <class Handle, auto close>
struct Closer {
    void operator()(Handle handle) const { close(handle); }
};

using Context =
    std::unique_ptr<std::remove_pointer_t<cmsContext>, Closer<cmsContext, cmsDeleteContext>>;
using Profile = std::unique_ptr<void, Closer<cmsHPROFILE, cmsCloseProfile>>;
using Transform = std::unique_ptr<void, Closer<cmsHTRANSFORM, cmsDeleteTransform>>;

Profile open_profile(cmsContext context, const std::string& bytes) {
    if (bytes.size() > std::numeric_limits<cmsUInt32Number>::max()) return nullptr;
    return Profile(cmsOpenProfileFromMemTHR(context, bytes.data(),
                                            static_cast<cmsUInt32Number>(bytes.size())));
}

Profile open_inks(cmsContext context, const std::string& bytes) {
    Profile inks = open_profile(context, bytes);
    if (!inks) throw InputError("is not an ICC profile; name the profile of a CMYK printer");
    if (cmsGetColorSpace(inks.get()) != cmsSigCmykData ||
        cmsGetDeviceClass(inks.get()) != cmsSigOutputClass)
        throw InputError("is an ICC profile, but not that of a CMYK printer");
    return inks;
}

}  // namespace

void check_cmyk_profile(const std::string& profile) {
    const Context context(cmsCreateContext(nullptr, nullptr));
    open_inks(context.get(), profile);
}

std::vector<std::uint8_t> cmyk_of(const Image& image, const std::string& profile) {
    const Context context(cmsCreateContext(nullptr, nullptr));
    const Profile inks = open_inks(context.get(), profile);
    const Profile light = open_profile(context.get(), srgb_profile());
    const Transform transform(
        cmsCreateTransformTHR(context.get(), light.get(), TYPE_RGB_8, inks.get(), TYPE_CMYK_8,
                              INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_BLACKPOINTCOMPENSATION));
    if (!transform) throw InputError("is an ICC profile without a conversion from colours to inks");
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<std::uint8_t> values(4 * width * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        cmsDoTransform(transform.get(), image.row(y),
                       values.data() + 4 * width * static_cast<std::size_t>(y),
                       static_cast<cmsUInt32Number>(width));
    }
    return values;
}

}  // namespace fumon
