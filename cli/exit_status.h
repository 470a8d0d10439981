#pragma once

namespace gsim::apps {

/// Exit statuses of all programs.
inline constexpr int kSuccess = 0;
inline constexpr int kProgramError =
    1;  ///< Errors in the part program, an alarm, a limit; findings of a check.
inline constexpr int kUsageError = 2;  ///< Options or files.

}  // namespace gsim::apps
