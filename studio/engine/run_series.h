#pragma once

#include <list>
#include <vector>

#include "base/text/json.h"
#include "engine/run.h"
#include "studio/engine/run_messages.h"
#include "studio/engine/series.h"

namespace gsim::studio {

/// Curves of a run over time in addition to its segments: efforts of the motors if the machine file defines
/// masses, and following and contour errors if it defines servo loops.
class RunSeries {
  public:
    /// Connects to a robot with its scene, between prepare() and go(). This must outlive the motion.
    void add_run(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& scene);
    /// Sends the curves after go().
    void post(const Post& post) const;

  private:
    struct Entry {
        nlohmann::ordered_json header;
        const char* is;
        Series series;
    };

    Series& add(const char* is, std::size_t robot, const nlohmann::ordered_json& channels);
    void on_efforts(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& axes);
    void on_following(engine::Run& run, std::size_t robot, const nlohmann::ordered_json& axes);

    std::list<Entry> entries_;  // which runs hold on to
};

}  // namespace gsim::studio
