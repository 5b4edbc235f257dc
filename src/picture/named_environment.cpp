#include "picture/named_environment.h"

#include <algorithm>
#include <array>

namespace fumon {

namespace {

constexpr char before_environment = '@';

/// Whether a version begins with some of its numbers, whole: 22.3.6 with 22.3, not with 22.30 or 2.
bool begins_with(std::string_view version, std::string_view numbers) {
    if (!version.starts_with(numbers)) return false;
    if (version.size() == numbers.size() || numbers.ends_with('.')) return true;
    const char next = version[numbers.size()];
    return next < '0' || next > '9';
}

}  // namespace

void NamedEnvironment::list_keys(const std::string& prefix, KeyTable& table) {
    table.text(prefix + "mesa", mesa, {.help = "how Mesa's version begins, as \"22.3\""});
    table.text(prefix + "driver", driver,
               {.help = "a part of OpenGL's renderer, as \"llvmpipe\" or \"NVIDIA\""});
    table.choice(prefix + "drawer", drawer,
                 {{Drawer::any, "any", "either"},
                  {Drawer::software, "software", "a processor draws"},
                  {Drawer::gpu, "gpu", "a graphics card draws"}},
                 {.help = "what draws"});
}

bool NamedEnvironment::is_anything() const {
    return mesa.empty() && driver.empty() && drawer == Drawer::any;
}

bool NamedEnvironment::is(const RenderingEnvironment& here) const {
    if (here.renderer.empty()) return false;
    if (!mesa.empty() && !begins_with(here.mesa_version, mesa)) return false;
    if (here.renderer.find(driver) == std::string::npos) return false;
    return drawer == Drawer::any || (drawer == Drawer::software) == drawn_by_software(here);
}

bool drawn_by_software(const RenderingEnvironment& environment) {
    if (environment.backend == "cairo") return true;
    constexpr std::array<std::string_view, 3> names{"llvmpipe", "softpipe", "swrast"};
    return std::ranges::any_of(names, [&](std::string_view name) {
        return environment.renderer.find(name) != std::string::npos;
    });
}

std::string record_name(const std::string& picture, const std::string& environment) {
    return environment.empty() ? picture : picture + before_environment + environment;
}

std::pair<std::string, std::string> parts_of_record_name(std::string_view name) {
    const std::size_t at = name.find(before_environment);
    if (at == std::string_view::npos) return {std::string(name), ""};
    return {std::string(name.substr(0, at)), std::string(name.substr(at + 1))};
}

}  // namespace fumon
