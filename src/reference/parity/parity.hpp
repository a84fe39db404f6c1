// Parity: every distance by tumble and by b2Distance, with exact arithmetic as the judge where they differ.
//
// An answer of tumble is *wrong* if the exact signed distance is outside [lower, upper], if the status contradicts its
// sign, if the distance, or 0 for "touching", is farther from the exact one than the stated error bound (wide bounds
// would prove nothing), or if the certificate does not prove the bounds. An answer of Box2D is wrong if its distance is
// more than 4 eps S from the exact one (clamped at 0), or if its overlap flag contradicts the exact sign; S is the
// largest world coordinate, eps that of float. A pair is *ill-conditioned* if the answers differ by more than that
// tolerance and neither is wrong. All pairs over the tolerance, the first pairs of each family, and a seeded share of
// the rest are checked exactly. Shapes with radii are compared twice, the bare cores first. Results do not depend on
// the number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/box2d/b2_distance.hpp"
#include "reference/query/pair_query.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene.hpp"

namespace tumble::reference {

inline constexpr double kFloatEpsilon = 0x1p-23;
inline constexpr double kParityTolerance = 4.0;  // in units of eps S; the worst error of an ordinary pair is 2.3

// The result of comparing both answers with the exact one.
enum class ParityVerdict : std::uint8_t { right, ours_wrong, box2d_wrong, both_wrong, ill_conditioned };
const char* to_string(ParityVerdict verdict);

// A comparison that reports show: wrong answers, and the largest errors of Box2D.
struct ParityCase {
    std::string family;
    std::uint64_t seed = 0;
    std::uint64_t index = 0;  // of the pair in its family; in a scene, of the comparison
    PairQuery query;          // as compared: the bare cores if the radii were left out
    DistanceResult ours;
    std::optional<B2Distance> box2d;
    double exact = 0.0;  // signed distance (m); for large cores the middle of the proved bounds
    double error_ours_m = 0.0;
    double error_box2d_m = 0.0;
    double error_box2d_eps = 0.0;   // in units of eps S
    bool box2d_wrong_flag = false;  // overlap reported for separated shapes, or the reverse
    double severity = 0.0;          // of Box2D's error: with a wrong flag at least |exact|, in units of eps S
    ParityVerdict verdict = ParityVerdict::right;
    std::string reason;  // what is wrong, such as "Box2D's distance, Box2D's witness points"
};

// Counts of |error| / S by half decades: bin i counts [10^(i/2 - 20), 10^((i + 1)/2 - 20)). The first bin also counts
// all smaller errors including 0, the last one all larger errors and NaN.
struct ErrorHistogram {
    static constexpr int kBins = 44;
    std::array<std::uint64_t, kBins> counts{};

    void add(double relative_error);
    static double lower_edge(int bin);
};

struct ParityRow {
    std::string name;
    std::uint64_t pairs = 0;
    std::uint64_t comparisons = 0;         // pairs; those with radii count twice
    std::uint64_t checked_exactly = 0;     // comparisons
    std::uint64_t ours_wrong = 0;          // comparisons, as above
    std::uint64_t ours_witness_wrong = 0;  // witness points off by 4 eps S, see witness_error()
    std::uint64_t box2d_wrong = 0;
    std::uint64_t box2d_wrong_flag = 0;      // of box2d_wrong: by the overlap flag
    std::uint64_t box2d_wrong_distance = 0;  // of box2d_wrong: by the distance
    std::uint64_t box2d_witness_wrong = 0;
    std::uint64_t box2d_refused = 0;  // not passed to Box2D: input beyond float, or a query that Box2D lacks
    std::uint64_t ill_conditioned = 0;
    double max_error_ours_m = 0.0;      // over what was checked exactly
    double max_error_ours_units = 0.0;  // of u (RA + RB + |p| + radii)
    double max_error_box2d_m = 0.0;     // over all comparisons; may be infinite
    double max_error_box2d_eps = 0.0;   // of eps S
    std::uint64_t iterations_ours = 0;  // sums over the comparisons
    std::uint64_t iterations_box2d = 0;
    int max_iterations_ours = 0;
    int max_iterations_box2d = 0;
    ErrorHistogram histogram_ours;  // over what was checked exactly
    ErrorHistogram histogram_box2d;
    std::vector<ParityCase> ours_failures;  // the first kKeptFailures
    std::vector<ParityCase> worst_box2d;    // kKeptWorst: wrong overlap flags first, then by severity

    static constexpr std::size_t kKeptFailures = 20;
    static constexpr std::size_t kKeptWorst = 4;

    bool is_among_worst(bool wrong_flag, double severity) const;
    void keep(ParityCase comparison);    // adds it to `ours_failures` and `worst_box2d` as they apply
    void merge(const ParityRow& later);  // a row of later pairs of the same family, or of another for a total
};

// The engine that tumble is compared with. The members of rows and cases that say `box2d` are about it.
enum class Opponent : std::uint8_t { box2d, box2d_v3 };

struct ParityOptions {
    Opponent opponent = Opponent::box2d;  // box2d_v3: only in a build with has_box2d_v3()
    std::uint64_t pairs = 1'000'000;
    std::uint64_t seed = 1;
    std::vector<std::string> families;            // names; empty: all
    std::uint64_t checked_first = 10'000;         // of each family
    double checked_share = 0.01;                  // of the rest
    int threads = 0;                              // 0: as many as the machine has
    std::function<void(std::uint64_t)> progress;  // pairs done so far; called from one thread at a time
};

struct ParityResult {
    std::uint64_t pairs = 0;
    std::uint64_t seed = 0;
    std::vector<ParityRow> families;  // in the order of the table
    double seconds = 0.0;             // wall clock

    ParityRow total() const;
    bool passed() const;  // no answer of tumble is wrong, witness points included
};

// Throws std::invalid_argument for a family that does not exist.
ParityResult run_parity(const ParityOptions& options);

// Runs the scene and compares every pair of shapes that the broad phase finds in every step. One row with the name of
// the scene. `steps` 0: the whole duration. The options `families` and `pairs` are ignored; the world runs in one
// thread.
ParityResult run_scene_parity(const Scene& scene, const ParityOptions& options, std::uint64_t steps = 0);

}  // namespace tumble::reference
