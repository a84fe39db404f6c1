// Importers: scenes made from the files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace tumble {

// What an importer could not carry over: the feature, how often it occurred, and where first: "body 'wheel'".
struct ImportNote {
    static constexpr std::size_t kMostOwners = 3;

    std::string feature;
    int count = 0;
    std::vector<std::string> owners{};  // up to kMostOwners, each once; none if the feature is of the whole file
};

struct ImportedScene {
    Scene scene;
    std::vector<ImportNote> notes;
    std::vector<Diagnostic> warnings{};  // values of the file that were replaced, with their line and column
};

struct SvgOptions {
    // Metres for a pixel of the page, which is 1/96 inch: a page of 1280 x 720 becomes 12.8 m x 7.2 m, and A4 7.94 m x
    // 11.2 m, whatever the units of its width, height and viewBox. 0.0254 / 96 keeps the size that is printed.
    double metres_per_pixel = 0.01;
    double tolerance = 0.005;  // m: the largest distance between a curve and the chords that replace it
};

// Imports an SVG drawing. Each figure (rect, circle, ellipse, line, polyline, polygon, path, also through <use>)
// becomes one body, in the order of drawing, with the figure's label (inkscape:label) or id as its name and a material
// of its colour: a transparent colour as it looks on white paper. A figure with an area (closed and filled, or filled
// without a stroke) is dynamic; a figure that is only a line is a static chain along its middle. The attribute
// data-type="static", "dynamic" or "kinematic", a class of that name, or a label or id that begins with it, on the
// figure or on a group around it, overrides that. A closed line that is not static is treated as an area; an open one
// becomes capsules as thick as its stroke.
//
// The y axis points upwards. The origin is the lower left corner of the viewBox, or of width and height. The scene
// states no camera. Concave areas become outlines, and areas with holes several polygons or outlines; an outline that
// crosses itself becomes its hull. The notes count these, and texts, images, gradients, clip paths and other elements
// that a scene cannot express.
//
// Throws FileError, SceneError with line and column for text that is not XML or not SVG, and std::invalid_argument for
// options that are not positive.
ImportedScene import_svg(const std::filesystem::path& file, const SvgOptions& options = {});
ImportedScene parse_svg(std::string_view text, const std::string& file_name, const SvgOptions& options = {});

// Imports a R.U.B.E. (b2dJson) export. The scene has the name of the file. A dynamic body whose moment of inertia is
// less than a mass point at its centre of mass would have gets that of its shapes, with a warning. Throws FileError or
// SceneError.
ImportedScene import_rube(const std::filesystem::path& file);
ImportedScene parse_rube(std::string_view text, const std::string& file_name);

// The JSON of a R.U.B.E. export, which may have comments. The wrapper of a JavaScript file that assigns the scene to a
// variable, "var name = {...};", becomes blanks, so that lines and columns stay.
std::string rube_json(std::string_view text);

}  // namespace tumble
