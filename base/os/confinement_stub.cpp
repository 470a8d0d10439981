// Replaces confinement.cpp in the WebAssembly build. It has no system to query, and accesses only what its
// host passes in.
#include "base/os/confinement.h"

namespace gsim::os {

Result<bool> confine(const SandboxPolicy& /*allowed*/) {
    return false;
}

}  // namespace gsim::os
