#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace gsim::script {

/// What files of the library that is built in compile to, for runs that share it: who comes first compiles
/// for all others. For any number of threads.
class CompiledLibrary {
  public:
    /// As lua_dump() gave it; null: nobody has compiled this file yet.
    std::shared_ptr<const std::string> find(std::string_view file_name) const;
    void keep(std::string_view file_name, std::string compiled);

  private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const std::string>, std::less<>> files_;
};

}  // namespace gsim::script
