#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "controller/module/rcs_host.h"
#include "controller/module/rcs_module.h"
#include "controller/module/rcs_values.h"

// Inputs and outputs of services, as the structures of rcs_module.h and as methods of Shell have them. A
// structure is described here by its fields, in the order of the values that they represent.
namespace gsim::rrs {

/// Represents the missing input or output of a service.
struct gsim_rcs_none {};

/// Reason why a value does not fit in its field.
struct FieldError {
    std::string_view subject;  ///< "The name of the frame"; empty: the service.
    std::string_view error;    ///< Remainder of the message: "is too long".
};

namespace codec {

/// A text, and its name in messages.
template <typename Storage>
struct Text {
    Storage& record;
    std::string_view what;
};

/// A list and its count; Value is const if it is read.
template <typename Value, typename Count>
struct List {
    Value* values;
    Count& count;
};

template <typename Storage>
Text<Storage> text(Storage& record, std::string_view what) {
    return {record, what};
}

template <typename Value, std::size_t size, typename Count>
List<Value, Count> list(Value (&values)[size], Count& count) {
    static_assert(size == GSIM_RCS_MAX_JOINTS);
    return {values, count};
}

// Fields of each structure; `s` is const if they are read.
#define GSIM_RCS_FIELDS(structure, ...)                              \
    template <typename Storage>                                      \
    requires std::is_same_v<std::remove_const_t<Storage>, structure> \
    auto fields(Storage& s) {                                        \
        return std::tuple_cat(__VA_ARGS__);                          \
    }
template <typename Storage>
requires std::is_same_v<std::remove_const_t<Storage>, gsim_rcs_none> std::tuple<> fields(Storage& /*s*/) {
    return {};
}
GSIM_RCS_FIELDS(gsim_rcs_number, std::tie(s.value))
GSIM_RCS_FIELDS(gsim_rcs_integer, std::tie(s.value))
GSIM_RCS_FIELDS(gsim_rcs_joints, std::tie(s))
GSIM_RCS_FIELDS(gsim_rcs_pose, std::tie(s))
GSIM_RCS_FIELDS(gsim_rcs_pose_and_joints, std::tie(s.pose, s.joints))
GSIM_RCS_FIELDS(gsim_rcs_frame, std::tuple(text(s.name, "The name of the frame")), std::tie(s.pose))
GSIM_RCS_FIELDS(gsim_rcs_work_frames,
                std::tuple(text(s.tool, "The name of the frame"), text(s.object, "The name of the frame")))
GSIM_RCS_FIELDS(gsim_rcs_position, std::tie(s.pose, s.joints),
                std::tuple(text(s.configuration, "The configuration")))
GSIM_RCS_FIELDS(gsim_rcs_target, std::tie(s.id, s.param), fields(s.position), std::tie(s.param_value),
                std::tuple(text(s.name, "The name of the target")))
GSIM_RCS_FIELDS(gsim_rcs_arc_target, std::tie(s.id, s.center_mm, s.axis, s.sweep_rad), fields(s.end))
GSIM_RCS_FIELDS(gsim_rcs_rest, std::tie(s.id, s.rest_s))
GSIM_RCS_FIELDS(gsim_rcs_joint_values,
                std::tuple(list(s.joints, s.joint_count), list(s.values, s.value_count)))
GSIM_RCS_FIELDS(gsim_rcs_ramp_limits, std::tie(s.limit), fields(s.values))
GSIM_RCS_FIELDS(gsim_rcs_parameter_value, std::tie(s.number, s.joint, s.value))
GSIM_RCS_FIELDS(gsim_rcs_event_definition, std::tie(s.event, s.target, s.offset_s))
GSIM_RCS_FIELDS(gsim_rcs_path_event_definition, std::tie(s.event, s.target, s.offset_mm))
GSIM_RCS_FIELDS(gsim_rcs_tracking, std::tie(s.conveyor, s.on))
GSIM_RCS_FIELDS(gsim_rcs_conveyor, std::tie(s.conveyor, s.direction, s.speed_mm_s))
GSIM_RCS_FIELDS(gsim_rcs_object_target, std::tie(s.id, s.pose))
GSIM_RCS_FIELDS(gsim_rcs_path_mode, std::tie(s.mode, s.tolerance_mm, s.merge_tolerance_mm))
GSIM_RCS_FIELDS(gsim_rcs_tip_control, std::tie(s.on, s.tip_mm))
GSIM_RCS_FIELDS(gsim_rcs_message, std::tuple(text(s.text, "The message")))
GSIM_RCS_FIELDS(gsim_rcs_step, std::tie(s.joints, s.pose, s.elapsed_s))
GSIM_RCS_FIELDS(gsim_rcs_object_step, std::tie(s.pose, s.elapsed_s))
GSIM_RCS_FIELDS(gsim_rcs_event, std::tie(s.event, s.time_s))
GSIM_RCS_FIELDS(gsim_rcs_target_id, std::tie(s.id))
#undef GSIM_RCS_FIELDS

// write_field() fills a field, read_field() reads it.

template <typename Field, typename Value>
requires std::is_arithmetic_v<Field> std::optional<FieldError> write_field(
    Field& field, const Value& value) {  // also switches, enumerations
    field = static_cast<Field>(value);
    return std::nullopt;
}

inline std::optional<FieldError> write_field(gsim_rcs_pose& field, const CartPos& pose) {
    field = to_rcs(pose);
    return std::nullopt;
}

inline std::optional<FieldError> write_field(gsim_rcs_joints& field, const JointPos& joints) {
    field = to_rcs(joints);
    return std::nullopt;
}

inline std::optional<FieldError> write_field(double (&field)[3], const Eigen::Vector3d& vector) {
    std::copy(vector.begin(), vector.end(), field);
    return std::nullopt;
}

template <typename Storage>
std::optional<FieldError> write_field(const Text<Storage>& field, std::string_view value) {
    if (copy_text(value, field.record)) return std::nullopt;
    return FieldError{field.what, "is too long"};
}

template <typename Value, typename Count>
std::optional<FieldError> write_field(const List<Value, Count>& field, std::span<const Value> values) {
    static_assert(GSIM_RCS_MAX_JOINTS == 16);
    if (values.size() > GSIM_RCS_MAX_JOINTS) return FieldError{{}, "accepts at most 16 values"};
    field.count = static_cast<Count>(values.size());
    std::copy(values.begin(), values.end(), field.values);
    return std::nullopt;
}

template <typename Field>
requires std::is_arithmetic_v<Field> Field read_field(const Field& field) {
    return field;
}

inline CartPos read_field(const gsim_rcs_pose& field) {
    return from_rcs(field);
}

inline JointPos read_field(const gsim_rcs_joints& field) {
    return from_rcs(field);
}

inline Eigen::Vector3d read_field(const double (&field)[3]) {
    return Eigen::Vector3d(field);
}

template <typename Storage>
std::string read_field(const Text<Storage>& field) {
    return rcs_text(field.record, sizeof field.record);
}

template <typename Value, typename Count>
std::span<Value> read_field(const List<Value, Count>& field) {
    return std::span<Value>(field.values, static_cast<std::size_t>(field.count));
}

template <typename Field>
bool is_valid(const Field& /*field*/) {
    return true;
}

template <typename Value, typename Count>
bool is_valid(const List<Value, Count>& field) {
    return field.count >= 0 && field.count <= GSIM_RCS_MAX_JOINTS;
}

/// True for a parameter's value without a joint, which the C structure still contains.
template <typename Storage, std::size_t count>
inline constexpr bool kHasNoJoint = std::is_same_v<Storage, gsim_rcs_parameter_value>&& count == 2;

}  // namespace codec

/// Fills a structure from values, in their order. Further fields stay as they are, because services may share
/// a structure. Returns an error for a value that does not fit.
template <typename Storage, typename... Values>
std::optional<FieldError> write(Storage& record, const Values&... values) {
    if constexpr (codec::kHasNoJoint<Storage, sizeof...(values)>) {
        return [&](int number, double value) { return write(record, number, 0, value); }(values...);
    } else {
        auto fields = codec::fields(record);
        static_assert(sizeof...(values) <= std::tuple_size_v<decltype(fields)>);
        std::optional<FieldError> field_error;
        [&]<std::size_t... at>(std::index_sequence<at...>) {
            ((field_error = field_error ? field_error : codec::write_field(std::get<at>(fields), values)),
             ...);
        }
        (std::index_sequence_for<Values...>());
        return field_error;
    }
}

/// Returns the first `count` values of a structure; none if it has a count out of range.
template <std::size_t count, typename Storage>
auto get_values(const Storage& record) {
    const auto fields = codec::fields(record);
    const auto values = [&]<std::size_t... at>(std::index_sequence<at...>) {
        using FieldValues = std::tuple<decltype(codec::read_field(std::get<at>(fields)))...>;
        const bool are_valid = (codec::is_valid(std::get<at>(fields)) && ...);
        return are_valid ? std::optional<FieldValues>(FieldValues(codec::read_field(std::get<at>(fields))...))
                         : std::nullopt;
    };
    if constexpr (codec::kHasNoJoint<Storage, count>) {
        return values(std::index_sequence<0, 2>());
    } else {
        return values(std::make_index_sequence<count>());
    }
}

}  // namespace gsim::rrs
