// Expected values, for messages about a value of the wrong kind.

#include <fmt/format.h>

#include "toolpath/json/json_handler.h"

namespace gsim::path {

std::string JsonHandler::wanted() const {
    switch (level()) {
        case Level::outside: return "a path file must be an object {...}";
        case Level::program:
            if (key_ == "work_offsets") return "'work_offsets' must be an object of offsets by name";
            if (key_ == "format") return "'format' must be a number";
            return fmt::format("'{}' must be {}", key_, key_ == "paths" ? "an array of paths" : "a string");
        case Level::paths: return "'paths' must hold objects, each a path with 'name' and 'targets'";
        case Level::path:
            return fmt::format("'{}' must be {}", key_,
                               path_key_ == PathKey::targets          ? "an array of targets"
                               : wants(PathDraft::ValueKind::number)  ? "a number"
                               : wants(PathDraft::ValueKind::vector)  ? "an array of three numbers"
                               : wants(PathDraft::ValueKind::touches) ? "an array of touches"
                                                                      : "a string");
        case Level::targets: return "'targets' must hold objects, each a point or a sub-path";
        case Level::vector: return fmt::format("'{}' must hold three numbers", vector_key());
        case Level::touches: return "'probe_offset' must hold objects, each a touch";
        case Level::touch:
            return fmt::format("'{}' must be {}", name_of(touch_key_),
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
    switch (TargetDraft::kind_of(target_key_)) {
        case TargetDraft::ValueKind::text: return fmt::format("'{}' must be a string", name_of(target_key_));
        case TargetDraft::ValueKind::number:
            return fmt::format("'{}' must be a number", name_of(target_key_));
        case TargetDraft::ValueKind::text_or_number:
            return fmt::format("'{}' must be a name or a number", name_of(target_key_));
        case TargetDraft::ValueKind::vector:
            return fmt::format("'{}' must be an array of three numbers", name_of(target_key_));
        case TargetDraft::ValueKind::touches:
            return fmt::format("'{}' must be an array of touches", name_of(target_key_));
        case TargetDraft::ValueKind::letters: return "'rotary_deg' must be an object such as {\"B\": 90}";
        case TargetDraft::ValueKind::list: return "'actions' must be an array of strings";
    }
    return {};
}

}  // namespace gsim::path
