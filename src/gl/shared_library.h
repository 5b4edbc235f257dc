#pragma once

#include <span>
#include <string>

namespace fumon::gl {

/// A library opened at run time. It stays loaded until the process ends: Mesa's drivers keep
/// thread-local state that does not survive being unloaded.
class SharedLibrary {
  public:
    /// Opens the first of `names` that loads.
    explicit SharedLibrary(std::span<const char* const> names);

    [[nodiscard]] bool loaded() const { return handle_ != nullptr; }
    [[nodiscard]] const std::string& failure() const { return failure_; }  ///< why not, one line
    [[nodiscard]] void* symbol(const char* name) const;  ///< nullptr where it is missing

  private:
    void* handle_ = nullptr;
    std::string failure_;
};

}  // namespace fumon::gl
