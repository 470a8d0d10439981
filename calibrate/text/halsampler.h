#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "calibrate/text/list.h"

namespace gsim::calibrate {

/// Returns the words of a line, separated by blanks.
Cells split_words(std::string_view line);

/// Returns true if a first line is output of LinuxCNC's halsampler: numbers alone.
bool is_halsampler(std::string_view line);

/// Function that receives a sample: the number of its line, its time in s and its columns. The error
/// describes the problem.
using SampleHandler = std::function<Result<void>(int line, double t_s, const Cells& columns)>;

/// Reads the output of halsampler, samples of `columns` numbers each, `period_s` apart, with or without its
/// -t (the number of the sample in front). If samples were lost ("overrun") these numbers show how many. The
/// error: of `on_sample`, or an unknown period.
Result<void> read_halsampler(std::string_view text, std::size_t columns, double period_s,
                             const SampleHandler& on_sample);

}  // namespace gsim::calibrate
