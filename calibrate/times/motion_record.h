#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::calibrate {

/// Where a machine was at an instant.
struct MotionSample {
    double t_s = 0;  ///< By the clock of the recording.
    Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
};

/// How the columns of a recording are to be understood that does not tell it itself.
struct RecordForm {
    double period_s = 0;          ///< Between samples, where they have no times; 0: not known.
    std::string columns = "xyz";  ///< What the columns of numbers are, in order; '-' is one to be left out.
};

/// A recording of positions over time, at any rate, in one of these forms, which it shows by itself:
/// - CSV under a line that names the columns: t_s (or time_s), x_mm, y_mm, z_mm, those that there are;
/// - what LinuxCNC's halsampler prints: numbers in columns, with or without its -t (a number of the sample
///   in front);
/// - status reports of grbl and grblHAL ("<Run|MPos:1.000,2.000,0.000|FS:600,0>"), each with a time in front:
///   seconds, a time of day (12:34:56.789) or both date and time, in brackets or not. WPos counts with the
///   last WCO;
/// - MTConnect: a document of streams, or lines of an adapter ("2024-05-01T12:34:56.789Z|Xact|1.5"), by the
///   names (or items) Xact, Xabs, Xpos, X and so on.
/// Times rise; samples whose time does not are left out. The error says which line lacks what.
tl::expected<std::vector<MotionSample>, std::string> read_motion_record(std::string_view text,
                                                                        const RecordForm& form);

}  // namespace gsim::calibrate
