// Scenes out of files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble {

// What an importer could not carry over: the feature and how often it occurred.
struct ImportNote {
    std::string feature;
    int count = 0;
};

struct ImportedScene {
    Scene scene;
    std::vector<ImportNote> notes;
};

struct SvgOptions {
    double metres_per_unit = 0.01;  // of a user unit: a page of 1280 x 720 is 12.8 m x 7.2 m
    double tolerance = 0.005;       // m: the largest distance of a curve from the chords that it becomes
};

// Reads an SVG drawing: each figure (rect, circle, ellipse, line, polyline, polygon, path, also by <use>) becomes a
// body of its own, in the order of drawing, named by its id and with a material of its colour. What has an area (closed
// and filled, or filled without a stroke) is dynamic, what is only a line is a static chain along its middle. A word
// decides otherwise: data-type="static", "dynamic" or "kinematic", a class of that name, or an id that begins with it,
// on the figure or on a group around it. A closed line that shall move is an area, an open one is made of capsules as
// thick as its stroke.
//
// The y axis is turned upwards; the origin is the lower left corner of the viewBox, or of width and height, and the
// camera shows that page. Concave areas are outlines; holes are filled in, and outlines that cross themselves replaced
// by their hull. The notes count that, and texts, images, gradients, clip paths and what else a world has no place for.
//
// Throws FileError, or SceneError with line and column for what is not XML or not SVG; std::invalid_argument for
// options that are not positive.
ImportedScene import_svg(const std::filesystem::path& file, const SvgOptions& options = {});
ImportedScene parse_svg(std::string_view text, const std::string& file_name, const SvgOptions& options = {});

// Reads a R.U.B.E. (b2dJson) export; the scene is called as the file. Throws FileError or SceneError.
ImportedScene import_rube(const std::filesystem::path& file);
ImportedScene parse_rube(std::string_view text, const std::string& file_name);

}  // namespace tumble
