#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Names of the paths of a file, and their uses, which may come before the paths.
class PathNames {
  public:
    /// Adds a path; returns false if the name exists.
    bool add(const std::string& name, std::size_t path) { return by_name_.emplace(name, path).second; }
    /// Notes that the target, a sub-path, uses the path of this name.
    void add_use(const TargetId& target, std::string path_name) {
        uses_.push_back({target, std::move(path_name)});
    }
    void set_root(const std::string& name, const SourceLocation& location) { root_ = Root{name, location}; }
    /// Sets the indices of the root and of the paths of all sub-paths. Returns an error at
    /// the first name that no path has.
    std::optional<Error> resolve(PathFile& file) const;

  private:
    struct Use {
        TargetId target;
        std::string path_name;
    };
    struct Root {
        std::string name;
        SourceLocation location;
    };

    std::optional<std::size_t> find(std::string_view name) const;

    std::map<std::string, std::size_t, std::less<>> by_name_;
    std::vector<Use> uses_;
    std::optional<Root> root_;
};

}  // namespace gsim::path
