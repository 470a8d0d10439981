#pragma once

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studio/engine/session.h"
#include "tests/build_files/build_files.h"
#include "tests/studio/engine/frames.h"

namespace gsim::studio {

using Files = std::map<std::string, std::string>;

/// Returns the messages posted to a page that has these files and no others.
inline std::vector<Frame> request_frames(const std::string& request_json, const Files& files = {}) {
    engine::Host host;
    host.files = engine::Files::given([&](const std::string& name) -> std::optional<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return found->second;
    });
    std::vector<Frame> frames;
    handle_request(request_json, host,
                   [&](const std::string& bytes) { frames.push_back(read_frame(bytes)); });
    return frames;
}

inline std::vector<Frame> filter_frames(const std::vector<Frame>& frames, const std::string& kind) {
    std::vector<Frame> found;
    std::copy_if(frames.begin(), frames.end(), std::back_inserter(found),
                 [&](const Frame& frame) { return frame.is() == kind; });
    return found;
}

inline const Frame& last(const std::vector<Frame>& frames) {
    return frames.back();
}

/// Returns the message of an answer that fails, or "done" for one that does not.
inline std::string make_error(const std::string& request_json, const Files& files = {}) {
    const Frame end = request_frames(request_json, files).back();
    return end.is() == "failed" ? end.header["message"].get<std::string>() : end.is();
}

/// A file of samples/.
inline std::string sample(const std::string& name) {
    std::ifstream file(tests::source_path("samples/") + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace gsim::studio
