#include "cam/solid/occ/shape_file.h"

#include <IGESControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopLoc_Location.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "cam/solid/occ/file_check.h"
#include "cam/solid/occ/step_item.h"

namespace gsim::solid {

namespace {

constexpr std::size_t kMaxSolidBytes = std::size_t{256} << 20U;  // as in the calling program

// Returns an OpenCASCADE error of an entity. OpenCASCADE would continue without the entity, so a part of the
// body would be missing.
Result<void> check(const Interface_CheckIterator& list, const Interface_InterfaceModel& model) {
    for (list.Start(); list.More(); list.Next()) {
        const Handle(Interface_Check)& found = list.Value();
        if (!found->HasFailed()) continue;
        const int number = list.Number();
        const std::string where =
            number > 0 && number <= model.NbEntities()
                ? fmt::format("{}: ", model.StringLabel(model.Value(number))->ToCString())
                : std::string();
        const std::string_view what = found->CFail(1);
        // OpenCASCADE reads its texts from files that may not be installed.
        const bool has_text = what.find("Unknown message") == std::string_view::npos;
        return Unexpected(fmt::format("{}{}", where, has_text ? what : "this entity is damaged"));
    }
    return {};
}

}  // namespace

Result<ShapeFile> ShapeFile::read(const std::string& name) {
    const FileFormat format = format_by_name(name);
    const auto text = os::read_input(name, os::NameSource::in_file, kMaxSolidBytes);
    if (!text) return Unexpected(text.error());
    if (auto error = find_file_error(*text, format)) return tl::unexpected(*std::move(error));
    ShapeFile file;
    if (format == FileFormat::step) {
        file.reader_ = std::make_unique<STEPControl_Reader>();
    } else {
        file.reader_ = std::make_unique<IGESControl_Reader>();
    }
    XSControl_Reader& reader = *file.reader_;
    if (reader.ReadFile(name.c_str()) != IFSelect_RetDone || reader.Model().IsNull())
        return Unexpected(
            fmt::format("this is not a complete {} file", format == FileFormat::step ? "STEP" : "IGES"));
    const Interface_InterfaceModel& model = *reader.Model();
    if (auto checked = check(reader.WS()->ModelCheckList(), model); !checked)
        return Unexpected(checked.error());
    reader.TransferRoots();
    if (auto checked = check(reader.WS()->TransferReader()->LastCheckList(), model); !checked)
        return Unexpected(checked.error());
    if (reader.NbShapes() < 1) return Unexpected("it contains no body, surface or curve");
    file.shape_ = reader.OneShape();
    file.index_entities();
    return file;
}

// Listed once, because OpenCASCADE would search through all of them for each shape.
void ShapeFile::index_entities() {
    const Handle(Transfer_TransientProcess) transfer = reader_->WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= transfer->NbMapped(); ++i) {
        const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer->MapItem(i));
        const int number = reader_->Model()->Number(transfer->Mapped(i));
        if (!shape.IsNull() && number > 0) entities_.Bind(shape, number);
    }
}

// In an assembly a shape of the file has other positions, perhaps several.
const int* ShapeFile::entity_number(const TopoDS_Shape& shape) const {
    const int* number = entities_.Seek(shape);
    return number != nullptr ? number : entities_.Seek(shape.Located(TopLoc_Location()));
}

std::string ShapeFile::label(const TopoDS_Shape& shape) const {
    const int* number = entity_number(shape);
    if (number == nullptr) return {};
    return reader_->Model()->StringLabel(reader_->Model()->Value(*number))->ToCString();
}

bool ShapeFile::matches_name(const TopoDS_Shape& shape, const std::string& name) const {
    const int* number = entity_number(shape);
    if (number == nullptr || name.empty()) return false;
    if (label(shape) == name) return true;
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(reader_->Model()->Value(*number));
    return !item.IsNull() && solid::matches_name(reader_->WS(), item, name);
}

}  // namespace gsim::solid
