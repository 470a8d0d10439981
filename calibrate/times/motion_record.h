#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::calibrate {

/// Position of a machine at an instant.
struct MotionSample {
    double t_s = 0;  ///< By the clock of the recording.
    Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
};

/// Meaning of the columns of a recording that does not define them itself.
struct RecordFormat {
    double period_s = 0;          ///< Between samples if they have no times; 0: unknown.
    std::string columns = "xyz";  ///< Meaning of the columns of numbers, in order; '-' is skipped.
};

/// Reads a recording of positions over time, at any rate, in one of these forms, which it detects:
/// - CSV with a first line that names the columns: t_s (or time_s), x_mm, y_mm, z_mm, those that exist;
/// - output of LinuxCNC's halsampler: numbers in columns, with or without its -t (a number of the sample
///   in front);
/// - status reports of grbl and grblHAL ("<Run|MPos:1.000,2.000,0.000|FS:600,0>"), each with a time in front:
///   seconds, a time of day (12:34:56.789) or both date and time, in brackets or not. WPos counts with the
///   last WCO;
/// - MTConnect: a document of streams, or lines of an adapter ("2024-05-01T12:34:56.789Z|Xact|1.5"), by the
///   names (or items) Xact, Xabs, Xpos, X and so on.
/// Times rise; samples with a time that does not are left out. The error names the line and what it lacks.
Result<std::vector<MotionSample>> read_motion_record(std::string_view text,
                                                     const RecordFormat& record_format);

}  // namespace gsim::calibrate
