// The boundary of the Minkowski difference A - B as one closed chain, by walking both edge fans in angular order.
//
// Each step consumes the edge of A or the (negated) edge of B that turns less; parallel ones together, so that the
// chain does not depend on the order of the shapes. O(n + m), and nothing is stored: the faces are generated one by
// one. Consecutive faces share their vertex bit for bit, so that tests on the signs at vertices leave no gap between
// faces.
#pragma once

#include "narrow/cores/support.hpp"

namespace tumble {

// A face of A - B, or a vertex alone (edge zero) if both cores are points.
struct ChainFace {
    MinkowskiVertex from;
    MinkowskiVertex to;
    DVec2 edge;  // to - from, from local coordinates: relatively accurate however short; A - B lies on its left
};

class DifferenceChain {
public:
    explicit DifferenceChain(const CorePair& pair);

    // False after the last face. A chain has at least one.
    bool next(ChainFace& face);

private:
    // The edges of one core that are left, the next one in the direction of the chain.
    struct Fan {
        const Core* core;
        double sign;
        int vertex;
        int left;  // edges not consumed yet
        DVec2 edge;

        void skip_to_edge();  // skips edges without length
        void advance();
    };

    static Fan make_fan(const Core& core, double sign);
    bool takes(const Fan& fan, const Fan& other) const;
    MinkowskiVertex vertex() const;

    const CorePair& pair_;
    Fan a_;
    Fan b_;
    DVec2 heading_;  // of the last edge consumed
    MinkowskiVertex current_;
    bool is_point_;
};

}  // namespace tumble
