#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toolpath/json/path_names.h"
#include "toolpath/json/read_result.h"
#include "toolpath/model/path.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Reader of the outermost object of a path file, key by key.
class ProgramReader {
  public:
    ReadResult key(const std::string& name);
    ReadResult number(double value) const;
    /// Sets the name in the program, or the root in the names.
    ReadResult string(const std::string& value, const SourceLocation& location, Program& program,
                      PathNames& names) const;
    /// Returns true if the value of this key comes.
    bool is_at(std::string_view key) const { return key_ == key; }
    /// Returns the expected value, for messages.
    std::string expected_type() const;

  private:
    std::vector<std::string> keys_;
    std::string key_;
};

}  // namespace gsim::path
