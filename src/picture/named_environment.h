#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "keys/keys.h"
#include "picture/environment.h"

namespace fumon {

/// What draws: a processor or a graphics card.
enum class Drawer { any, software, gpu };

/// Something that draws, under a name that cases have pictures of their own for. What is not said
/// of it may be anything.
struct NamedEnvironment {
    std::string name{};
    std::string mesa{};    ///< how Mesa's version begins: "22.3" is that of 22.3.6
    std::string driver{};  ///< a part of GL_RENDERER: "llvmpipe", "NVIDIA"
    Drawer drawer = Drawer::any;

    /// Lists its keys under a prefix, bound to it.
    void list_keys(const std::string& prefix, KeyTable& table);

    /// Whether nothing is said of it.
    [[nodiscard]] bool is_anything() const;

    /// Whether a rendering environment is this one; an unknown one is none.
    [[nodiscard]] bool is(const RenderingEnvironment& here) const;
};

/// Whether a processor drew, and no graphics card: Mesa's llvmpipe, softpipe or swrast, or Cairo.
bool drawn_by_software(const RenderingEnvironment& environment);

/// A case's record of one environment, as locks and files of pictures call it: "map@gpu"; "map"
/// where no environment is named.
std::string record_name(const std::string& picture, const std::string& environment);

/// The picture and the environment ("" for none) of such a name.
std::pair<std::string, std::string> parts_of_record_name(std::string_view name);

}  // namespace fumon
