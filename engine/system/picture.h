#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"

namespace gsim::engine {

/// Returns the picture (SVG, or PNG) of a script that OutputKind::plot has made, by gnuplot.
Result<std::string> draw_picture(const std::string& script);
/// Checks that gnuplot is installed.
Result<void> find_gnuplot();

/// A picture of a run, .svg or .png by the name of its file, by gnuplot from OutputKind::plot: the path at
/// equal scales, jet on dark, jet off grey, rapids dashed, with marks; below it the speed of the tool over
/// time with the programmed feed, and the acceleration along the path, with separate scales for rapids.
class Picture {
  public:
    /// Checks the name before a run, so that no run is wasted: its extension, its folder, and the presence of
    /// gnuplot.
    static Result<Picture> picture_for_file(const std::filesystem::path& path);

    /// Draws the picture. The error is a message; then no new picture remains, and an existing one is not
    /// changed.
    Result<void> draw(const std::string& text) const;
    /// Returns true for .png, else .svg.
    bool bitmap() const { return bitmap_; }

  private:
    Picture(std::filesystem::path path, bool bitmap) : path_(std::move(path)), bitmap_(bitmap) {}

    std::filesystem::path path_;
    bool bitmap_;
};

}  // namespace gsim::engine
