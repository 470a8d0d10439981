#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/diagnostic.h"
#include "engine/gsim.h"
#include "engine/run.h"
#include "engine/translation.h"

/// A request with the text of its program, if that is not a file.
struct gsim_request {
    gsim::engine::Request request = {};
    std::optional<std::string> text = {};
    std::string text_name = {};
};

/// The target for the bytes of a file from gsim_read_file.
struct gsim_bytes {
    std::string bytes = {};
};

/// A run, and the results that it has returned.
struct gsim_run {
    gsim::engine::Cancel cancel = {};
    std::optional<gsim::engine::Run> run = {};
    std::optional<gsim::engine::Report> report = {};
    std::int32_t status = GSIM_FAILED;
    std::string error = {};
    std::string json = {}, text = {}, variables = {}, machine_data = {};
    std::map<std::string, std::uint32_t, std::less<>> files = {};  ///< Numbers by name,
    std::vector<const std::string*> file_names = {};               ///< and names by number.
};

namespace gsim::engine {

Request make_request(const gsim_request& given);
DiagnosticHandler make_diagnostic_handler(gsim_on_diagnostic on_diagnostic, void* user);
/// Stores the message; returns the status.
std::int32_t store_error(gsim_run& run, const Error& error);

/// Returns the result of `work`, or GSIM_FAILED if memory is exhausted: exceptions never reach callers from
/// C.
template <typename Work>
std::int32_t call_noexcept(const Work& work) noexcept {
    try {
        return work();
    } catch (...) {
        return GSIM_FAILED;
    }
}

}  // namespace gsim::engine
