#pragma once

#include <exception>
#include <new>

#include <tl/expected.hpp>

#include "engine/diagnostic.h"
#include "engine/src/conversions.h"

namespace gsim::engine {

/// Returns the result of `work`, a tl::expected with an Error; an exception becomes an Error.
template <typename Work>
auto guard_exceptions(const Work& work) -> decltype(work()) {
    using text::DiagnosticKind;
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return tl::unexpected(make_error(DiagnosticKind::internal, "out of memory"));
    } catch (const std::exception& error) {
        return tl::unexpected(make_error(DiagnosticKind::internal, error.what()));
    }
}

}  // namespace gsim::engine
