#pragma once

#include <cstddef>

#include "base/block_pool.h"

namespace fumon {

/// While it lives, the pool of fields' memory holds at least so many bytes of fields that are gone,
/// for the next picture of a film: twice as many are counted as in use, half of which it holds
/// (BlockPool). A picture of water on endless ground takes some 400 MB of fields, which the system
/// would clear for each anew.
class HeldFields {
  public:
    explicit HeldFields(std::size_t bytes) : bytes_(2 * bytes) {
        static_cast<void>(BlockPool::shared().take(bytes_));  // no block is as large
    }
    ~HeldFields() { BlockPool::shared().not_made(bytes_); }
    HeldFields(const HeldFields&) = delete;
    HeldFields& operator=(const HeldFields&) = delete;

  private:
    std::size_t bytes_;
};

}  // namespace fumon
