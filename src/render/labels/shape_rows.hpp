// The pixels whose centres a shape contains, row by row.
//
// A row meets a convex shape in one interval. Its ends are found from the edges of the core, moved outwards by the
// radius, and from the circles about its vertices: no chords, and no test for each pixel.
#pragma once

#include <vector>

#include "render/view/view.hpp"
#include "tumble/shape.hpp"

namespace tumble::render {

// Columns of one row, both ends included.
struct RowSpan {
    int row = 0;
    int first = 0;
    int last = -1;
};

// Finds the spans of shapes; keeps its buffers between them.
class ShapeRows {
public:
    // Appends the spans in the frame, in the order of rows. `line_width` (pixels) is that of a shape without area.
    void add(std::vector<RowSpan>& spans, const View& view, const Shape& shape, const Pose& pose, double line_width);

private:
    struct Interval {
        double from, to;
    };

    void meet_edge(DVec2 a, DVec2 b);
    void meet_circle(DVec2 center, double radius);
    void meet(int row, double column);
    template <class Meet>
    void for_rows(double top, double bottom, Meet&& meet_row);

    std::vector<DVec2> core_;          // in columns and rows of the frame
    std::vector<Interval> intervals_;  // of the rows from first_row_ on
    int first_row_ = 0;
};

}  // namespace tumble::render
