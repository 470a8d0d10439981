#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/simulation/plot_data.h"
#include "runtime/simulation/plot_script.h"

namespace gsim::simulation {

/// A picture of a run, .svg or .png by the name of its file: the path at equal scales, jet on dark, jet off
/// grey, rapids dashed, with marks; below it the speed of the tool over time with the programmed feed, and
/// the acceleration along the path, of rapids at scales of their own. It needs gnuplot.
class Picture {
  public:
    /// Looks at the name before a run, so that none is in vain: its ending, its folder, and whether there is
    /// gnuplot. The error is a sentence.
    static tl::expected<Picture, std::string> named(const std::filesystem::path& path);

    /// The error is a sentence; then no picture is left, and one that was there before stays.
    tl::expected<void, std::string> draw(const PlotData& data, std::string_view title) const;

  private:
    Picture(std::filesystem::path path, PictureFormat format) : path_(std::move(path)), format_(format) {}

    std::filesystem::path path_;
    PictureFormat format_;
};

}  // namespace gsim::simulation
