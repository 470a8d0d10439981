#pragma once

#include <list>
#include <vector>

#include "base/text/json.h"
#include "engine/run.h"
#include "studio/engine/run_messages.h"
#include "studio/engine/series.h"

namespace gsim::studio {

/// What a run has over time beside its segments: what the motors bring up where the machine file tells of
/// masses, and following and contour errors where it tells of servo loops.
class RunSeries {
  public:
    /// Between prepare() and go(), of a robot with its scene. This must outlive the motion.
    void take(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& scene);
    /// Behind go().
    void post(const Post& post) const;

  private:
    struct Entry {
        nlohmann::ordered_json header;
        const char* is;
        Series series;
    };

    Series& add(const char* is, std::size_t robot, const nlohmann::ordered_json& channels);
    void take_efforts(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& axes);
    void take_following(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& axes);

    std::list<Entry> entries_;  // which runs hold on to
};

}  // namespace gsim::studio
