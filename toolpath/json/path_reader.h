#pragma once

#include <bitset>
#include <string>
#include <vector>

#include "toolpath/json/keys.h"
#include "toolpath/json/path_draft.h"
#include "toolpath/json/read_result.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Reader of a path, key by key. Its targets are read by TargetReader.
class PathReader {
  public:
    void start();
    ReadResult key(const std::string& name);
    ReadResult number(double value);
    ReadResult string(const std::string& value);
    ReadResult vector(const std::vector<double>& values) { return draft_.set_vector(key_, values); }
    bool expects_vector() const { return expects(PathDraft::ValueKind::vector); }
    bool expects_touches() const { return expects(PathDraft::ValueKind::touches); }
    bool expects_targets() const { return key_ == PathKey::targets; }
    void add_touch(const Touch& touch) { draft_.add_touch(touch); }
    ReadResult end_touches() const { return draft_.end_touches(); }
    /// Sets what was read in the path. Returns an error if a required key is missing.
    ReadResult finish(Path& path) const;

    std::string_view current_key() const { return key_name(key_); }
    /// Returns the expected value, for messages.
    std::string expected_type() const;

  private:
    bool expects(PathDraft::ValueKind kind) const { return PathDraft::value_kind(key_) == kind; }

    std::bitset<kPathKeys.size()> present_keys_;
    PathKey key_ = PathKey::name;
    std::string name_;
    PathDraft draft_;
};

}  // namespace gsim::path
