#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "cam/drawing/drawing.h"

namespace gsim::drawing {

/// Group codes and values as in a DXF file.
using Groups = std::initializer_list<std::pair<int, std::string>>;

std::string groups(Groups list);
/// Returns a DXF file with these entities; `before` is inserted in front of their section.
std::string dxf_of(const std::string& entities, const std::string& before = {});
std::string section(const std::string& name, const std::string& content);

/// Returns the areas of the closed contours of a drawing, the smallest first, all above 0. Fails if one stays
/// open.
std::vector<double> areas_of(const Drawing& drawing);

Drawing dxf_drawing(const std::string& text, const ReadOptions& options = {});
Drawing svg_drawing(const std::string& text, const ReadOptions& options = {});
/// Returns the error message of a drawing that cannot be read; fails if it can.
std::string dxf_fault(const std::string& text);
std::string svg_fault(const std::string& text);

}  // namespace gsim::drawing
