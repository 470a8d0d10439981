#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gsim::simulation {

/// Warnings of a run for its report.
class Warnings {
  public:
    /// Adds a warning; the same text is added once. The report lists the first 1,000.
    void add(const std::string& text);
    /// Returns the warnings in the order of their addition. Call it once, after the end of the run.
    std::vector<std::string> release() { return std::move(texts_); }

  private:
    std::vector<std::string> texts_;
};

}  // namespace gsim::simulation
