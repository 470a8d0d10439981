#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gsim::waterjet {

enum class Origin {
    from_request,  ///< In the request for the plan.
    from_file,     ///< In the materials file.
    inferred,      ///< From other values, by a rule.
};

/// Returns "given", "file" or "inferred".
std::string_view origin_name(Origin origin);

/// A value of a plan and its source.
struct ResolvedValue {
    std::string_view name;  ///< As the option or key is called.
    std::string_view unit;  ///< Empty without a unit.
    double value = 0;
    Origin origin = Origin::from_request;
    std::string basis;  ///< Source of the inference, or the file's own source; may be empty.
};

/// The result of a rule from other values, and its description.
struct InferredValue {
    double value = 0;
    std::string basis;
};

/// A list that settles values one by one, from the best available source.
class ValueResolver {
  public:
    double from_request(std::string_view name, std::string_view unit, double value);
    double from_file(std::string_view name, std::string_view unit, double value, std::string basis);
    double inferred(std::string_view name, std::string_view unit, InferredValue value);

    /// Returns the given value; else that of the file; else the result of the rule `infer()` from others.
    template <typename Rule>
    double resolve(std::string_view name, std::string_view unit, const std::optional<double>& requested,
                   const std::optional<double>& file_value, Rule infer) {
        if (requested) return from_request(name, unit, *requested);
        if (file_value) return from_file(name, unit, *file_value, {});
        return inferred(name, unit, infer());
    }

    std::vector<ResolvedValue> release() { return std::move(values_); }

  private:
    std::vector<ResolvedValue> values_;
};

}  // namespace gsim::waterjet
