#include "keys/setting.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "keys/toml_text.h"

namespace fumon {

Setting parse_setting(const Override& given) {
    Setting setting{given, {}};
    if (!is_utf8(given.value)) {
        throw InputError(fmt::format("{}: the value of {} is not UTF-8; write it in that encoding",
                                     setting.locate({}), given.path));
    }
    if (auto holder = parse_toml_value(given.value)) {
        setting.holder = std::move(*holder);
    } else {
        setting.holder.insert_or_assign("value", given.value);  // a bare string
    }
    return setting;
}

}  // namespace fumon
