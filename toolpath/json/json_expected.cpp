// Expected values, for messages about a value of the wrong kind.

#include <fmt/format.h>

#include "toolpath/json/json_handler.h"

namespace gsim::path {

std::string JsonHandler::expected_type() const {
    switch (level()) {
        case Level::outside: return "a path file must be an object {...}";
        case Level::program:
            if (key_ == "work_offsets") return "'work_offsets' must be an object of offsets by name";
            if (key_ == "format") return "'format' must be a number";
            return fmt::format("'{}' must be {}", key_, key_ == "paths" ? "an array of paths" : "a string");
        case Level::paths: return "'paths' must hold objects, each a path with 'name' and 'targets'";
        case Level::path:
            return fmt::format("'{}' must be {}", key_,
                               path_key_ == PathKey::targets            ? "an array of targets"
                               : expects(PathDraft::ValueKind::number)  ? "a number"
                               : expects(PathDraft::ValueKind::vector)  ? "an array of three numbers"
                               : expects(PathDraft::ValueKind::touches) ? "an array of touches"
                                                                        : "a string");
        case Level::targets: return "'targets' must hold objects, each a point or a sub-path";
        case Level::vector: return fmt::format("'{}' must hold three numbers", vector_key());
        case Level::touches: return "'probe_offset' must hold objects, each a touch";
        case Level::touch:
            return fmt::format("'{}' must be {}", key_name(touch_key_),
                               touch_key_ == TouchKey::axis      ? "a string"
                               : touch_key_ == TouchKey::from_mm ? "an array of three numbers"
                                                                 : "a number");
        case Level::offsets:
            return fmt::format("the work offset '{}' must be an object such as {{\"X\": 200}}", offset_name_);
        case Level::offset:
        case Level::rotary: return fmt::format("'{}' must be a number", key_);
        case Level::actions: return "'actions' must hold strings";
        case Level::target: break;
    }
    switch (TargetDraft::value_kind(target_key_)) {
        case TargetDraft::ValueKind::text: return fmt::format("'{}' must be a string", key_name(target_key_));
        case TargetDraft::ValueKind::number:
            return fmt::format("'{}' must be a number", key_name(target_key_));
        case TargetDraft::ValueKind::text_or_number:
            return fmt::format("'{}' must be a name or a number", key_name(target_key_));
        case TargetDraft::ValueKind::vector:
            return fmt::format("'{}' must be an array of three numbers", key_name(target_key_));
        case TargetDraft::ValueKind::touches:
            return fmt::format("'{}' must be an array of touches", key_name(target_key_));
        case TargetDraft::ValueKind::letters: return "'rotary_deg' must be an object such as {\"B\": 90}";
        case TargetDraft::ValueKind::list: return "'actions' must be an array of strings";
    }
    return {};
}

}  // namespace gsim::path
