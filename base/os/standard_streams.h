#pragma once

namespace gsim::os {

/// Opens the standard streams that were closed before the program began. Otherwise the next opened file would
/// take such a place and get the printed text. After this call such a stream exists, and fails. Only for
/// main(), before anything else.
void reserve_standard_streams();

}  // namespace gsim::os
