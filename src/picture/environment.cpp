#include "picture/environment.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "files/json_text.h"
#include "scene/json.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

/// The word of digits and dots behind a name ("Mesa 22.3.6-devel" → "22.3.6-devel").
std::string version_after(const std::string& text, std::string_view name) {
    const std::size_t found = text.find(name);
    if (found == std::string::npos) return {};
    const std::size_t start = found + name.size();
    return text.substr(start, text.find_first_of(" ,)", start) - start);
}

std::string or_unknown(const std::string& value) {
    return value.empty() ? "unknown" : value;
}

std::string joined(const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> differences(const RenderingEnvironment& there,
                                     const RenderingEnvironment& here, bool with_backend) {
    std::vector<std::string> found;
    const auto compare = [&](const char* name, const std::string& one, const std::string& other) {
        if (one != other)
            found.push_back(
                fmt::format("{} {} there, {} here", name, or_unknown(one), or_unknown(other)));
    };
    if (with_backend) compare("backend", there.backend, here.backend);
    compare("Mesa", there.mesa_version, here.mesa_version);
    compare("LLVM", there.llvm_version, here.llvm_version);
    // Versions of Mesa and LLVM stand in these names too: they are told once.
    if (there.mesa_version == here.mesa_version && there.llvm_version == here.llvm_version) {
        compare("renderer", there.renderer, here.renderer);
        compare("OpenGL", there.gl_version, here.gl_version);
    }
    if (there.pinned != here.pinned)
        found.emplace_back(there.pinned ? "pinned there, not here" : "pinned here, not there");
    return found;
}

}  // namespace

RenderingEnvironment opengl_environment(const std::string& backend, const std::string& renderer,
                                        const std::string& gl_version, bool pinned) {
    return {backend,
            renderer,
            gl_version,
            version_after(gl_version, "Mesa "),
            version_after(renderer, "LLVM "),
            pinned};
}

std::string difference(const RenderingEnvironment& there, const RenderingEnvironment& here) {
    return joined(differences(there, here, true));
}

std::string why_pixels_may_differ(const RenderingEnvironment& there,
                                  const RenderingEnvironment& here) {
    const auto on_llvmpipe = [](const RenderingEnvironment& environment) {
        return environment.backend == "osmesa" || environment.backend == "egl";
    };
    const bool with_backend = !(on_llvmpipe(there) && on_llvmpipe(here));
    std::vector<std::string> reasons = differences(there, here, with_backend);
    if (reasons.empty() && !there.pinned) {
        reasons.emplace_back(there.backend == "cairo"
                                 ? "text uses the fonts of the machine"
                                 : "neither is pinned, so that pixels depend on the processor");
    }
    return joined(reasons);
}

std::string environment_text(const RenderingEnvironment& environment) {
    return json_text({{"backend", environment.backend},
                      {"renderer", environment.renderer},
                      {"gl_version", environment.gl_version},
                      {"mesa_version", environment.mesa_version},
                      {"llvm_version", environment.llvm_version},
                      {"pinned", environment.pinned}});
}

RenderingEnvironment parse_environment(const std::string& text) {
    try {
        const Json json = parse_json(text);
        return {json.value("backend", ""),      json.value("renderer", ""),
                json.value("gl_version", ""),   json.value("mesa_version", ""),
                json.value("llvm_version", ""), json.value("pinned", false)};
    } catch (const Json::exception&) {
        throw InputError(
            fmt::format("not a record of a rendering environment: {}", text.substr(0, 60)));
    }
}

}  // namespace fumon
