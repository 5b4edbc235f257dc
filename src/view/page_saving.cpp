#include "view/page_saving.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "scene/json.h"

namespace fumon {

std::string saved_name(const std::string& name, std::span<const std::string_view> endings) {
    constexpr std::size_t longest = 120;
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    const bool fits = !name.empty() && name.size() <= longest && is_letter(name.front()) &&
                      std::ranges::all_of(name, [&](char c) {
                          return is_letter(c) || c == '.' || c == '-' || c == '_' || c == ' ';
                      });
    if (!fits) {
        throw InputError(
            fmt::format("\"{}\" is not a name for a file here; take letters, digits, '.', '-' and "
                        "'_', without a "
                        "folder",
                        name));
    }
    check_ending(name, "the file", endings);
    return name;
}

HttpAnswer saved(const ViewOptions& options, const ViewSubject& subject, const std::string& name,
                 const std::string& type, std::string bytes) {
    HttpAnswer answer;
    if (options.save.empty()) {
        answer.type = type;
        answer.headers["Content-Disposition"] = fmt::format("attachment; filename=\"{}\"", name);
        answer.body = std::move(bytes);
        return answer;
    }
    const std::filesystem::path file = options.save / name;
    OutputClaims claims(options.force);
    claims.reads(subject.files());
    claims.writes(file, is_made_by_fumon(file));
    write_file(file, bytes);
    answer.type = "application/json";
    answer.body = json_text({{"saved", file.string()}});
    return answer;
}

}  // namespace fumon
