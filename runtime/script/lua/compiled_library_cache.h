#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace gsim::script {

/// Compiled files of the built-in library, for runs that share it: the first user compiles for all others.
/// For any number of threads.
class CompiledLibraryCache {
  public:
    /// Returns the file as lua_dump() gave it; null: it has not been compiled yet.
    std::shared_ptr<const std::string> find(std::string_view file_name) const;
    void keep(std::string_view file_name, std::string compiled);

  private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const std::string>, std::less<>> files_;
};

}  // namespace gsim::script
