#pragma once

namespace gsim::apps {

/// Exit statuses of all programs.
inline constexpr int kDone = 0;
inline constexpr int kProgramFault =
    1;                            ///< Errors in the part program, an alarm, a limit; findings of a check.
inline constexpr int kUsage = 2;  ///< Options or files.

}  // namespace gsim::apps
