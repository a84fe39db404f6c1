#include "import/svg/svg_holes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tumble::scene {

namespace {

constexpr std::size_t kMostPieces = 2000;

struct Region {
    Ring outer;
    std::vector<Ring> holes;
};

// A part of a ring on one side of the cut, between two of its crossings.
struct Chain {
    Ring points;
    std::size_t from = 0, to = 0;  // crossings, in the order of y
};

double rounded(double value) { return double{static_cast<float>(value)}; }

// The x of a cut through the ring: the float in the middle of the widest gap between its corners that is not the x of
// any corner of the region.
std::optional<double> find_cut(const Ring& ring, const Region& region) {
    std::vector<double> xs;
    for (const DVec2 point : ring) xs.push_back(point.x);
    std::ranges::sort(xs);
    double widest = 0.0, cut = 0.0;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        if (!(xs[i + 1] - xs[i] > widest)) continue;
        widest = xs[i + 1] - xs[i];
        cut = rounded(0.5 * (xs[i] + xs[i + 1]));
    }
    const auto has_corner_at = [](const Ring& other, double x) {
        return std::ranges::find(other, x, &DVec2::x) != other.end();
    };
    const auto is_taken = [&](double x) {
        return has_corner_at(region.outer, x) ||
               std::ranges::any_of(region.holes, [&](const Ring& hole) { return has_corner_at(hole, x); });
    };
    for (int tries = 0; tries < 100 && is_taken(cut); ++tries)
        cut = double{std::nextafter(static_cast<float>(cut), static_cast<float>(xs.back()))};
    if (!(cut > xs.front() && cut < xs.back()) || is_taken(cut)) return std::nullopt;
    return cut;
}

class Cut {
public:
    explicit Cut(double x) : x_(x) {}

    // The pieces on both sides; nothing if the rings cross.
    std::optional<std::vector<Region>> split(const Region& region) {
        add(region.outer);
        for (const Ring& hole : region.holes) add(hole);
        if (!number_crossings()) return std::nullopt;
        std::vector<Region> pieces;
        for (const bool is_left : {true, false})
            if (!join(is_left, pieces)) return std::nullopt;
        for (Ring& hole : whole_) {
            const auto around = std::ranges::find_if(
                pieces, [&](const Region& piece) { return winding_number(piece.outer, hole.front()) != 0; });
            if (around == pieces.end()) return std::nullopt;
            around->holes.push_back(std::move(hole));
        }
        return pieces;
    }

private:
    bool is_left(DVec2 point) const { return point.x < x_; }

    // Where the edge crosses the cut.
    DVec2 crossing(DVec2 a, DVec2 b) const { return {x_, rounded(a.y + (x_ - a.x) / (b.x - a.x) * (b.y - a.y))}; }

    // Divides the ring into chains. A ring that does not cross the cut is a hole, as the outer ring is around one.
    void add(const Ring& ring) {
        const std::size_t size = ring.size();
        std::size_t start = 0;
        while (start < size && is_left(ring[start]) == is_left(ring[(start + size - 1) % size])) ++start;
        if (start == size) {
            whole_.push_back(ring);
            return;
        }
        for (std::size_t i = 0; i < size; ++i) {
            const DVec2 before = ring[(start + i + size - 1) % size], point = ring[(start + i) % size];
            if (is_left(before) != is_left(point)) {
                const DVec2 at = crossing(before, point);
                if (i > 0) chains_.back().points.push_back(at);
                chains_.push_back({{at}});
            }
            chains_.back().points.push_back(point);
        }
        chains_.back().points.push_back(crossing(ring[(start + size - 1) % size], ring[start]));
    }

    // Numbers the ends of the chains on the cut in the order of y. The crossings 2k and 2k + 1 bound the inside.
    bool number_crossings() {
        std::vector<double> ys;
        for (const Chain& chain : chains_) ys.push_back(chain.points.front().y);
        std::ranges::sort(ys);
        if (ys.size() % 2 != 0 || std::ranges::adjacent_find(ys) != ys.end()) return false;
        const auto number = [&](double y) {
            return static_cast<std::size_t>(std::ranges::lower_bound(ys, y) - ys.begin());
        };
        for (Chain& chain : chains_) {
            chain.from = number(chain.points.front().y);
            chain.to = number(chain.points.back().y);
        }
        return true;
    }

    // Joins the chains of one side along the cut. False if the crossings do not pair.
    bool join(bool left, std::vector<Region>& pieces) {
        std::vector<const Chain*> of_start(chains_.size(), nullptr);
        for (const Chain& chain : chains_)
            if (is_left(chain.points[1]) == left) of_start[chain.from] = &chain;
        for (std::size_t first = 0; first < of_start.size(); ++first) {
            Ring ring;
            for (std::size_t at = first; of_start[at] != nullptr;) {
                const Chain& chain = *std::exchange(of_start[at], nullptr);
                ring.insert(ring.end(), chain.points.begin(), chain.points.end());
                at = chain.to ^ std::size_t{1};
                if (at == first) break;
                if (of_start[at] == nullptr) return false;
            }
            if (ring.empty()) continue;
            if (!(twice_area_of(ring) > 0.0)) return false;
            pieces.push_back({std::move(ring), {}});
        }
        return true;
    }

    double x_;
    std::vector<Chain> chains_;
    std::vector<Ring> whole_;
};

}  // namespace

double twice_area_of(const Ring& ring) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[i] - ring.front(), ring[i + 1] - ring.front());
    return sum;
}

int winding_number(const Ring& ring, DVec2 point) {
    int turns = 0;
    DVec2 from = ring.back();
    for (const DVec2 to : ring) {
        const double side = cross(to - from, point - from);
        if (from.y <= point.y && to.y > point.y && side > 0.0) ++turns;
        if (to.y <= point.y && from.y > point.y && side < 0.0) --turns;
        from = to;
    }
    return turns;
}

std::optional<std::vector<Ring>> cut_open(const Ring& outer, const std::vector<Ring>& holes) {
    std::vector<Region> open{{outer, holes}};
    std::vector<Ring> done;
    while (!open.empty()) {
        Region region = std::move(open.back());
        open.pop_back();
        if (region.holes.empty()) {
            done.push_back(std::move(region.outer));
            continue;
        }
        const std::optional<double> x = find_cut(region.holes.front(), region);
        std::optional<std::vector<Region>> pieces = x ? Cut(*x).split(region) : std::nullopt;
        if (!pieces || open.size() + done.size() + pieces->size() > kMostPieces) return std::nullopt;
        std::ranges::move(*pieces, std::back_inserter(open));
    }
    return done;
}

}  // namespace tumble::scene
