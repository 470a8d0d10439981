#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/gsim.h"
#include "engine/run.h"
#include "engine/translation.h"

/// A request with the text of its program, if that is no file.
struct gsim_request {
    gsim::engine::Request request = {};
    std::optional<std::string> text = {};
    std::string text_name = {};
};

/// Where gsim_read_file puts the bytes of a file.
struct gsim_bytes {
    std::string bytes = {};
};

/// A run, and what it has given out.
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

Request request_of(const gsim_request& given);
Tell tell_of(gsim_tell tell, void* user);
/// Keeps the sentence; the status.
std::int32_t keep_failure(gsim_run& run, const Failure& failure);

/// What `work` returns, or GSIM_FAILED where memory lacks: nothing is thrown at callers from C.
template <typename Work>
std::int32_t without_throwing(const Work& work) noexcept {
    try {
        return work();
    } catch (...) {
        return GSIM_FAILED;
    }
}

}  // namespace gsim::engine
