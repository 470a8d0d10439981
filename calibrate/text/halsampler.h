#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "calibrate/text/list.h"

namespace gsim::calibrate {

/// The words of a line, with blanks between.
Cells words_of(std::string_view line);

/// Whether a first line is one of those that LinuxCNC's halsampler prints: numbers alone.
bool is_halsampler(std::string_view line);

/// Takes a sample: the number of its line, its time in s and its columns. The error says what is wrong.
using TakeSample = std::function<tl::expected<void, std::string>(int line, double t_s, const Cells& columns)>;

/// Goes through what halsampler has printed, samples of `columns` numbers each, `period_s` apart, with or
/// without its -t (the number of the sample in front). Where samples were lost ("overrun") these numbers tell
/// how many. The error: of `take`, or that no period is known.
tl::expected<void, std::string> read_halsampler(std::string_view text, std::size_t columns, double period_s,
                                                const TakeSample& take);

}  // namespace gsim::calibrate
