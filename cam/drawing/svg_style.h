#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace gsim::drawing {

/// The style sheets of an SVG file, limited to visibility: rules for elements, classes, ids and all (`path`,
/// `.hidden`, `path.hidden`, `#frame`, `*`, lists of them), the properties display and visibility.
class SvgStyles {
  public:
    /// Reads the text of the next <style> element.
    void add(std::string_view text);
    /// Returns the value of a property of an element: from its style attribute, else from the style sheets,
    /// else from the attribute of that name; empty if none sets it. Valid as long as the document and this
    /// object.
    std::string_view property(const pugi::xml_node& node, std::string_view name) const;
    /// Returns selectors with display or visibility that were not understood; the elements that they hide are
    /// drawn.
    const std::vector<std::string>& unsupported_selectors() const { return unsupported_selectors_; }

  private:
    /// A selector without relations: conditions for an element. Empty parts match any.
    struct Rule {
        std::string element, id;
        std::vector<std::string> classes;
        std::string property, value;
        int weight = 0;  ///< The heaviest matching rule counts, the later of equal ones.

        bool matches(const pugi::xml_node& node) const;
    };

    /// Returns nothing if the selector is not understood.
    static std::optional<Rule> parse_selector(std::string_view selector);
    void add_rule(std::string_view selectors, std::string_view declarations);

    std::vector<Rule> rules_;
    std::vector<std::string> unsupported_selectors_;
};

/// Returns an element's name without the prefix svg:.
std::string_view local_name(const pugi::xml_node& node);

}  // namespace gsim::drawing
