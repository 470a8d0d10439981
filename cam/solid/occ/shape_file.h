#pragma once

#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_Reader.hxx>
#include <memory>
#include <string>

#include "base/error.h"

namespace gsim::solid {

/// The shapes of a STEP or IGES file, in mm.
class ShapeFile {
  public:
    /// Reads a file. OpenCASCADE's exceptions (Standard_Failure) pass through, and it
    /// may crash.
    static Result<ShapeFile> read(const std::string& name);

    const TopoDS_Shape& shape() const { return shape_; }
    /// Returns the file's name of a shape: "#57" in STEP, "D57" in IGES; empty if it is not known.
    std::string label(const TopoDS_Shape& shape) const;
    /// Returns true if `name` is a shape's label, its name in the file, the name of its layer, or its colour
    /// (STEP).
    bool matches_name(const TopoDS_Shape& shape, const std::string& name) const;

  private:
    ShapeFile() = default;
    void index_entities();
    /// Returns the number in the model; null: it is not known.
    const int* entity_number(const TopoDS_Shape& shape) const;

    std::unique_ptr<XSControl_Reader> reader_;
    TopoDS_Shape shape_;
    TopTools_DataMapOfShapeInteger entities_;  // numbers in the model
};

}  // namespace gsim::solid
