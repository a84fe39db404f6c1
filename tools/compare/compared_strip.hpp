// The plots below a frame of a comparison, with the time of the frame.
#pragma once

#include <vector>

#include "tools/compare/compared_runs.hpp"
#include "tools/output/plot.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// The distance of both runs and their energies: beside each other, or one below the other.
class ComparedStrip {
public:
    // The runs must have a step. Throws RenderError.
    ComparedStrip(const ComparedRuns& runs, int width, int columns);

    // With a line at that time (s).
    Image at(double time) const;

    static int height(int columns);  // px

private:
    std::vector<Plot> plots_;
    std::vector<Image> images_;
    double left_;
    int columns_;
};

}  // namespace tumble::tools
