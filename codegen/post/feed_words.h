#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "codegen/post/gcode_numbers.h"
#include "codegen/post/post.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Feed rate. If the controller supports it, it is written in the form of its origin.
struct GcodeFeed {
    double per_min = 0;                     ///< mm or deg
    bool rotary = false;                    ///< In deg/min: rotary axes alone move.
    std::optional<double> duration_s = {};  ///< For the full move.
    std::optional<double> per_rev_mm = {};  ///< In a turn of the spindle.
    std::optional<double> lead_mm = {};     ///< Lead per turn of a line in step with the spindle.
};

/// Words of feeds: F, the mode that it counts in, and accelerations, which have its digits. A word without
/// new content is left out.
class FeedWords {
  public:
    struct Options {
        bool inch = false;
        bool verbose = false;     ///< Words are written though they have not changed.
        bool feed_modes = false;  ///< The program has feeds of several kinds.
    };

    /// `post` must outlive this.
    FeedWords(const Post& post, const Options& options);

    /// Writes the word of the feed's mode.
    void write_mode(ProgramText& block, const GcodeFeed& feed);
    /// Writes F. `turn_rad` is the angle of an arc, else 0.
    void write(ProgramText& block, const GcodeFeed& feed, double turn_rad);
    /// Writes the post's blocks for an acceleration; no block if it has no such words, or if the same one is
    /// active.
    void write_acceleration(ProgramText& text, double mm_s2);
    /// Returns a feed as printed.
    std::string text(double mm_min) const;
    /// Makes F be written again.
    void forget_value() { printed_ = kUnknownIncrements; }
    /// Clears the active words, because another program begins, or one has been called.
    void forget();

  private:
    enum class FeedMode { unknown, per_minute, inverse_time, per_revolution };

    FeedMode initial_mode() const { return options_.feed_modes ? FeedMode::unknown : FeedMode::per_minute; }
    FeedMode mode_for(const GcodeFeed& feed) const;
    double in_unit(double mm) const;
    /// A feed that rounds to 0 would never reach the target.
    std::int64_t positive_increments(double value) const;

    const Post& post_;
    Options options_;
    DecimalFormat format_;
    std::int64_t printed_ = kUnknownIncrements;
    FeedMode mode_;
    std::int64_t acceleration_increments_ = kUnknownIncrements;
};

}  // namespace gsim::codegen
