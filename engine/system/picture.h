#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace gsim::engine {

/// The picture (SVG, or PNG) of a script that Document::plot has made, by gnuplot. The error is a sentence.
tl::expected<std::string, std::string> drawn(const std::string& script);
/// Whether there is gnuplot. The error is a sentence.
tl::expected<void, std::string> find_gnuplot();

/// A picture of a run, .svg or .png by the name of its file, by gnuplot from Document::plot: the path at
/// equal scales, jet on dark, jet off grey, rapids dashed, with marks; below it the speed of the tool over
/// time with the programmed feed, and the acceleration along the path, of rapids at scales of their own.
class Picture {
  public:
    /// Looks at the name before a run, so that none is in vain: its ending, its folder, and whether there is
    /// gnuplot. The error is a sentence.
    static tl::expected<Picture, std::string> named(const std::filesystem::path& path);

    /// The error is a sentence; then no picture is left, and one that was there before stays.
    tl::expected<void, std::string> draw(const std::string& text) const;
    /// .png, else .svg.
    bool bitmap() const { return bitmap_; }

  private:
    Picture(std::filesystem::path path, bool bitmap) : path_(std::move(path)), bitmap_(bitmap) {}

    std::filesystem::path path_;
    bool bitmap_;
};

}  // namespace gsim::engine
