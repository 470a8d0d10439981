#pragma once

#include <string>
#include <vector>

#include "toolpath/json/read_result.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Reader of the work offsets of a path file, key by key.
class OffsetReader {
  public:
    void set_name(const std::string& name);
    /// Begins the offset of this name. Returns an error if there is one already.
    ReadResult start(Program& program);
    ReadResult key(const std::string& name);
    /// Sets a value of the offset that has begun.
    void number(double value);
    /// Returns the expected value of a name, for messages.
    std::string expected_offset() const;
    /// Returns the expected value of a key of an offset, for messages.
    std::string expected_type() const { return fmt::format("'{}' must be a number", key_); }

  private:
    std::string name_;
    WorkOffset* offset_ = nullptr;  ///< In the program.
    std::vector<std::string> keys_;
    std::string key_;
};

}  // namespace gsim::path
