// What the families take from libraries that are not built for the other processor: Box2D's two lengths, and the
// families that choose their pairs by exact arithmetic, which are left out.
#include "reference/box2d/b2_cast.hpp"
#include "reference/families/family_lists.hpp"

namespace tumble::reference {

double b2_target(CastKind kind) {
    constexpr float kLinearSlop = 0.005f;
    return kind == CastKind::ray ? 0.0 : kind == CastKind::shape ? 2.0f * kLinearSlop : kLinearSlop;
}

std::span<const PairFamily> search_families() { return {}; }

}  // namespace tumble::reference
