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
#include "cam/solid/occ/file_frame.h"
#include "cam/solid/occ/step_item.h"

namespace gsim::solid {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr std::size_t kMaxSolidBytes = std::size_t{256} << 20U;  // as in the calling program

// Returns an OpenCASCADE error of an entity. OpenCASCADE would continue without the entity, so a part of the
// body would be missing.
tl::expected<void, std::string> check(const Interface_CheckIterator& list,
                                      const Interface_InterfaceModel& model) {
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
        return Fault(fmt::format("{}{}", where, has_text ? what : "this entity is damaged"));
    }
    return {};
}

}  // namespace

tl::expected<ShapeFile, std::string> ShapeFile::read(const std::string& name) {
    const FileFormat format = format_by_name(name);
    const auto text = os::read_input(name, os::NamedBy::a_file, kMaxSolidBytes);
    if (!text) return Fault(text.error());
    if (auto fault = find_frame_fault(*text, format)) return Fault(std::move(*fault));
    ShapeFile file;
    if (format == FileFormat::step) {
        file.reader_ = std::make_unique<STEPControl_Reader>();
    } else {
        file.reader_ = std::make_unique<IGESControl_Reader>();
    }
    XSControl_Reader& reader = *file.reader_;
    if (reader.ReadFile(name.c_str()) != IFSelect_RetDone || reader.Model().IsNull())
        return Fault(fmt::format("this is no whole {} file", format == FileFormat::step ? "STEP" : "IGES"));
    const Interface_InterfaceModel& model = *reader.Model();
    if (auto good = check(reader.WS()->ModelCheckList(), model); !good) return Fault(good.error());
    reader.TransferRoots();
    if (auto good = check(reader.WS()->TransferReader()->LastCheckList(), model); !good)
        return Fault(good.error());
    if (reader.NbShapes() < 1) return Fault("there is no body, surface or curve in it");
    file.shape_ = reader.OneShape();
    file.list_entities();
    return file;
}

// Listed once, because OpenCASCADE would search through all of them for each shape.
void ShapeFile::list_entities() {
    const Handle(Transfer_TransientProcess) transfer = reader_->WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= transfer->NbMapped(); ++i) {
        const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer->MapItem(i));
        const int number = reader_->Model()->Number(transfer->Mapped(i));
        if (!shape.IsNull() && number > 0) entities_.Bind(shape, number);
    }
}

// In an assembly a shape of the file has other positions, perhaps several.
const int* ShapeFile::number_of(const TopoDS_Shape& shape) const {
    const int* number = entities_.Seek(shape);
    return number != nullptr ? number : entities_.Seek(shape.Located(TopLoc_Location()));
}

std::string ShapeFile::label(const TopoDS_Shape& shape) const {
    const int* number = number_of(shape);
    if (number == nullptr) return {};
    return reader_->Model()->StringLabel(reader_->Model()->Value(*number))->ToCString();
}

bool ShapeFile::goes_by(const TopoDS_Shape& shape, const std::string& name) const {
    const int* number = number_of(shape);
    if (number == nullptr || name.empty()) return false;
    if (label(shape) == name) return true;
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(reader_->Model()->Value(*number));
    return !item.IsNull() && solid::goes_by(reader_->WS(), item, name);
}

}  // namespace gsim::solid
