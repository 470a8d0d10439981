#pragma once

#include <string>

#include "batch/pages/night.h"

namespace gsim::batch {

/// How a case went in the batches before, as markup: when it was last without a fault, a line of its times,
/// and a table.
std::string history_text(const Night& night, const Case& of);

}  // namespace gsim::batch
