#include "narrow/cast/cast_chain.hpp"

#include "debug/check.hpp"

namespace tumble {

namespace {

// The direction of the chain at its start; any would do.
constexpr DVec2 kFirstHeading{1.0, 0.0};

}  // namespace

void DifferenceChain::Fan::skip_to_edge() {
    for (; left > 0; --left, vertex = core->next(vertex)) {
        edge = sign * core->edge(vertex, core->next(vertex));
        if (edge != DVec2{}) return;
    }
}

void DifferenceChain::Fan::advance() {
    TUMBLE_CHECK(left > 0);
    --left;
    vertex = core->next(vertex);
    skip_to_edge();
}

DifferenceChain::Fan DifferenceChain::make_fan(const Core& core, double sign) {
    const DVec2 outwards = -perp(kFirstHeading);
    Fan fan{&core, sign, support(core, sign * outwards).index, core.count > 1 ? core.count : 0, {}};
    fan.skip_to_edge();
    return fan;
}

DifferenceChain::DifferenceChain(const CorePair& pair)
    : pair_(pair),
      a_(make_fan(pair.a, 1.0)),
      b_(make_fan(pair.b, -1.0)),
      heading_(kFirstHeading),
      current_(vertex()),
      is_point_(a_.left + b_.left == 0) {}

MinkowskiVertex DifferenceChain::vertex() const {
    return minkowski_vertex(pair_, {static_cast<std::uint16_t>(a_.vertex), static_cast<std::uint16_t>(b_.vertex)});
}

// Both next edges turn by less than half a turn from the heading. An edge in the first quarter turn comes before one in
// the second; within a quarter the cross product decides, which would fail for edges that point exactly against each
// other.
bool DifferenceChain::takes(const Fan& fan, const Fan& other) const {
    if (fan.left == 0) return false;
    if (other.left == 0) return true;
    TUMBLE_CHECK(fan.edge != DVec2{});
    const bool is_near = dot(heading_, fan.edge) > 0.0, is_other_near = dot(heading_, other.edge) > 0.0;
    if (is_near != is_other_near) return is_near;
    return cross(fan.edge, other.edge) >= 0.0;
}

bool DifferenceChain::next(ChainFace& face) {
    if (is_point_) {
        is_point_ = false;
        face = {current_, current_, {}};
        return true;
    }
    const bool takes_a = takes(a_, b_), takes_b = takes(b_, a_);
    if (!takes_a && !takes_b) return false;
    face.from = current_;
    face.edge = (takes_a ? a_.edge : DVec2{}) + (takes_b ? b_.edge : DVec2{});
    heading_ = face.edge;
    if (takes_a) a_.advance();
    if (takes_b) b_.advance();
    face.to = current_ = vertex();
    return true;
}

}  // namespace tumble
