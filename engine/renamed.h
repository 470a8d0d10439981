#pragma once

#include "engine/columns.h"
#include "engine/contour_list.h"
#include "engine/controller_settings.h"
#include "engine/drawing_path.h"
#include "engine/file_keys.h"
#include "engine/findings.h"
#include "engine/machine_data.h"
#include "engine/machine_errors.h"
#include "engine/motion.h"
#include "engine/plate.h"
#include "engine/pose.h"
#include "engine/request.h"
#include "engine/run.h"

/// Names of types and functions of version 0.1, for programs that are moved to 0.2. Members have new names,
/// too; CHANGELOG.md lists them. This header is removed in 0.3.
namespace gsim::engine {

using Failure [[deprecated("use Error")]] = Error;
using Tell [[deprecated("use DiagnosticHandler")]] = DiagnosticHandler;
using TakeMoves [[deprecated("use MovesHandler")]] = MovesHandler;
using TakeSegments [[deprecated("use SegmentsHandler")]] = SegmentsHandler;
using TakeSamples [[deprecated("use SamplesHandler")]] = SamplesHandler;
using TakeColumns [[deprecated("use ColumnsHandler")]] = ColumnsHandler;
using TakeEfforts [[deprecated("use EffortsHandler")]] = EffortsHandler;
using TakeFollowing [[deprecated("use FollowingHandler")]] = FollowingHandler;
using Document [[deprecated("use OutputKind")]] = OutputKind;
using DocumentOptions [[deprecated("use OutputOptions")]] = OutputOptions;
using LanguageChoice [[deprecated("use LanguageOptions")]] = LanguageOptions;
using OverrideChoice [[deprecated("use OverrideOptions")]] = OverrideOptions;
using SharedLibrary [[deprecated("use CompiledLuaLibrary")]] = CompiledLuaLibrary;
using Place [[deprecated("use SourceLocation")]] = SourceLocation;
using PoseChoice [[deprecated("use PoseRequest")]] = PoseRequest;
using PlateChoice [[deprecated("use PlateReadOptions")]] = PlateReadOptions;
using ContourChoice [[deprecated("use ContourSelection")]] = ContourSelection;
using DrawingChoice [[deprecated("use DrawingOptions")]] = DrawingOptions;
using CuttingChoice [[deprecated("use CuttingOptions")]] = CuttingOptions;
using CuttingWays [[deprecated("use CuttingPathOptions")]] = CuttingPathOptions;
using CuttingPlace [[deprecated("use CuttingCellOptions")]] = CuttingCellOptions;
using CuttingFigures [[deprecated("use CuttingMetrics")]] = CuttingMetrics;
using JobFigures [[deprecated("use JobMetrics")]] = JobMetrics;
using SurfaceChoice [[deprecated("use SurfaceCuttingOptions")]] = SurfaceCuttingOptions;
using ControlSettings [[deprecated("use ControllerSettings")]] = ControllerSettings;
using KeyedFile [[deprecated("use ConfigFileKind")]] = ConfigFileKind;

inline constexpr std::size_t kMostAxes [[deprecated("use kMaxAxes")]] = kMaxAxes;

}  // namespace gsim::engine
