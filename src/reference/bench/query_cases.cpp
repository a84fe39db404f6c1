#include "reference/bench/query_cases.hpp"

#include "reference/bench/case_makers.hpp"

namespace tumble::reference {

std::vector<QueryCase> query_cases() {
    struct Row {
        const char* name;
        BenchKind a, b;
        double gap;
    };
    constexpr double kNear = 0.01, kFar = 3.0, kDeep = -0.05, kResting = -0.005;
    const Row distances[] = {{"circle-circle", BenchKind::circle, BenchKind::circle, kNear},
                             {"circle-box near", BenchKind::circle, BenchKind::box, kNear},
                             {"capsule-capsule near", BenchKind::capsule, BenchKind::capsule, kNear},
                             {"box-box far", BenchKind::box, BenchKind::box, kFar},
                             {"box-box near", BenchKind::box, BenchKind::box, kNear},
                             {"box-box overlapping", BenchKind::box, BenchKind::box, kDeep},
                             {"8-gon near", BenchKind::octagon, BenchKind::octagon, kNear},
                             {"8-gon overlapping", BenchKind::octagon, BenchKind::octagon, kDeep}};
    std::vector<QueryCase> cases;
    for (const Row& row : distances)
        for (const bool is_warm : {false, true})
            cases.push_back(distance_case(row.name, row.a, row.b, row.gap, is_warm));
    cases.push_back(batch_case("box-box near batch", BenchKind::box, kNear));
    cases.push_back(batch_case("8-gon near batch", BenchKind::octagon, kNear));
    for (const bool is_warm : {false, true}) {
        cases.push_back(manifold_case("manifold box-box", BenchKind::box, kResting, is_warm));
        cases.push_back(manifold_case("manifold 8-gon", BenchKind::octagon, kResting, is_warm));
    }
    cases.push_back(impact_case("time of impact circles", BenchKind::circle));
    cases.push_back(impact_case("time of impact boxes", BenchKind::box));
    cases.push_back(impact_case("time of impact 8-gons", BenchKind::octagon));
    cases.push_back(circle_ray_case("ray circle", BenchKind::circle));
    cases.push_back(polygon_ray_case("ray box", BenchKind::box));
    cases.push_back(polygon_ray_case("ray 8-gon", BenchKind::octagon));
    cases.push_back(distance_case("1000-gon near", BenchKind::large, BenchKind::large, kNear, false));
    return cases;
}

}  // namespace tumble::reference
